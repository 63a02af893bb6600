"""The order of layers in docs/architecture.md, checked against `#include` and `import` lines."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from pages import ROOT

INCLUDE = re.compile(r'^\s*#\s*include\s+(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)

CONTRACT = {f"solvers/core/{name}" for name in ("solver", "contract", "registry", "prepared_file")}
"""Files of the contract, without extension. Other files of core do not include them."""

ORDER = [
    "solvers/core",
    "contract",
    "solvers/paths",
    "family",
    "variant",
    "meshes",
    "geodesic",
    "python",
    "harness/base",
    "harness/external",
    "harness/corpus",
    "harness/results",
    "harness/measure",
    "harness/recordings",
    "harness/verify",
    "harness/run",
    "harness/commands",
    "harness/main",
]
"""Layers. A file includes files of its own layer and of earlier layers."""

HARNESS_ONLY = {"family", "variant"}
"""Layers that only these layers include. Other layers reach the solvers through the registry."""

FOLDERS = ("solvers", "meshes", "geodesic", "python", "harness")
"""Folders of the C++ files."""

LIBRARIES = {
    "hwy/": {"solvers/core", "family", "variant"},
    "CGAL/": {"family"},
    "OpenMesh/": {"meshes/editing"},
    "nlohmann/": {"harness/base"},
    "openssl/": {"harness/base"},
    "benchmark/": {"harness/measure"},
    "pybind11/": {"python"},
    "CLI/": {"harness/commands", "harness/main"},
}
"""Third-party headers and the layers or folders that may include them. Every other `<...>` must be a
system header."""

SYSTEM = re.compile(r"[a-z_0-9]+(\.h)?|sys/[a-z]+\.h")

Includes = dict[str, list[str]]
"""Included files, by file. Paths of files are relative to the root."""


def layer(file: str) -> str:
    """@raises ValueError for a file that belongs to no layer"""
    parts = Path(file).parts
    if str(Path(file).with_suffix("")) in CONTRACT:
        return "contract"
    if parts[0] == "solvers":
        layers = {"core": "solvers/core", "paths": "solvers/paths", "variants": "variant"}
        return layers.get(parts[1], "family")
    if parts[0] in ("meshes", "geodesic", "python"):
        return parts[0]
    name = "/".join(parts[:2]).removesuffix(".cpp")
    if name not in ORDER:
        raise ValueError(f"{file} belongs to no layer")
    return name


def family(file: str) -> Path:
    """Returns the folder of a family or of a variant."""
    parts = Path(file).parts
    return Path(*parts[: 3 if parts[1] == "variants" else 2])


def includes() -> Includes:
    return {
        str(file.relative_to(ROOT)): [a or b for a, b in INCLUDE.findall(file.read_text("utf-8"))]
        for folder in FOLDERS
        for file in sorted((ROOT / folder).rglob("*"))
        if file.suffix in (".h", ".cpp")
    }


def is_own(included: str) -> bool:
    return included.split("/")[0] in FOLDERS


def reason_against(file: str, included: str) -> str:
    """Returns the reason why `file` must not include `included`; empty if it may."""
    here = layer(file)
    if not is_own(included):
        for prefix, layers in LIBRARIES.items():
            if included.startswith(prefix):
                return "" if {here, str(Path(file).parent)} & layers else f"{prefix} belongs to {', '.join(sorted(layers))}"
        return "" if SYSTEM.fullmatch(included) else "it is in no table of libraries"
    there = layer(included)
    if ORDER.index(there) > ORDER.index(here):
        return f"{there} is above {here}"
    if there == "python" != here:
        return "the Python module is no library"
    if here == there and here in HARNESS_ONLY and family(file) != family(included):
        return f"one {here} includes another"
    if there in HARNESS_ONLY and here not in HARNESS_ONLY:
        return "solvers are reached through the registry"
    return ""


def violations(of: Includes) -> Iterator[str]:
    for file, included in of.items():
        for other in included:
            if why := reason_against(file, other):
                yield f"{file} includes {other}: {why}"


def test_includes_keep_the_total_order_of_layers() -> None:
    found = includes()
    assert sum(map(len, found.values())) > 500
    assert list(violations(found)) == []


def test_every_layer_has_files() -> None:
    assert {layer(file) for file in includes()} == set(ORDER)


def test_no_header_declares_what_only_tests_call() -> None:
    """A header of tests/ declares that, and a .cpp file defines it."""
    headers = [file for file in includes() if file.endswith(".h")]
    spoken = re.compile(r"\b(for|in|only) tests\b", re.IGNORECASE)
    assert [file for file in headers if spoken.search((ROOT / file).read_text("utf-8"))] == []


@pytest.mark.parametrize(
    ("file", "included"),
    [
        ("solvers/mmp/mmp.cpp", "harness/base/error.h"),
        ("solvers/core/mesh.h", "solvers/core/solver.h"),
        ("solvers/core/solver.h", "solvers/paths/paths.h"),
        ("solvers/core/mesh.h", "solvers/mmp/mmp.h"),
        ("solvers/core/mesh.h", "CLI/CLI.hpp"),
        ("solvers/mmp/mmp.cpp", "solvers/chen_han/chen_han.h"),
        ("solvers/mmp/mmp.cpp", "solvers/variants/lazy/lazy.h"),
        ("solvers/variants/lazy/lazy.cpp", "solvers/variants/lazier/lazier.h"),
        ("meshes/defects.cpp", "harness/base/error.h"),
        ("meshes/defects.cpp", "pybind11/numpy.h"),
        ("meshes/load.cpp", "geodesic/geodesic.h"),
        ("meshes/repair.cpp", "OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh"),
        ("python/native/module.cpp", "harness/base/error.h"),
        ("harness/measure/solve_each.cpp", "python/native/background.h"),
        ("harness/run/cell.cpp", "solvers/mmp/mmp.h"),
        ("harness/results/row.h", "harness/run/plan.h"),
        ("harness/base/json.h", "harness/corpus/suite.h"),
        ("harness/results/row.h", "unknown/library.hpp"),
    ],
)
def test_an_include_against_the_order_is_found(file: str, included: str) -> None:
    (line,) = violations({file: [included]})
    assert line.startswith(f"{file} includes {included}: ")


def test_a_variant_composes_families() -> None:
    composed = ["solvers/mmp/mmp.h", "solvers/chen_han/chen_han.h", "solvers/core/solver.h"]
    assert list(violations({"solvers/variants/lazy/lazy.cpp": composed})) == []


def test_peers_see_the_contract_only() -> None:
    adapters = [*ROOT.glob("peers/*.h"), *ROOT.glob("peers/*/*.cpp")]
    own = {a for file in adapters for a, _ in INCLUDE.findall(file.read_text("utf-8")) if is_own(a)}
    assert {layer(file) for file in own} == {"contract"}


def imported(files: Iterable[Path]) -> set[str]:
    """Returns the top-level names of the modules that Python files import."""
    names = set()
    for file in files:
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Import):
                names |= {name.name.split(".")[0] for name in node.names}
            elif isinstance(node, ast.ImportFrom) and node.level == 0:
                names.add(str(node.module).split(".")[0])
    return names


PACKAGES = {
    "results": set[str](),
    "python": set[str](),
    "plots": {"results"},
    "gate": {"results", "plots"},
    "view": {"results", "plots", "fetching"},
    "datasets": {"fetching", "results"},
    "peers": {"fetching", "results"},
}
"""Other packages that a package may import, by Python package. datasets consists of the package `fetching`."""


@pytest.mark.parametrize("package", PACKAGES)
def test_python_packages_keep_their_order(package: str) -> None:
    found = imported((ROOT / package).rglob("*.py"))
    assert "__future__" in found
    assert found & (PACKAGES.keys() | {"fetching"}) - {package} <= PACKAGES[package]


def test_figures_are_drawn_from_files_without_starting_a_program() -> None:
    assert "subprocess" not in imported((ROOT / "plots").glob("*.py"))
