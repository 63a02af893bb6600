"""Every row of the tables: the exit code, and the error output with cause and remedy."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import bad_environments
import bad_flags
import bad_manifests
import bad_meshes
import bad_plugins
import bad_points
import bad_results
import bad_suites
import pytest
from case import Case
from shell import ROOT, Bash, permitted

TABLES = [bad_meshes, bad_flags, bad_suites, bad_manifests, bad_results, bad_plugins,
          bad_points, bad_environments]  # fmt: skip
CASES = {
    f"{table.__name__.removeprefix('bad_')}: {case.name}": case
    for table in TABLES
    for case in table.CASES
}
NEVER_SAID = ["Traceback", "terminate called", "json.exception", "Assertion", "[Errno", "\x1b"]


def test_no_case_hides_another() -> None:
    assert len(CASES) == sum(len(table.CASES) for table in TABLES)


@pytest.mark.parametrize("file", ["plots/__main__.py", "gate/check_run.py", "plots/report.py"])
def test_a_command_can_report_packages_that_are_missing(file: str) -> None:
    lines = (ROOT / file).read_text("utf-8").splitlines()
    imports = (line.split()[1] for line in lines if re.match(r"(import|from) ", line))
    modules = [name for name in imports if name.split(".")[0] not in sys.stdlib_module_names]
    assert modules[0] == "results"
    prepared = [line for line in lines if line.startswith("    console.prepare(")]
    assert len(prepared) == 1 and prepared[0].endswith("# before imports that may fail")


@pytest.mark.parametrize("name", CASES)
def test_a_bad_input_ends_in_one_line(name: str, bash: Bash, tmp_path: Path) -> None:
    case: Case = CASES[name]
    if case.needs and not permitted(case.needs):
        pytest.skip(f"this machine does not permit what tests/bad_inputs/bin/{case.needs} does")
    for file, content in case.files.items():
        data = content.encode("utf-8") if isinstance(content, str) else content
        (tmp_path / "here" / file).write_bytes(data)
    if case.given:
        assert bash(case.given).returncode == 0
    ended = bash(case.command)
    assert (ended.returncode, len(ended.stderr.splitlines())) == (case.code, case.lines), ended
    for words in case.says:
        assert words in ended.stderr
    for words in NEVER_SAID:
        assert words not in ended.stderr
