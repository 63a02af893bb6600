"""Completion of command lines, as the shells request it."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "tools" / "completion"
BENCH = Path(os.environ.get("GEODESIC_BENCH") or ROOT / "build" / "release" / "geodesic-bench")

pytestmark = pytest.mark.skipif(not BENCH.exists(), reason=f"no program at {BENCH}")

CASES = [
    ("ver", {"verify"}),
    ("solve --solver mm", {"mmp"}),
    ("solve --solver steiner", {"steiner", "steiner?points="}),
    ("run --corpus qu", {"quick"}),
    ("run --meshes nefertiti-l", {"nefertiti-loop2"}),
    ("run --repet", {"--repetitions"}),
    ("generate icos", {"icosphere"}),
    ("solve --output spo", {"spot-own.ply"}),
    ("export --to g", {"github-action-benchmark"}),
    ("compare --format m", {"markdown"}),
    ("solve spo", {"spot", "spot-own.ply"}),
]


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    """Environment whose PATH has the program under test as geodesic-bench. Its folder has a mesh file."""
    (tmp_path / "spot-own.ply").touch()
    (tmp_path / "geodesic-bench").symlink_to(BENCH.resolve())
    return dict(os.environ, PATH=f"{tmp_path}:{os.environ['PATH']}")


def printed(command: list[str], environment: dict[str, str], folder: Path) -> set[str]:
    ended = subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True)
    assert (ended.returncode, ended.stderr) == (0, "")
    return {line.split("\t")[0] for line in ended.stdout.splitlines()}


@pytest.mark.parametrize(("typed", "expected"), [*CASES, ("run --solvers mmp,ed", None)])
def test_bash(
    typed: str, expected: set[str] | None, environment: dict[str, str], tmp_path: Path
) -> None:
    words = ["geodesic-bench", *typed.split()]
    script = (
        f"source {shlex.quote(str(FOLDER / 'geodesic-bench.bash'))}\n"
        f"COMP_WORDS=({shlex.join(words)}) COMP_CWORD={len(words) - 1}\n"
        '_geodesic_bench geodesic-bench\n[[ -z ${COMPREPLY[*]} ]] || printf "%s\\n" "${COMPREPLY[@]}"\n'
    )
    found = printed(["bash", "-c", script], environment, tmp_path)
    if expected is None:  # the rest of a list
        assert {"mmp,edge-based", "mmp,edge-based-approximate"} <= found
    else:
        assert found == expected


@pytest.mark.skipif(shutil.which("fish") is None, reason="fish is not installed")
@pytest.mark.parametrize(("typed", "expected"), CASES)
def test_fish(
    typed: str, expected: set[str], environment: dict[str, str], tmp_path: Path
) -> None:
    script = f"source {FOLDER}/geodesic-bench.fish; complete -C 'geodesic-bench {typed}'"
    assert printed(["fish", "-c", script], environment, tmp_path) == expected


@pytest.mark.skipif(shutil.which("zsh") is None, reason="zsh is not installed")
def test_zsh_knows_the_command(environment: dict[str, str], tmp_path: Path) -> None:
    script = (
        f"fpath=({shlex.quote(str(FOLDER))} $fpath); autoload -U compinit; compinit -D -u\n"
        "echo $_comps[geodesic-bench]"
    )
    assert printed(["zsh", "-f", "-c", script], environment, tmp_path) == {"_geodesic-bench"}
