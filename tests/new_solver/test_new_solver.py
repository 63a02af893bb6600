"""new_solver.sh in a copy of the checkout: the files that it makes, and its errors. tests/package and the
tutorial test that new solvers build. tests/scripts tests --help."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
STARTS = ["template", "edge-based", "mmp", "chen-han"]
LONG = "a-variant-with-the-longest-name2"
NAMES = {start: f"my-{start}" for start in STARTS}

Ended = subprocess.CompletedProcess[str]


def run(checkout: Path, *words: str | Path, cwd: Path = Path("/")) -> Ended:
    return subprocess.run(
        [checkout / "new_solver.sh", *words], cwd=cwd, capture_output=True, text=True, timeout=60
    )


def sums(folder: Path) -> dict[str, str]:
    return {
        str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest()
        for file in folder.rglob("*")
        if file.is_file()
    }


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A checkout in a path with spaces, with a new solver of each start. The script ran in another folder.
    Each solver is a new folder of three files, and nothing else changes."""
    copy = tmp_path_factory.mktemp("new_solver") / "a path with spaces"
    copy.mkdir()
    shutil.copy(ROOT / "new_solver.sh", copy)
    for name in ["solvers", "tools"]:
        shutil.copytree(ROOT / name, copy / name)
    before = sums(copy)
    for start, name in NAMES.items():
        ended = run(copy, name, f"--from={start}")
        assert (ended.returncode, ended.stderr) == (0, "")
        after = sums(copy)
        assert {file: after.get(file) for file in before} == before
        folder = name.replace("-", "_")
        assert after.keys() - before.keys() == {
            f"solvers/variants/{folder}/{file}"
            for file in ("CMakeLists.txt", "README.md", f"{folder}.cpp")
        }
        before = after
    return copy


@pytest.mark.parametrize("start", STARTS)
def test_no_placeholder_is_left_and_the_solver_is_registered(checkout: Path, start: str) -> None:
    name = NAMES[start]
    folder = checkout / "solvers" / "variants" / name.replace("-", "_")
    for file in folder.iterdir():
        text = file.read_text()
        assert not re.search(r"@\w+@", text) and "template.cpp" not in text.replace("my_template.cpp", "")
    source = (folder / f"{folder.name}.cpp").read_text()
    assert f'.name = "{name}",' in source and "by_name_only" not in source
    assert (folder / "README.md").read_text().startswith(f"# {name}\n")
    assert f"geodesic_add_solver({folder.name} " in (folder / "CMakeLists.txt").read_text()


@pytest.mark.parametrize("start", STARTS)
@pytest.mark.parametrize("name", ["a", LONG])
@pytest.mark.skipif(shutil.which("clang-format") is None, reason="clang-format is not installed")
def test_what_is_made_is_formatted_whatever_the_name(tmp_path: Path, start: str, name: str) -> None:
    assert run(ROOT, name, "--from", start, "--outside", tmp_path / "made").returncode == 0
    [source] = tmp_path.glob("made/*.cpp")
    style = f"--style=file:{ROOT / '.clang-format'}"
    checked = subprocess.run(
        ["clang-format", "--dry-run", "-Werror", style, source], capture_output=True, text=True
    )
    assert checked.returncode == 0, checked.stderr


def test_next_commands_name_the_solver_and_where_it_is(checkout: Path) -> None:
    ended = run(checkout, "last-one", "--from", "chen-han")
    lines = ended.stdout.splitlines()
    assert str(checkout / "solvers" / "variants" / "last_one") in lines[0]
    assert len(lines) == 4 and all(line.startswith("  ") for line in lines[1:])
    assert "verify --solver last-one" in lines[2]
    assert "rank --solver last-one --against ich" in lines[3]


def test_outside_the_tree_a_project_of_the_same_sources(checkout: Path, tmp_path: Path) -> None:
    before = sums(checkout / "solvers")
    ended = run(checkout, "my-mmp2", "--from", "mmp", "--outside", "a folder", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert sums(checkout / "solvers") == before
    outside, inside = tmp_path / "a folder", checkout / "solvers" / "variants" / "my_mmp"
    for made, file in [("my_mmp2.cpp", "my_mmp.cpp"), ("README.md", "README.md")]:
        text = (outside / made).read_text().replace("my-mmp2", "my-mmp").replace("mmp2", "mmp")
        assert text == (inside / file).read_text()
    listed = (outside / "CMakeLists.txt").read_text()
    assert "find_package(GeodesicBench REQUIRED)" in listed
    assert "geodesic_add_solver(my-mmp2 BY_NAME_ONLY my_mmp2.cpp)" in listed


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ([], "give the solver a name"),
        (["My-Variant"], "invalid solver name 'My-Variant'"),
        (["2-step"], "invalid solver name '2-step'"),
        (["my_variant"], "invalid solver name 'my_variant'"),
        (["my--variant"], "invalid solver name 'my--variant'"),
        (["../mmp"], "invalid solver name '../mmp'"),
        (["a" * 33], "longer than 32 characters"),
        (["class"], "'class' is reserved"),
        (["test"], "'test' is reserved"),
        (["core"], "'core' is reserved"),
        (["fwp-mmp"], "there is a solver named 'fwp-mmp' already, in solvers/mmp/mmp.cpp"),
        (["chen-han"], "solvers/chen_han exists"),
        (["one", "two"], "one name at a time: 'one' or 'two'?"),
        (["one", "--from", "dijkstra"], "cannot start from 'dijkstra'; there are template"),
        (["one", "--outside="], "--outside needs a value"),
        (["one", "--outside", "/dev/null/x"], "cannot make /dev/null/x: Not a directory"),
        (["one", "--outside", "/proc/x"], "cannot make /proc/x: No such file"),
    ],
)
def test_refusals_are_one_line_and_change_nothing(
    checkout: Path, words: list[str], says: str
) -> None:
    before = sums(checkout / "solvers")
    ended = run(checkout, *words)
    assert ended.returncode == 1 and ended.stdout == ""
    assert says in ended.stderr and len(ended.stderr.splitlines()) == 1
    assert sums(checkout / "solvers") == before


def test_a_folder_that_is_there_is_not_written_to(checkout: Path, tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    ended = run(checkout, "one", "--outside", tmp_path)
    assert ended.returncode == 1 and f"{tmp_path} exists" in ended.stderr
    assert os.listdir(tmp_path) == ["mine.txt"]


def test_a_folder_without_permission_is_named(checkout: Path, tmp_path: Path) -> None:
    if os.geteuid() == 0:
        pytest.skip("root may write anywhere")
    tmp_path.chmod(0o500)
    ended = run(checkout, "one", "--outside", tmp_path / "new")
    says = f"new_solver.sh: cannot make {tmp_path}/new: Permission denied; nothing was changed\n"
    assert (ended.returncode, ended.stderr) == (1, says)
