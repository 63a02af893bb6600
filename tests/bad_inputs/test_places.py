"""Commands must work with all locales, names and terminals, and with missing variables."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from bad_results import GOLDEN
from shell import ANSWERS, Bash

SOLVE = "geodesic-bench solve {} --solver mmp --source 0 --output {}"
NAME = "-Grüße メッシュ $(touch x);'\".obj"
"""It has what a shell, an option parser or an encoding may take for something else."""
ENVIRONMENTS = {
    "a decimal comma": "LOCPATH=$PWD LC_ALL=de_DE.UTF-8",
    "no UTF-8": "LC_ALL=C PYTHONIOENCODING=ascii",
    "no variable but the PATH": 'env -i PATH="$PATH"',
    "values that name nothing": "LC_ALL=xx_YY HOME=/proc/nowhere TMPDIR=/proc/nowhere TERM=dumb COLUMNS=1",
}


@pytest.fixture
def german(tmp_path: Path) -> None:
    """The locale of the first environment, compiled into the folder."""
    target = tmp_path / "here" / "de_DE.UTF-8"
    if shutil.which("localedef") is None:
        pytest.skip("there is no localedef to compile a locale with")
    # Without the sources, localedef of glibc 2.41 writes an unusable locale.
    sources = [Path("/usr/share/i18n", name) for name in ("locales/de_DE", "charmaps/UTF-8.gz")]
    if not all(source.exists() for source in sources):
        pytest.skip("localedef has no sources of de_DE (Debian: locales)")
    command = ["localedef", "-i", "de_DE", "-f", "UTF-8", str(target)]
    subprocess.run(command, capture_output=True, check=False)


@pytest.mark.parametrize("name", ENVIRONMENTS)
def test_answers_do_not_depend_on_the_environment(
    name: str, bash: Bash, plain: Path, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    if name == "a decimal comma":
        request.getfixturevalue("german")
        comma = bash(f"{ENVIRONMENTS[name]} bash -c 'printf %.1f 0,5'")
        assert comma.stdout == "0,5", comma
    here = tmp_path / "here"
    for command in ANSWERS:
        ended = bash(f"{ENVIRONMENTS[name]} {command.format('other')}")
        assert ended.returncode == 0, ended
    for suffix in (".off", ".txt"):
        assert (plain / f"plain{suffix}").read_bytes() == (here / f"other{suffix}").read_bytes()
    for file in (plain / "plain").iterdir():
        assert file.read_bytes() == (here / "other" / file.name).read_bytes()
    assert "." in (here / "other.txt").read_text() and "," not in (here / "other.txt").read_text()


def test_any_name_of_a_file_or_folder_will_do(bash: Bash, tmp_path: Path) -> None:
    here = tmp_path / "here"
    folder = here / NAME.removesuffix(".obj")
    folder.mkdir()
    mesh = here / NAME
    shutil.copy(here / "hill.obj", mesh)
    environment = "LC_ALL=C PYTHONIOENCODING=ascii"
    quoted = "'" + str(mesh).replace("'", "'\\''") + "'"
    out = "'" + str(folder).replace("'", "'\\''") + "'"
    assert bash(SOLVE.format("hill.obj", "plain.txt")).returncode == 0
    ended = bash(f"{environment} {SOLVE.format(quoted, out + '/d.txt')}")
    assert ended.returncode == 0, ended
    assert (folder / "d.txt").read_bytes() == (here / "plain.txt").read_bytes()
    run = f"geodesic-bench run --meshes {quoted} --solvers mmp --sources 1 --min-time 0.00001"
    for command in (f"{run} --repetitions 1 --out {out}", f"check_run.py {out}",
                    f"plots performance --run {out}", f"geodesic-bench compare {out} {out}"):  # fmt: skip
        ended = bash(f"{environment} {command}")
        assert ended.returncode == 0, ended
    assert not (here / "x").exists()


def test_a_name_that_is_no_text_can_be_solved(bash: Bash, tmp_path: Path) -> None:
    solve = SOLVE.format(r"$'h\xff.obj'", "d.txt")
    ended = bash(rf"cp hill.obj $'h\xff.obj'; {solve}")
    assert ended.returncode == 0 and r'"mesh": "h\\xff"' in ended.stdout, ended


def golden_run_with(mesh: str) -> str:
    """Returns the golden run, in which rocker-arm has the name `mesh` (escaped for JSON) and the file a.obj."""
    text = GOLDEN.read_text(encoding="utf-8")
    return text.replace('"rocker-arm.obj"', '"a.obj"').replace("rocker-arm", mesh)


def test_escape_sequences_of_a_run_do_not_reach_the_terminal(bash: Bash, tmp_path: Path) -> None:
    text = golden_run_with(r"\u001b[2J\u0007")
    (tmp_path / "here" / "run.json").write_text(text, encoding="utf-8")
    for command in (
        "check_run.py .",
        "plots performance --run .",
        "geodesic-bench compare . .",
    ):
        ended = bash(command)
        shown = "" if command.startswith("plots") else r"\x1b[2J"
        assert shown in ended.stdout, ended
        assert not set(ended.stdout + ended.stderr) & {"\x1b", "\x07"}, ended


def test_a_reader_that_leaves_early_ends_a_command_silently(bash: Bash) -> None:
    for command in ("geodesic-bench generate --list", f"check_run.py '{GOLDEN.parent}'"):
        ended = bash(f"{command} | head -n 1")
        assert (len(ended.stdout.splitlines()), ended.stderr) == (1, ""), ended


def test_closed_streams_are_not_taken_for_files(bash: Bash, tmp_path: Path) -> None:
    bash(SOLVE.format("hill.obj", "plain.txt"))
    for streams in (">&-", "2>&-", "<&-", "<&- >&- 2>&-"):
        bash(f"{SOLVE.format('hill.obj', 'd.txt')} --repair {streams}")
        here = tmp_path / "here"
        assert (here / "d.txt").read_bytes() == (here / "plain.txt").read_bytes(), streams
        (here / "d.txt").unlink()
