"""The one reader of rank.json: validates it and gives typed standings.

Draws nothing. Whatever is wrong with the file ends in a ResultError of one line.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from results import ROOT, ResultError, Run, load, run_of, validate

SCHEMA = ROOT / "results" / "rank.schema.json"


@dataclass(frozen=True)
class Ratio:
    """The candidate's time over a rival's, with its 95% interval."""

    value: float
    low: float
    high: float
    pairs: int
    resolved: bool


@dataclass(frozen=True)
class OnMesh:
    mesh: str
    time: Ratio
    least: float
    most: float
    """Of the pairs' ratios."""


@dataclass(frozen=True)
class Standing:
    solver: str
    time: Ratio | None
    """The geometric mean over its meshes; of the candidate, and without any mesh, None."""
    meshes: list[OnMesh]

    def on(self, mesh: str) -> OnMesh | None:
        return next((one for one in self.meshes if one.mesh == mesh), None)


@dataclass(frozen=True)
class Ranking:
    run: Run
    """The verified cells."""
    candidate: str
    verdict: str
    standings: list[Standing]
    """Fastest first, the candidate among them."""

    @property
    def rivals(self) -> list[Standing]:
        """Those that could be timed beside the candidate."""
        return [standing for standing in self.standings if standing.time]


def read_ranking(folder: Path) -> Ranking:
    """@raises ResultError when rank.json is missing, broken or not to its schemas"""
    file = folder / "rank.json"
    data = load(file)
    ranking = data.pop("ranking", None) if isinstance(data, dict) else None
    if ranking is None:
        raise ResultError(f"{file}: no ranking; geodesic-bench rank writes one")
    validate(file, ranking, SCHEMA)
    return Ranking(
        run=run_of(file, data),
        candidate=ranking["candidate"],
        verdict=ranking["verdict"],
        standings=[_standing(standing) for standing in ranking["standings"]],
    )


def _standing(data: dict[str, Any]) -> Standing:
    return Standing(
        solver=data["solver"],
        time=Ratio(**data["time"]) if data["time"] else None,
        meshes=[
            OnMesh(mesh["mesh"], Ratio(**mesh["time"]), mesh["least"], mesh["most"])
            for mesh in data["meshes"]
        ],
    )
