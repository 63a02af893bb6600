"""Programs write only to the intended places and never execute text from a file (SECURITY.md)."""

from __future__ import annotations

import ast
import json
import os
import re
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from bad_manifests import GOOD, MESH
from bad_results import GOLDEN
from shell import BENCH, ROOT, Bash

SOLVE = "geodesic-bench solve hill.obj --solver mmp --source 0 --output"
PYTHON = ["datasets", "gate", "plots", "results"]
CPP = ["harness", "solvers", "meshes", "geodesic"]
FORBIDDEN = {"eval", "exec", "compile", "system", "popen", "mktemp", "Unpickler"}
"""Python functions that execute text or create files with predictable names."""


def tree(folder: Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}


@pytest.mark.parametrize("name", ["../../evil", "/tmp/evil", "a/b", "..", ".hidden", "a\\b"])
def test_a_name_in_a_manifest_does_not_lead_out_of_the_run(
    name: str, bash: Bash, tmp_path: Path
) -> None:
    manifest = {**GOOD, "meshes": [{**MESH, "name": name}], "corpora": {"all": [name]}}
    here = tmp_path / "here"
    (here / "manifest.json").write_text(json.dumps(manifest))
    before = tree(tmp_path)
    ended = bash(
        "GEODESIC_DATASETS=$PWD geodesic-bench run --manifest manifest.json --corpus all"
        " --solvers mmp --sources 1 --recordings all --out run"
    )
    assert ended.returncode == 1 and "must be a name of at most 100" in ended.stderr, ended
    assert tree(tmp_path) == before


def test_a_run_writes_into_its_folder_only(bash: Bash, tmp_path: Path) -> None:
    before = tree(tmp_path)
    ended = bash(
        "geodesic-bench run --meshes hill.obj --solvers mmp,ich --sources 2 --repetitions 1"
        " --min-time 0.00001 --recordings all --out run"
    )
    assert ended.returncode == 0, ended
    assert {name for name in tree(tmp_path) - before if not name.startswith("here/run")} == set()


def test_a_link_in_place_of_a_file_is_replaced_and_not_followed(
    bash: Bash, tmp_path: Path
) -> None:
    victim = tmp_path / "victim"
    victim.write_text("precious\n")
    # exec keeps the process id. The name of the unfinished file contains it.
    ended = bash(
        "ln -s ../victim d.txt.$$.part; ln -s ../victim e.txt;"
        f" {SOLVE} e.txt >/dev/null && exec {SOLVE} d.txt"
    )
    assert ended.returncode == 0, ended
    assert victim.read_text() == "precious\n"
    for name in ("d.txt", "e.txt"):
        file = tmp_path / "here" / name
        assert not file.is_symlink() and len(file.read_text().splitlines()) == 4
    assert not list((tmp_path / "here").glob("*.part"))


def test_a_link_in_place_of_a_lock_costs_nothing(bash: Bash, tmp_path: Path) -> None:
    victim = tmp_path / "victim"
    victim.write_text("precious\n")
    locks = tmp_path / "cache" / ".fetch" / "locks"
    locks.mkdir(parents=True)
    (locks / "tiny-plate.ply.lock").symlink_to(victim)
    bash("fetch.py tiny-plate")
    assert victim.read_text() == "precious\n"


def test_the_umask_decides_who_may_read(bash: Bash, tmp_path: Path) -> None:
    ended = bash(
        f"umask 077; {SOLVE} d.txt && geodesic-bench run --meshes hill.obj --solvers mmp"
        " --sources 1 --repetitions 1 --min-time 0.00001 --recordings all --out run"
        f" && plots strip_depth --run '{GOLDEN.parent}' --out tables"
        " && fetch.py tiny-plate"
    )
    assert ended.returncode == 0, ended
    written = tree(tmp_path) - {"here", "here/hill.obj"}
    assert len(written) > 15
    for name in written:
        assert os.stat(tmp_path / name, follow_symlinks=False).st_mode & 0o077 == 0, name


def names_called(file: Path) -> Iterator[str]:
    for node in ast.walk(ast.parse(file.read_text("utf-8"))):
        if isinstance(node, ast.Call):
            called = node.func
            if isinstance(called, ast.Name):
                yield called.id
            elif isinstance(called, ast.Attribute):
                whose = called.value.id if isinstance(called.value, ast.Name) else ""
                yield "" if whose == "re" else called.attr
            yield from (f"{key.arg}=" for key in node.keywords if key.arg == "shell")
        if isinstance(node, ast.Import):
            yield from (f"import {name.name}" for name in node.names)


@pytest.mark.parametrize("folder", PYTHON)
def test_no_script_runs_words_out_of_data(folder: str) -> None:
    files = list((ROOT / folder).rglob("*.py"))
    assert files
    for file in files:
        found = set(names_called(file))
        assert not found & (FORBIDDEN | {"shell=", "import pickle", "import shelve"}), file


@pytest.mark.parametrize("folder", CPP)
def test_the_program_starts_no_shell(folder: str) -> None:
    shell = re.compile(r"\b(?:system|popen|execl\w*|tmpnam|tempnam|mktemp)\s*\(")
    files = [path for path in (ROOT / folder).rglob("*") if path.suffix in (".cpp", ".h")]
    assert files
    for file in files:
        assert not shell.search(file.read_text("utf-8")), file


def verifying(folder: Path) -> subprocess.Popen[bytes]:
    """Starts `verify` in a new session, with its temporary files in the folder."""
    folder.mkdir()
    process = subprocess.Popen(
        [BENCH, "verify", "--solver", "template"], cwd=folder, start_new_session=True,
        env={"TMPDIR": str(folder)}, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
    )  # fmt: skip
    until(lambda: len(members(process)) == 2)
    return process


def members(process: subprocess.Popen[bytes]) -> list[int]:
    """Returns the ids of all processes in the session of a process that have not ended."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            state, _, _, session = (folder / "stat").read_text().rsplit(")", 1)[1].split()[:4]
        except OSError:
            continue
        if int(session) == process.pid and state != "Z":
            found.append(int(folder.name))
    return found


def until(holds: Callable[[], bool], seconds: float = 30) -> None:
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, "it never happened"
        time.sleep(0.005)


@pytest.mark.parametrize("everybody", [True, False], ids=["a terminal", "kill"])
@pytest.mark.parametrize(("sent", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_an_interrupted_verify_leaves_nothing_behind(
    everybody: bool, sent: signal.Signals, code: int, tmp_path: Path
) -> None:
    folder = tmp_path / "work"
    process = verifying(folder)
    if everybody:  # Ctrl-C goes to all processes of the terminal
        os.killpg(process.pid, sent)
    else:
        process.send_signal(sent)
    _, errors = process.communicate(timeout=30)
    assert (process.returncode, errors.decode()) == (
        code, f"geodesic-bench: interrupted ({signal.strsignal(sent)})\n",
    )  # fmt: skip
    assert list(folder.iterdir()) == []
    until(lambda: members(process) == [])


def test_an_interrupted_verify_of_random_meshes_says_what_it_has_checked() -> None:
    words: list[str | Path] = [BENCH, "verify", "--solver", "edge-based", "--random", "1000000"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        time.sleep(2)
        process.send_signal(signal.SIGTERM)
        out, errors = process.communicate(timeout=30)
    assert (process.returncode, errors) == (143, "geodesic-bench: interrupted (Terminated)\n")
    said = re.search(r"\n(\d+) of the meshes 0 to 999999 of seed 1: .*\nedge-based: (\d+) hold, 0 fail", out)
    assert said, out
    meshes, hold = map(int, said.groups())
    assert 0 < meshes <= hold <= 4 * meshes


def test_a_killed_verify_leaves_no_process_behind(tmp_path: Path) -> None:
    process = verifying(tmp_path / "work")
    process.kill()
    process.communicate(timeout=30)
    until(lambda: members(process) == [])
