"""Published numbers: the tables of the thesis (results/published/thesis.json), and methods that cannot
be run here (results/published/methods.json). Both files cite their sources."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from typing import Any

from .console import ROOT
from .reader import ResultError

FILE = ROOT / "results" / "published" / "thesis.json"
METHODS = FILE.with_name("methods.json")

THESIS_SOLVERS = ["mmp", "fwp-mmp", "ich", "fwp-ch", "edge-based"]
"""The columns of Table 5.2, in its order."""
APPENDIX = {"edge-based": "A.1", "mmp": "A.2", "fwp-mmp": "A.3", "ich": "A.4", "fwp-ch": "A.5"}
"""The number of the appendix's figure that shows a solver's wavefront, by solver."""

Published = float | str | None
"""A number, or a text such as "out of memory", or None if the thesis has neither."""


@cache
def _tables() -> Any:
    return json.loads(FILE.read_text(encoding="utf-8"))


def citation() -> str:
    return str(_tables()["source"])


def machine() -> str:
    return str(_tables()["machine"])


def models() -> list[str]:
    """Returns the models of the thesis in the order of its tables."""
    return [row["model"] for row in _tables()["table_5_2"]]


def table_5_1(model: str) -> dict[str, Any]:
    """Returns `vertices`, `log_b_n` and `b` of a model."""
    return _of_model("table_5_1", model)


def table_5_2(model: str) -> dict[str, Any]:
    """Returns `vertices`, `faces`, and values by solver for each measure of Table 5.2."""
    return _of_model("table_5_2", model)


def measure(model: str | None, name: str, solver: str) -> Published:
    """Returns one cell of Table 5.2: `name` is time_s, space_mb, window_propagations, valid_windows,
    peak_wavefront, or window_limit (which is the same for every solver)."""
    if model is None:
        return None
    value = table_5_2(model).get(name)
    return value.get(solver) if isinstance(value, dict) else value


def table_5_3() -> dict[str, dict[str, Any]]:
    """Returns the rows of Table 5.3 by solver."""
    return {row["method"]: row for row in _tables()["table_5_3"]}


@dataclass(frozen=True)
class Claim:
    """A statement of the thesis's text about a ratio (see plots/ratios.py)."""

    claim: str
    where: str
    ratio: str
    solvers: list[str]
    value: str


def claims() -> list[Claim]:
    return [Claim(**claim) for claim in _tables()["claims"]]


@dataclass(frozen=True)
class Method:
    """The published measurement of a method that cannot be run here, on one mesh."""

    method: str
    source: str
    vertices: int
    time_s: float
    mean_relative_error: float
    beside: str
    """A solver that can be run here and that the authors measured on the same mesh and machine."""
    beside_time_s: float


def methods() -> list[Method]:
    return [Method(**method) for method in json.loads(METHODS.read_text(encoding="utf-8"))]


def _of_model(table: str, model: str) -> dict[str, Any]:
    for row in _tables()[table]:
        if row["model"] == model:
            return dict(row)
    raise ResultError(f"{model!r} is not a model of the thesis; its models: {', '.join(models())}")
