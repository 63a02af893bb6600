"""The meshes of a run in the thesis's order, and their relation to its models."""

from __future__ import annotations

import re

from results import published
from results.reader import Mesh, ResultError, Run


def ordered_meshes(run: Run) -> list[Mesh]:
    """Returns the thesis's models and their stand-ins in its order, then the other meshes.

    @raises ResultError when a mesh claims to be a model that the thesis does not have"""
    for mesh in run.meshes.values():
        if mesh.thesis_model is not None:
            published.table_5_2(mesh.thesis_model)
    order = [*published.models(), None]
    return sorted(run.meshes.values(), key=lambda m: (order.index(m.thesis_model), m.stand_in))


def relation(mesh: Mesh) -> str:
    """Returns the relation of the mesh to the thesis's model in words; empty without a model."""
    if mesh.thesis_model is None:
        return ""
    return ("stand-in for " if mesh.stand_in else "the thesis's ") + mesh.thesis_model


def of_thesis(run: Run) -> list[Mesh]:
    """Returns the meshes that are or stand for a model of the thesis."""
    return [mesh for mesh in ordered_meshes(run) if mesh.thesis_model]


def titled(run: Run, title: str, number: str) -> str:
    """Returns a title such as "Statistics of running time (Figure 5.9 of the thesis)", or only its words if
    no mesh of the run is or stands for a model of the thesis."""
    return title + beside_thesis(run, f" ({number} of the thesis)")


def beside_thesis(run: Run, words: str) -> str:
    """Returns the words if a mesh of the run is or stands for a model of the thesis; else empty."""
    return words if of_thesis(run) else ""


def agreement(run: Run, agrees: bool, more: str = "") -> str:
    """Returns the end of a sentence on agreement with the thesis; empty without its models.

    @param more words that follow"""
    verb = "agrees" if agrees else "does not agree"
    return beside_thesis(run, f", which {verb} with the thesis{more}")


def groups_of_thesis(run: Run) -> dict[str, list[Mesh]]:
    """Returns the thesis's models and the stand-ins for them; one of the two groups may be empty.

    @raises ResultError if both are empty"""
    measured = of_thesis(run)
    if not measured:
        raise ResultError(f"{run.file}: no mesh is or stands for a model of the thesis")
    return {
        "the thesis's models": [mesh for mesh in measured if not mesh.stand_in],
        "stand-ins": [mesh for mesh in measured if mesh.stand_in],
    }


def left_out(run: Run) -> list[str]:
    """Returns a sentence for each mesh of the corpus that the run skipped for all solvers."""
    return [f"{skip.mesh} was skipped: {_short(skip.why)}" for skip in run.not_measured]


def timed_elsewhere(run: Run) -> list[str]:
    """Returns a sentence for each way of timing external solvers (docs/external-solvers.md)."""
    ways = {
        "reported": "as they report them",
        "process less reading": "those of a process, less those of one that only reads the mesh",
        "process": "those of a whole process, reading included",
    }
    timed = {way: run.columns.where("timed", way) for way in ways}
    solvers = {
        way: [s for s in run.solvers if (run.columns.where("solver", s) & rows).any()]
        for way, rows in timed.items()
    }
    return [f"Times of {', '.join(of)}: {ways[way]}." for way, of in solvers.items() if of]


def _short(why: str) -> str:
    """Returns the reason without the file and the first example of each defect, which a table does not need."""
    return re.sub(r" \(first: (?:[^()]|\([^()]*\))*\)", "", re.sub(r"^\S*/\S*: ", "", why))
