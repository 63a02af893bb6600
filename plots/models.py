"""The meshes of a run in the thesis's order, and how they relate to its models."""

from __future__ import annotations

import re

from results import published
from results.reader import Mesh, ResultError, Run


def ordered_meshes(run: Run) -> list[Mesh]:
    """The thesis's models and what stands for them in its order, then the others.

    @raises ResultError when a mesh claims to be a model that the thesis does not have"""
    for mesh in run.meshes.values():
        if mesh.thesis_model is not None:
            published.table_5_2(mesh.thesis_model)
    order = [*published.models(), None]
    return sorted(run.meshes.values(), key=lambda m: (order.index(m.thesis_model), m.stand_in))


def relation(mesh: Mesh) -> str:
    """How the mesh and the thesis's model relate, in words; empty when there is no model."""
    if mesh.thesis_model is None:
        return ""
    return ("stand-in for " if mesh.stand_in else "the thesis's ") + mesh.thesis_model


def of_thesis(run: Run) -> list[Mesh]:
    """The meshes that are or stand for a model of the thesis."""
    return [mesh for mesh in ordered_meshes(run) if mesh.thesis_model]


def titled(run: Run, number: str, words: str) -> str:
    """"Figure 5.9: statistics of running time"; "Statistics of running time" where no mesh of the
    run is or stands for a model of the thesis."""
    return f"{number}: {words}" if of_thesis(run) else words[0].upper() + words[1:]


def beside_thesis(run: Run, words: str) -> str:
    """The words, where a mesh of the run is or stands for a model of the thesis."""
    return words if of_thesis(run) else ""


def agreement(run: Run, agrees: bool, more: str = "") -> str:
    """The end of a sentence, beside the thesis; empty without its models.

    @param more what follows these words"""
    verb = "agrees" if agrees else "does not agree"
    return beside_thesis(run, f", which {verb} with the thesis{more}")


def groups_of_thesis(run: Run) -> dict[str, list[Mesh]]:
    """Its own models, and stand-ins for them; either may be empty.

    @raises ResultError when both are"""
    measured = of_thesis(run)
    if not measured:
        raise ResultError(f"{run.file}: no mesh is or stands for a model of the thesis")
    return {
        "the thesis's models": [mesh for mesh in measured if not mesh.stand_in],
        "stand-ins": [mesh for mesh in measured if mesh.stand_in],
    }


def left_out(run: Run) -> list[str]:
    """A sentence for each mesh of the corpus that the run skipped whole."""
    return [f"{skip.mesh} was skipped: {_short(skip.why)}" for skip in run.not_measured]


def timed_elsewhere(run: Run) -> list[str]:
    """A sentence for each way in which external solvers are timed (docs/external-solvers.md)."""
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
    """Without the file, and without the first of each defect: what no reader of a table looks up."""
    return re.sub(r" \(first: (?:[^()]|\([^()]*\))*\)", "", re.sub(r"^\S*/\S*: ", "", why))
