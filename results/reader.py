"""The one reader of result files: validates them and gives typed rows.

Reads run.json, or one file of cells/, as described by results/README.md, of ordinary and of
interleaved runs. Every fault of a file is a ResultError of one line with the file and the key.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import jsonschema

from .console import ROOT, printable

SCHEMA = ROOT / "results" / "run.schema.json"
RUNS = ROOT / "results" / "runs"

OK = "ok"
ERRORS = (
    "max_relative_error", "mean_relative_error", "rms_relative_error", "p99_relative_error",
    "unreachable_mismatches",
)  # fmt: skip
CLOSED_FORM = "closed-form"
"""The reference of rows whose distances were compared with a formula, not with another solver."""


class ResultError(ValueError):
    """A result file that cannot be used; its message is one line."""


@dataclass(frozen=True)
class Mesh:
    name: str
    sha256: str
    vertices: int
    faces: int
    mean_edge_length: float
    thesis_model: str | None
    stand_in: bool
    why: str = ""
    """It is in the corpus."""
    reports: tuple[str, ...] = ()
    """Addresses of reports by users of other codes on such a mesh."""

    @property
    def label(self) -> str:
        """The name, and what it stands for: "dragon-res2 (stand-in for lucy)"."""
        return f"{self.name} (stand-in for {self.thesis_model})" if self.stand_in else self.name


@dataclass(frozen=True)
class Solver:
    name: str
    family: str
    paper: str
    data_structure: str
    time_complexity: str
    space_complexity: str
    propagation: str
    spatial_order: bool
    exact: bool
    independent_oracle: bool
    remarks: str
    exactness: str = "exact"
    """Or "bounded", "upper_bound", "unbounded"."""
    error_bound: float | None = None
    """Relative, of a bounded solver."""
    values: dict[str, float | str] = field(default_factory=dict)
    """Of all its parameters, by their names."""

    @property
    def base(self) -> str:
        """The name without parameters."""
        return self.name.split("?")[0]

    @property
    def promise(self) -> str:
        """What is known of its distances: "exact", "within 0.01", "upper bound", "unbounded"."""
        if self.exactness == "bounded":
            return f"within {self.error_bound:g}"
        return self.exactness.replace("_", " ")


@dataclass(frozen=True, order=True)
class Cell:
    """A solver on a mesh from a source vertex."""

    solver: str
    mesh: str
    source: int

    def __str__(self) -> str:
        return f"{self.solver}/{self.mesh}/src:{self.source}"


@dataclass(frozen=True)
class Row:
    """One repetition of one cell, or the one row of a cell that failed."""

    solver: str
    mesh: str
    source: int
    repetition: int
    outcome: str
    message: str
    reference: str | None
    numbers: dict[str, float]
    """Every number of the row by its key in the file, those of an object as
    "phase_seconds.queue"; unless the outcome is ok, those of ERRORS alone, which a wrong answer
    has. Times are in milliseconds."""
    recordings: str | None = None
    """Folder of the solver's recordings, relative to the run folder."""
    program: str | None = None
    """Of an interleaved run with several programs: the label of the one that was timed."""
    data: dict[str, Any] = field(default_factory=dict, repr=False, compare=False)
    """The row as it is in the file."""

    @property
    def ok(self) -> bool:
        return self.outcome == OK

    @property
    def time(self) -> float:
        """Of one solve in milliseconds, what tables and verdicts go by: of the CPU, and of the wall
        where several threads share the work. @raises KeyError for a row that is not ok"""
        several = self.numbers.get("threads", 1) > 1
        return self.numbers["real_time" if several else "cpu_time"]

    @property
    def cell(self) -> Cell:
        return Cell(self.solver, self.mesh, self.source)

    @property
    def against_truth(self) -> bool:
        return self.reference == CLOSED_FORM


@dataclass(frozen=True)
class Skip:
    mesh: str
    solver: str | None
    why: str


@dataclass(frozen=True)
class Run:
    file: Path
    context: dict[str, Any]
    meshes: dict[str, Mesh]
    solvers: dict[str, Solver]
    sources: dict[str, list[int]]
    skipped: list[Skip]
    rows: list[Row]

    @property
    def ours(self) -> dict[str, Any]:
        """The part of the context that is geodesic-bench's own."""
        found: dict[str, Any] = self.context["geodesic_bench"]
        return found

    @property
    def of_plugins(self) -> set[str]:
        """Solvers that plug-ins brought, such as public codes, without parameters."""
        plugins = self.context.get("geodesic_bench", {}).get("plugins", [])
        return {solver for plugin in plugins for solver in plugin["solvers"]}

    @property
    def interleaved(self) -> bool:
        """Whether rows of one mesh, source and repetition are neighbours in time."""
        return bool(self.ours.get("interleaved", False))

    def cell(self, mesh: str, solver: str) -> list[Row]:
        """The rows of one solver on one mesh, over all sources, in the file's order."""
        return [row for row in self.rows if row.mesh == mesh and row.solver == solver]

    def cells(self, program: str | None = None) -> dict[Cell, list[Row]]:
        """The rows by cell, in the file's order.

        @param program its rows only; None: those of every program"""
        found: dict[Cell, list[Row]] = {}
        for row in self.rows:
            if program is None or row.program == program:
                found.setdefault(row.cell, []).append(row)
        return found

    def of_meshes(self, names: Sequence[str]) -> Run:
        """The same run with these meshes only. @raises ResultError for one that it does not have"""
        for name in names:
            if name not in self.meshes:
                raise ResultError(f"{self.file}: no mesh {name!r}; it has {', '.join(self.meshes)}")
        return replace(
            self,
            meshes={name: mesh for name, mesh in self.meshes.items() if name in names},
            skipped=[skip for skip in self.skipped if skip.mesh in names],
            rows=[row for row in self.rows if row.mesh in names],
        )

    @property
    def not_measured(self) -> list[Skip]:
        """Meshes that were skipped whole."""
        return [skip for skip in self.skipped if skip.solver is None]

    def skip(self, mesh: str, solver: str) -> Skip | None:
        """The reason if the run skipped this solver on this mesh."""
        return next(
            (s for s in self.skipped if s.mesh == mesh and s.solver in (None, solver)), None
        )


def read_run(path: Path) -> Run:
    """@param path a run folder with a run.json in it, or a result file
    @raises ResultError as read_file does"""
    return read_file(path if path.is_file() else run_folder(path) / "run.json")


def run_folder(path: Path | None) -> Path:
    """The folder of --run, or the newest. @raises ResultError when it is not there"""
    folder = path or newest_run()
    if not folder.is_dir():
        raise ResultError(f"{folder}: no such folder; ./run_all.sh run makes one")
    return folder


def read_file(file: Path, *, of_any_revision: bool = False) -> Run:
    """A result file.

    @param of_any_revision accept keys that this revision's schema does not have; those that a Run
           needs must be there
    @raises ResultError when the file is missing, broken or not to the schema"""
    return run_of(file, load(file), of_any_revision=of_any_revision)


def run_of(file: Path, data: Any, *, of_any_revision: bool = False) -> Run:
    """What `load` returned, as a run. @raises ResultError as read_file does"""
    if not of_any_revision:
        validate(file, data)
    try:
        run = _typed(file, data)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise ResultError(f"{file}: not a result file of geodesic-bench: {error}") from None
    _check_names(run)
    return run


def load(file: Path) -> Any:
    """JSON with finite numbers, control characters escaped. @raises ResultError"""
    try:
        data = _harmless(_parsed(file))
        _refuse_non_finite(file, data)
    except RecursionError:
        raise ResultError(f"{file}: nested too deep for a result file") from None
    return data


def _harmless(data: Any) -> Any:
    """The same with every text printable: file names and error messages are arbitrary."""
    if isinstance(data, str):
        return printable(data)
    if isinstance(data, dict):
        return {printable(key): _harmless(value) for key, value in data.items()}
    return [_harmless(value) for value in data] if isinstance(data, list) else data


def newest_run() -> Path:
    """The last run folder of results/runs, whose names begin with the time of their start."""
    folders = sorted(file.parent for file in RUNS.glob("*/run.json"))
    if not folders:
        raise ResultError(f"{RUNS}: no run there yet; ./run_all.sh run makes one")
    return folders[-1]


def _parsed(file: Path) -> Any:
    try:
        return json.loads(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise ResultError(f"{file}: no such file; was the run interrupted?") from None
    except OSError as error:
        raise ResultError(f"{file}: cannot be read: {error.strerror}") from None
    except ValueError as error:  # of JSON or of UTF-8
        raise ResultError(f"{file}: not JSON, perhaps truncated: {error}") from None


def _refuse_non_finite(file: Path, data: Any) -> None:
    for path, value in _leaves(data, []):
        if isinstance(value, float) and not math.isfinite(value):
            raise ResultError(f"{file}: {_key(path)}: {value} is not a finite number")


def _leaves(value: Any, path: list[str | int]) -> Iterator[tuple[list[str | int], Any]]:
    if isinstance(value, dict):
        for key, item in value.items():
            yield from _leaves(item, [*path, key])
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from _leaves(item, [*path, index])
    else:
        yield path, value


def _key(path: list[str | int]) -> str:
    """["benchmarks", 3, "source"] as benchmarks[3].source"""
    steps = (f"[{step}]" if isinstance(step, int) else f".{step}" for step in path)
    return "".join(steps).lstrip(".") or "the file"


@cache
def _validator() -> Any:
    return jsonschema.Draft202012Validator(json.loads(SCHEMA.read_text(encoding="utf-8")))


def validate(file: Path, data: Any) -> None:
    """@raises ResultError with the first key of the file that is not to the schema"""
    error = next(_validator().iter_errors(data), None)
    if error is not None:
        line = " ".join(error.message.split())
        if len(line) > 200:
            line = f"{line[:120]} ... {line[-70:]}"
        raise ResultError(f"{file}: {_key(list(error.absolute_path))}: {line}")


Kind = TypeVar("Kind", Mesh, Solver, Skip, Row)


def _typed(file: Path, data: Any) -> Run:
    ours = data["context"]["geodesic_bench"]
    meshes = [
        _of(Mesh, mesh, reports=tuple(mesh.get("reports", ()))) for mesh in ours["meshes"]
    ]
    solvers = [_of(Solver, each, exact=each["exactness"] == "exact") for each in ours["solvers"]]
    return Run(
        file=file,
        context=data["context"],
        meshes={mesh.name: mesh for mesh in meshes},
        solvers={solver.name: solver for solver in solvers},
        sources={mesh: [int(v) for v in sources] for mesh, sources in ours["sources"].items()},
        skipped=[_of(Skip, skip) for skip in ours["skipped"]],
        rows=[_row(row) for row in data["benchmarks"]],
    )


def _of(kind: type[Kind], found: dict[str, Any], **others: Any) -> Kind:
    """The members that the object in JSON has by these names, and the others."""
    copied = {one.name: found[one.name] for one in fields(kind) if one.name in found}
    return kind(**copied | others)


def _row(row: dict[str, Any]) -> Row:
    return _of(
        Row, row,
        source=int(row["source"]),
        repetition=int(row.get("repetition_index", 0)),
        message=row.get("error_message", ""),
        reference=row.get("reference"),
        numbers=_numbers(row),
        data=row,
    )  # fmt: skip


def _numbers(row: dict[str, Any]) -> dict[str, float]:
    leaves = (([str(key) for key in path], value) for path, value in _leaves(row, []))
    numbers = {".".join(path): value for path, value in leaves if type(value) in (int, float)}
    ok = row["outcome"] == OK
    return {key: value for key, value in numbers.items() if ok or key in ERRORS}


def _check_names(run: Run) -> None:
    """The meshes, solvers and sources of the rows must be in the context."""
    for index, row in enumerate(run.rows):
        where = f"{run.file}: benchmarks[{index}]"
        if row.mesh not in run.meshes:
            raise ResultError(f"{where}.mesh: {row.mesh!r} is not among the context's meshes")
        if row.solver not in run.solvers:
            raise ResultError(f"{where}.solver: {row.solver!r} is not among the context's solvers")
        if row.source not in run.sources.get(row.mesh, []):
            raise ResultError(
                f"{where}.source: {row.source} is not among the context's sources of {row.mesh}"
            )
