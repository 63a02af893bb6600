"""The rows of Tables 5.1 and 5.2: the thesis's models in its order, then the run's other meshes."""

from __future__ import annotations

from dataclasses import dataclass

from results import published
from results.reader import Mesh, Run


@dataclass(frozen=True)
class Model:
    """A mesh of the run, a model of the thesis, or both."""

    mesh: Mesh | None
    thesis: str | None

    @property
    def name(self) -> str:
        return self.mesh.name if self.mesh else str(self.thesis)

    @property
    def label(self) -> str:
        """The name, and of a stand-in what it stands for."""
        return self.mesh.label if self.mesh else str(self.thesis)

    @property
    def is_stand_in(self) -> bool:
        return self.mesh is not None and self.mesh.stand_in

    @property
    def relation(self) -> str:
        """How the mesh and the thesis's model relate, in words; empty when there is no model."""
        if self.thesis is None:
            return ""
        if self.mesh is None:
            return "published only"
        if self.is_stand_in:
            return f"stand-in for {self.thesis}"
        return f"the thesis's {self.thesis}"


def models(run: Run) -> list[Model]:
    """@raises ResultError when a mesh claims to be a model that the thesis does not have."""
    for mesh in run.meshes.values():
        if mesh.thesis_model is not None:
            published.table_5_2(mesh.thesis_model)
    listed = []
    for thesis in published.models():
        meshes = [mesh for mesh in run.meshes.values() if mesh.thesis_model == thesis]
        meshes.sort(key=lambda mesh: mesh.stand_in)
        listed += [Model(mesh, thesis) for mesh in meshes] or [Model(None, thesis)]
    listed += [Model(mesh, None) for mesh in run.meshes.values() if mesh.thesis_model is None]
    return listed


def left_out(run: Run) -> list[str]:
    """A sentence for each mesh of the corpus that the run skipped whole."""
    return [
        f"{skip.mesh} was skipped: {skip.why}"
        for skip in run.skipped
        if skip.solver is None and skip.mesh not in run.meshes
    ]
