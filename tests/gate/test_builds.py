"""The gate builds only the solvers that it compares."""

from __future__ import annotations

from pathlib import Path

import pytest
from gate.builds import options_for


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    for folder in ("mmp", "core/queues", "variants/my_variant"):
        (tmp_path / "solvers" / folder).mkdir(parents=True)
    for folder in ("mmp", "variants/my_variant"):
        (tmp_path / "solvers" / folder / "CMakeLists.txt").touch()
    return tmp_path


def test_variants_are_not_built(tree: Path) -> None:
    assert options_for(tree, [])[-1] == "-DGEODESIC_SOLVERS=mmp"


def test_a_variant_that_is_named_is_built(tree: Path) -> None:
    assert options_for(tree, ["my-variant"])[-1] == "-DGEODESIC_SOLVERS=mmp;my_variant"
