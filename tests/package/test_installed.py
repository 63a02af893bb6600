"""The program, the library and the headers of an installed copy work without the checkout."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from installed import ROOT, Installed

CUBE = """v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1
f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6
f 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n"""
FAR_CORNER = 5**0.5


@pytest.fixture
def cube(tmp_path: Path) -> Path:
    file = tmp_path / "cube.obj"
    file.write_text(CUBE)
    return file


def test_program_lists_the_solvers_and_the_manifest_of_the_tree(
    installed: Installed, tmp_path: Path
) -> None:
    built = subprocess.run(
        [os.environ["GEODESIC_BENCH"], "list", "--json"], capture_output=True, text=True, check=True
    )
    listed = installed.bench(tmp_path, "list", "--json")
    assert listed.returncode == 0, listed.stderr
    here, there = json.loads(listed.stdout), json.loads(built.stdout)
    assert here["solvers"] == there["solvers"]
    assert here["corpora"] == there["corpora"]


def test_program_names_files_of_its_own_prefix(installed: Installed, tmp_path: Path) -> None:
    ended = installed.bench(tmp_path, "solve", "horse", "--solver", "mmp", "--source", "0")
    fetch = installed.prefix / "share" / "geodesic-bench" / "datasets" / "fetch.py"
    assert ended.returncode == 1
    assert f"{fetch} horse" in ended.stderr


def test_meshes_are_generated_by_the_installed_program(
    installed: Installed, tmp_path: Path
) -> None:
    fetch = installed.prefix / "share" / "geodesic-bench" / "datasets" / "fetch.py"
    mesh = json.loads((fetch.parent / "manifest.json").read_text())["corpora"]["tiny"][0]
    ended = subprocess.run(
        [fetch, mesh, "--cache", tmp_path], capture_output=True, text=True, check=False
    )
    assert ended.returncode == 0, ended.stderr


def test_program_leaves_runs_in_the_current_folder(
    installed: Installed, tmp_path: Path, cube: Path
) -> None:
    ended = installed.bench(
        tmp_path, "run", "--meshes", cube, "--solvers", "mmp,edge-based", "--sources", "1",
        "--repetitions", "1", "--min-time", "0.001",
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    run = Path(ended.stdout.splitlines()[-1])
    assert run.is_relative_to(tmp_path / "results" / "runs")
    assert {row["outcome"] for row in json.loads(run.read_text())["benchmarks"]} == {"ok"}


def test_program_draws_rankings_with_the_files_of_its_own_prefix(
    installed: Installed, tmp_path: Path, cube: Path
) -> None:
    prefix = tmp_path / "own"
    shutil.copytree(installed.prefix, prefix, copy_function=os.link)
    own = replace(installed, prefix=prefix)

    def rank(out: str) -> str:
        ended = own.bench(
            tmp_path, "rank", "--solver", "edge-based", "--against", "mmp", "--meshes", cube,
            "--pairs", "1", "--min-time", "0.001", "--out", out,
        )  # fmt: skip
        assert ended.returncode == 0, ended.stderr
        return ended.stderr

    said = rank("drawn")
    assert (tmp_path / "drawn" / "rank.pdf").exists(), said
    (prefix / "share" / "geodesic-bench" / "plots" / "rank.py").unlink()
    assert "no figure (" in rank("without a script")


def test_library_computes_distances(library: Path, cube: Path) -> None:
    ended = subprocess.run(
        [library / "distances", cube], capture_output=True, text=True, check=True
    )
    assert re.match(r"vertex 6 is the farthest: 2\.23606797749978\d+, by", ended.stderr)
    distances = [float(line) for line in ended.stdout.splitlines()]
    assert distances == pytest.approx([0, 1, 2**0.5, 1, 1, 2**0.5, FAR_CORNER, 2**0.5], rel=1e-12)


def test_library_is_found_by_pkg_config(installed: Installed, tmp_path: Path, cube: Path) -> None:
    (file,) = installed.prefix.rglob("geodesic-bench.pc")
    found = subprocess.run(
        ["pkg-config", "--cflags", "--libs", "geodesic-bench"], capture_output=True, text=True, check=True,
        env=os.environ | {"PKG_CONFIG_PATH": str(file.parent)},
    )  # fmt: skip
    flags = shlex.split(found.stdout)
    compiler = [installed.built["CMAKE_CXX_COMPILER"], "-std=c++20", *installed.built["CMAKE_CXX_FLAGS"].split()]
    source = ROOT / "examples" / "library" / "distances.cpp"
    library = f"-Wl,-rpath,{file.parent.parent}"
    subprocess.run([*compiler, source, "-o", tmp_path / "distances", *flags, library], check=True)
    ended = subprocess.run([tmp_path / "distances", cube], capture_output=True, text=True, check=True)
    assert ended.stderr.startswith("vertex 6 is the farthest")
    older = subprocess.run(
        [compiler[0], "-std=c++17", "-fsyntax-only", *flags, source], capture_output=True, text=True, check=False
    )
    assert "geodesic-bench needs C++20" in older.stderr


def test_library_reads_meshes_and_solves_in_threads(
    library: Path, tmp_path: Path, cube: Path
) -> None:
    sources = ["0", "6", "0", "1"]
    ended = subprocess.run(
        [library / "many_sources", cube, *sources], capture_output=True, text=True, check=True
    )
    lines = [line.split() for line in ended.stdout.splitlines()]
    assert [source for source, _, _ in lines] == sources
    assert lines[0] == lines[2]
    assert [float(distance) for _, _, distance in lines[:2]] == pytest.approx([FAR_CORNER] * 2)
    for mesh, source in ((cube, "8"), (tmp_path / "none.obj", "0")):
        refused = subprocess.run(
            [library / "many_sources", mesh, source], capture_output=True, text=True, check=False
        )
        assert refused.returncode == 1
        assert (source if mesh is cube else str(mesh)) in refused.stderr


def test_library_takes_a_mesh_of_openmesh_and_gives_distances_back_to_it(
    library: Path, cube: Path
) -> None:
    ended = subprocess.run([library / "with_openmesh", cube], capture_output=True, text=True, check=True)
    distances = [float(line) for line in ended.stdout.splitlines()]
    assert distances == pytest.approx([0, 1, 2**0.5, 1, 1, 2**0.5, FAR_CORNER, 2**0.5], rel=1e-12)


@pytest.mark.nightly
def test_headers_compile_alone_and_need_the_standard_library_only(
    installed: Installed, tmp_path: Path
) -> None:
    """Headers that also need Google Highway or OpenMesh name them. If a source of the library includes its own
    header first, the build has already shown that this header compiles alone."""
    headers = sorted(installed.include.rglob("*.h"))
    assert installed.include / "solvers" / "core" / "solver.h" in headers
    plain = [h for h in headers if not re.search("Google Highway|OpenMesh", h.read_text())]
    assert len(plain) > len(headers) / 2
    names = [str(header.relative_to(installed.include)) for header in plain]

    def complaint(number: int, included: list[str]) -> str:
        needs = tmp_path / f"{number}.d"
        ended = subprocess.run(
            [
                installed.built["CMAKE_CXX_COMPILER"], "-std=c++20", "-Wall", "-Wextra", "-Werror",
                "-fsyntax-only", "-I", installed.include, "-MD", "-MF", needs, "-x", "c++", "-",
            ],
            input="".join(f'#include "{name}"\n' for name in included),
            cwd=tmp_path, capture_output=True, text=True, check=False,
        )  # fmt: skip
        if ended.returncode != 0:
            return f"{included}: {ended.stderr}"
        needed = re.search("/hwy/|/OpenMesh/", needs.read_text())
        return f"{included}: needs {needed[0]}" if needed else ""

    units = chains([name for name in names if not is_first_in_its_source(name)])
    assert 0 < len(units) < len(names)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = pool.map(complaint, range(len(units) + 1), [*units, names])
        assert [text for text in complaints if text] == []


def chains(headers: list[str]) -> list[list[str]]:
    """Groups the headers into few translation units. After a header that it includes, a header compiles if
    and only if it compiles alone, because its includes precede its other lines."""
    found: list[list[str]] = []
    for header in sorted(headers, key=lambda name: len(included_by(name))):
        chain = next((one for one in reversed(found) if one[-1] in included_by(header)), None)
        if chain:
            chain.append(header)
        else:
            found.append([header])
    return found


@cache
def included_by(header: str) -> frozenset[str]:
    own = re.findall(r'^#include "([^"]+)"', (ROOT / header).read_text(), re.MULTILINE)
    return frozenset(own).union(*map(included_by, own))


def is_first_in_its_source(header: str) -> bool:
    source = (ROOT / header).with_suffix(".cpp")
    if not source.exists():
        return False
    first = re.search(r'^#include [<"]([^>"]+)', source.read_text(), re.MULTILINE)
    return first is not None and first[1] == header
