"""The meshes of a run in the thesis's order, and how they relate to its models."""

from __future__ import annotations

from results import published
from results.reader import Mesh, Run


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


def left_out(run: Run) -> list[str]:
    """A sentence for each mesh of the corpus that the run skipped whole."""
    return [
        f"{skip.mesh} was skipped: {skip.why}"
        for skip in run.skipped
        if skip.solver is None and skip.mesh not in run.meshes
    ]
