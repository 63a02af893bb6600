"""The package: its documentation and metadata, and a build of its source distribution without a checkout."""

from __future__ import annotations

import ast
import doctest
import importlib
import inspect
import os
import re
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path
from typing import Any

import pytest
from python_package import BENCH, ROOT, make_source_distribution

gb = pytest.importorskip("geodesic_bench")

FROM_WHEEL = """
import geodesic_bench as gb
from geodesic_bench.results import reader
assert reader.SCHEMA.exists()
mesh = gb.Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
print(gb.__file__, *{mesh.distances([1], solver=name)[2] for name in gb.solvers()})
"""
OF_EVERY_SYSTEM = {"libstdc++", "libgcc_s", "libm", "libc", "ld-linux-x86-64", "ld-linux-aarch64"}


@pytest.mark.parametrize("module", ["geodesic_bench", "geodesic_bench.arrays", "geodesic_bench.field", "geodesic_bench.mesh", "geodesic_bench.prepared"])
def test_examples_of_docstrings_do_what_they_say(module: str) -> None:
    failed, tried = doctest.testmod(importlib.import_module(module))
    assert tried > 0 and failed == 0


def test_stubs_name_what_the_compiled_module_has() -> None:
    native = importlib.import_module("geodesic_bench._native")
    tree = ast.parse((ROOT / "python" / "geodesic_bench" / "_native.pyi").read_text("utf-8"))

    def stubbed(body: list[ast.stmt]) -> set[str]:
        kinds = (ast.FunctionDef, ast.ClassDef)
        names = {s.name for s in body if isinstance(s, kinds)}
        names |= {ast.unparse(s.target) for s in body if isinstance(s, ast.AnnAssign)}
        return {name for name in names if not name.startswith("__")}

    def there(of: object) -> set[str]:
        return {name for name in vars(of) if not name.startswith("_")}

    assert stubbed(tree.body) == there(native)
    for part in tree.body:
        if isinstance(part, ast.ClassDef):
            assert stubbed(part.body) == there(getattr(native, part.name)), part.name


def test_everything_public_has_a_docstring_with_its_parameters() -> None:
    for name in gb.__all__:
        assert getattr(gb, name).__doc__, name
    for native in (gb.Defect, gb.Solver):
        assert all(inspect.getdoc(each) for name, each in vars(native).items() if name[0] != "_"), native
    for attribute in ("points", "faces", "travelled", "length", "source"):
        assert f"{attribute} : " in gb.Path.__doc__
    for method in (gb.Mesh.distances, gb.Mesh.solve, gb.Mesh.isolines, gb.Mesh.path, gb.Mesh.paths, gb.Mesh.nearest_point,
                   gb.Field.at, gb.Field.path_to, gb.Field.paths_to, gb.Field.isolines,
                   gb.Mesh.distance_matrix, gb.Mesh.prepare, gb.Mesh.load_prepared, gb.Prepared.save, gb.read_mesh, gb.run, gb.benchmark):
        words = method.__doc__
        unsaid = [name for name in method.__annotations__ if f"{name}\n" not in words.replace(" :", "\n")]
        assert unsaid == ["return"] or unsaid == [], method.__name__


def test_options_have_names_only_since_other_packages_have_other_orders() -> None:
    of_the_mesh = {name: method for name, method in vars(gb.Mesh).items() if inspect.isfunction(method)}
    functions = {name: getattr(gb, name) for name in gb.__all__ if inspect.isfunction(getattr(gb, name))}
    assert {"distances", "path", "read_mesh", "benchmark"} < {*of_the_mesh, *functions}
    by_place = {
        f"{name}.{parameter.name}"
        for name, function in (of_the_mesh | functions).items() if name[0] != "_" or name == "__init__"
        for parameter in inspect.signature(function).parameters.values()
        if parameter.kind == parameter.POSITIONAL_OR_KEYWORD and parameter.default != parameter.empty
    }  # fmt: skip
    columns = {"distance_matrix.rows", "distance_matrix.columns"}
    assert by_place == {"__init__.faces", "distances.targets", *columns}


def test_the_version_is_that_of_the_project() -> None:
    assert f"project(GeodesicBench VERSION {gb.__version__} " in (ROOT / "CMakeLists.txt").read_text()


def bench_run(out: Path, **options: object) -> Any:
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


def test_the_source_distribution_has_what_a_build_reads_and_nothing_built(tmp_path: Path) -> None:
    sdist = make_source_distribution(tmp_path)
    names = {name.partition("/")[2] for name in tarfile.open(sdist).getnames()}
    for folder in ("cmake", "geodesic", "meshes", "python", "solvers"):
        files = {str(f.relative_to(ROOT)) for f in (ROOT / folder).rglob("*.*") if "__pycache__" not in f.parts}
        assert files and files - names == set()
    assert not [name for name in names if name.endswith((".so", ".pyc"))]


def found_in_the_system(wheel: Path, folder: Path) -> set[str]:
    """Returns the libraries, without ".so" and version, that the module loads from outside the wheel."""
    zipfile.ZipFile(wheel).extractall(folder)
    (module,) = folder.glob("geodesic_bench/_native*.so")
    said = subprocess.run(["ldd", module], capture_output=True, text=True, check=True).stdout
    found = [Path(word) for word in re.findall(r"(?:=> |^\s+)(/\S+)", said, re.MULTILINE)]
    assert {file.name for file in module.parent.glob("lib*.so")} <= {file.name for file in found}
    return {file.name.split(".so")[0] for file in found if file.parent != module.parent}


@pytest.mark.nightly
def test_the_source_distribution_builds_and_installs_without_a_network(tmp_path: Path) -> None:
    isolated = tmp_path / "environment"

    def run(*command: str | Path, **more: str) -> str:
        ended = subprocess.run(
            command, cwd=tmp_path, env=os.environ | more, text=True, check=False,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        )  # fmt: skip
        assert ended.returncode == 0, ended.stdout
        return ended.stdout

    sdist = make_source_distribution(tmp_path)
    run(sys.executable, "-m", "venv", "--system-site-packages", isolated)
    pip = (isolated / "bin" / "pip", "wheel", "--no-build-isolation", "--no-index", "--no-deps")
    run(*pip, "--wheel-dir", tmp_path, sdist)
    (wheel,) = tmp_path.glob("*.whl")
    assert wheel.stat().st_size < 5e6
    packed = zipfile.ZipFile(wheel).namelist()
    assert {"geodesic_bench/py.typed", "geodesic_bench/_native.pyi"} < set(packed)
    assert found_in_the_system(wheel, tmp_path / "unpacked") <= OF_EVERY_SYSTEM

    run(isolated / "bin" / "pip", "install", "--no-index", "--no-deps", wheel)
    said = run(isolated / "bin" / "python", "-c", FROM_WHEEL, PYTHONPATH="")
    assert said == f"{next(isolated.glob('lib/*/site-packages'))}/geodesic_bench/__init__.py 5.0\n"


def test_the_library_of_the_package_has_no_solver_under_the_gpl() -> None:
    assert "cgal" not in gb.solvers() and len(gb.solvers()) >= 7
