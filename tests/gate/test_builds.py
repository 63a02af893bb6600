"""Which solvers the gate builds: those that it judges."""

from __future__ import annotations

from pathlib import Path

import pytest
from gate.builds import options_for


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    for folder, text in {
        "mmp": '.name = "mmp",\n.name = "fwp-mmp",',
        "my_variant": '.name = "my-variant",\n.by_name_only = true,',
    }.items():
        (tmp_path / "solvers" / folder).mkdir(parents=True)
        (tmp_path / "solvers" / folder / "CMakeLists.txt").touch()
        (tmp_path / "solvers" / folder / f"{folder}.cpp").write_text(text)
    (tmp_path / "solvers" / "core").mkdir()
    return tmp_path


def test_solvers_that_run_by_name_only_are_not_built(tree: Path) -> None:
    assert options_for(tree, [])[-1] == "-DGEODESIC_SOLVERS=mmp"


def test_a_solver_that_is_asked_for_is_built(tree: Path) -> None:
    assert options_for(tree, ["my-variant"])[-1] == "-DGEODESIC_SOLVERS=mmp;my_variant"
