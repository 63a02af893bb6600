"""The package: what it says of itself, and that its source distribution builds without a checkout."""

from __future__ import annotations

import ast
import doctest
import importlib
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

import pytest
from python_package import BENCH, BUILD, ROOT

gb = pytest.importorskip("geodesic_bench")

FROM_SDIST = """
import geodesic_bench as gb
from geodesic_bench.results import reader
assert reader.SCHEMA.exists()
mesh = gb.Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
print(gb.__file__, mesh.distances([1], solver="dijkstra")[2])
"""


@pytest.mark.parametrize("module", ["geodesic_bench", "geodesic_bench.mesh"])
def test_examples_of_docstrings_do_what_they_say(module: str) -> None:
    failed, tried = doctest.testmod(importlib.import_module(module))
    assert tried > 0 and failed == 0


def test_stubs_name_what_the_compiled_module_has() -> None:
    native = importlib.import_module("geodesic_bench._native")
    tree = ast.parse((ROOT / "python" / "geodesic_bench" / "_native.pyi").read_text("utf-8"))

    def stubbed(body: list[ast.stmt]) -> set[str]:
        kinds = (ast.FunctionDef, ast.ClassDef)
        return {s.name for s in body if isinstance(s, kinds) and not s.name.startswith("__")}

    def there(of: object) -> set[str]:
        return {name for name in vars(of) if not name.startswith("_")}

    assert stubbed(tree.body) == there(native)
    for part in tree.body:
        if isinstance(part, ast.ClassDef):
            assert stubbed(part.body) == there(getattr(native, part.name)), part.name


def test_everything_public_has_a_docstring_with_its_parameters() -> None:
    for name in gb.__all__:
        assert getattr(gb, name).__doc__, name
    for method in (gb.Mesh.distances, gb.Mesh.paths, gb.Mesh.nearest_point,
                   gb.Mesh.distance_matrix, gb.read_mesh, gb.run, gb.benchmark):
        words = method.__doc__
        unsaid = [name for name in method.__annotations__ if f"{name}\n" not in words.replace(" :", "\n")]
        assert unsaid == ["return"] or unsaid == [], method.__name__


def test_the_version_is_that_of_the_project() -> None:
    assert f"project(GeodesicBench VERSION {gb.__version__} " in (ROOT / "CMakeLists.txt").read_text()


def bench_run(out: Path, **options: object) -> gb.Results:
    return gb.run(out, executable=BENCH, repetitions=2, min_time=0.001, sources=1, **options)


def test_a_run_is_driven_shown_and_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mesh = tmp_path / "hill.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
    results = bench_run(tmp_path / "run", solvers=["mmp", "edge-based"], meshes=[mesh])
    assert "[2/2] " in capsys.readouterr().err
    assert repr(results) == "Results(4 rows of 2 solvers on 1 meshes)"
    table = results.to_pandas()
    assert sorted(set(table.solver)) == ["edge-based", "mmp"]
    assert set(table.outcome) == {"ok"} and len(table) == 4
    assert (table.cpu_time > 0).all()
    assert gb.Results(tmp_path / "run").to_pandas().equals(table)
    with pytest.raises(ValueError, match=r"run\.json is there already: choose another folder$"):
        bench_run(tmp_path / "run")


def test_a_run_that_cannot_be_is_refused_with_the_sentence_of_the_program(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(ValueError, match=r"^no solver named 'mmmp' \(did you mean 'mmp'\?\)"):
        bench_run(tmp_path / "run", solvers=["mmmp"])
    assert capsys.readouterr().err == ""
    with pytest.raises(ValueError, match=r"run\.json: no such file|no such folder"):
        gb.Results(tmp_path / "run.json")
    with pytest.raises(FileNotFoundError, match=r"^no program nowhere: build it with"):
        gb.run(tmp_path / "run", executable="nowhere")


OF_EVERY_SYSTEM = {"libstdc++", "libgcc_s", "libm", "libc", "ld-linux-x86-64", "ld-linux-aarch64"}


def found_in_the_system(wheel: Path, folder: Path) -> set[str]:
    """The libraries, without ".so" and version, that the module of the wheel loads from elsewhere."""
    zipfile.ZipFile(wheel).extractall(folder)
    (module,) = folder.glob("geodesic_bench/_native*.so")
    said = subprocess.run(["ldd", module], capture_output=True, text=True, check=True).stdout
    found = [Path(word) for word in re.findall(r"(?:=> |^\s+)(/\S+)", said, re.MULTILINE)]
    assert {file.name for file in module.parent.glob("lib*.so")} <= {file.name for file in found}
    return {file.name.split(".so")[0] for file in found if file.parent != module.parent}


def test_the_source_distribution_builds_and_installs_without_a_network(tmp_path: Path) -> None:
    """Of the solvers one is compiled, in few units, and nothing is optimised, to save minutes."""
    source, isolated = tmp_path / "source", tmp_path / "environment"
    unwanted = shutil.ignore_patterns("__pycache__", "runs", "ranks", "baseline", "*.egg-info")
    for folder in ("cmake", "meshes", "python", "results", "solvers"):
        shutil.copytree(ROOT / folder, source / folder, ignore=unwanted)
    for file in ("CITATION.cff", "CMakeLists.txt", "LICENSE", "MANIFEST.in", "README.md",
                 "pyproject.toml", "setup.py"):  # fmt: skip
        shutil.copy(ROOT / file, source)

    def run(*command: str | Path, **more: str) -> str:
        ended = subprocess.run(
            command, cwd=source, env=os.environ | more, text=True, check=False,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        )  # fmt: skip
        assert ended.returncode == 0, ended.stdout
        return ended.stdout

    make = "import sys; from setuptools.build_meta import build_sdist; build_sdist(sys.argv[1])"
    run(sys.executable, "-c", make, tmp_path)
    (sdist,) = tmp_path.glob("*.tar.gz")
    names = tarfile.open(sdist).getnames()
    assert not [name for name in names if name.endswith((".so", ".pyc"))]

    run(sys.executable, "-m", "venv", "--system-site-packages", isolated)
    pip = (isolated / "bin" / "pip", "wheel", "--no-build-isolation", "--no-index", "--no-deps")
    cache = (BUILD / "CMakeCache.txt").read_text()
    launcher = re.search(r"^CMAKE_CXX_COMPILER_LAUNCHER:\w+=(.*)$", cache, re.MULTILINE)
    few_units = "-DGEODESIC_UNITY=OFF -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=24"
    run(
        *pip, "--wheel-dir", tmp_path, sdist,
        CMAKE_ARGS=f"-DGEODESIC_SOLVERS=dijkstra -DCMAKE_CXX_FLAGS_RELEASE=-O0 {few_units}",
        CMAKE_CXX_COMPILER_LAUNCHER=launcher[1] if launcher else "",
        CCACHE_BASEDIR=tempfile.gettempdir(), CCACHE_NOHASHDIR="1",
    )  # fmt: skip
    (wheel,) = tmp_path.glob("*.whl")
    assert wheel.stat().st_size < 5e6
    packed = zipfile.ZipFile(wheel).namelist()
    assert {"geodesic_bench/py.typed", "geodesic_bench/_native.pyi"} < set(packed)
    assert found_in_the_system(wheel, tmp_path / "unpacked") <= OF_EVERY_SYSTEM

    run(isolated / "bin" / "pip", "install", "--no-index", "--no-deps", wheel)
    said = run(isolated / "bin" / "python", "-c", FROM_SDIST, PYTHONPATH="")
    assert said == f"{next(isolated.glob('lib/*/site-packages'))}/geodesic_bench/__init__.py 5.0\n"


def test_the_library_of_the_package_has_no_solver_under_the_gpl() -> None:
    assert "cgal" not in gb.solvers() and len(gb.solvers()) >= 7
