"""The gate finds each fault that does not depend on the clock in real programs, at the right level."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from gate_study import FAULTS, Fault, Study

from gate.program import NotCountableError


@pytest.fixture(scope="module")
def study(bench: Path, tmp_path_factory: pytest.TempPathFactory) -> Study:
    return Study(bench.parent, tmp_path_factory.mktemp("study"))


@pytest.mark.parametrize(
    "fault", [pytest.param(f, id=f.name) for f in FAULTS if 4 not in f.levels]
)
def test_fault_is_found_at_its_level(study: Study, fault: Fault) -> None:
    if 2 in fault.levels and shutil.which("valgrind") is None:
        pytest.skip("valgrind is not installed")
    if 2 in fault.levels and study.base_run.context["build_type"] != "Release":
        pytest.skip("valgrind does not run programs with sanitizers")
    try:
        verdict = study.run(fault)
    except NotCountableError as error:
        pytest.skip(str(error))
    assert fault.found(verdict), verdict.headline
