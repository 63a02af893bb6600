"""The dependency rule of docs/architecture.md, held against what files include and import."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from pages import ROOT

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
SHARED = "solvers/core"
"""With the contract, the files right in solvers/: what every solver and the harness builds on."""
OUTSIDE = ("harness", "meshes", "datasets", "benchmarks", "tests", "examples")
"""What no solver sees."""

Includes = dict[str, list[str]]
"""By file, seen from the root: the files that it includes."""


def part(file: str) -> str:
    """solvers/core of the contract and the core, solvers/<family> of a family, or a folder."""
    top, *below = file.split("/")
    if top != "solvers":
        return top
    return f"solvers/{below[0]}" if len(below) > 1 else SHARED


def is_family(name: str) -> bool:
    return name.startswith("solvers/") and name != SHARED


def includes() -> Includes:
    files = [*ROOT.glob("solvers/**/*"), *ROOT.glob("harness/**/*"), *ROOT.glob("meshes/**/*")]
    return {
        str(file.relative_to(ROOT)): INCLUDE.findall(file.read_text("utf-8"))
        for file in files
        if file.suffix in (".h", ".cpp")
    }


def crossings(of: Includes) -> Iterator[tuple[str, str, str, str]]:
    """(file, its part, included file, that one's part) wherever the parts differ."""
    for file, included in of.items():
        for other in included:
            if part(file) != part(other):
                yield file, part(file), other, part(other)


def violations(of: Includes) -> list[str]:
    """Lines "file includes file: why it must not"."""
    crossed = list(crossings(of))
    composed = {there for _, here, _, there in crossed if is_family(here) and is_family(there)}
    found = []
    for file, here, other, there in crossed:
        why = ""
        if here.startswith("solvers/") and there in OUTSIDE:
            why = "a solver sees nothing but solvers"
        elif here == SHARED and is_family(there):
            why = "the core knows no family"
        elif here == "harness" and is_family(there):
            why = "it names no solver"
        elif here == "meshes" and there != SHARED:
            why = "meshes build on solvers/core alone"
        elif is_family(here) and is_family(there) and here in composed:
            why = f"a variant composes families, but {here} is composed by others itself"
        if why:
            found.append(f"{file} includes {other}: {why}")
    return found


def test_the_includes_keep_the_rule() -> None:
    found = includes()
    assert sum(map(len, found.values())) > 500
    assert violations(found) == []


@pytest.mark.parametrize(
    ("file", "included"),
    [
        ("solvers/mmp/mmp.cpp", "harness/base/error.h"),
        ("solvers/core/mesh.h", "solvers/mmp/orders.h"),
        ("solvers/core/registry.cpp", "solvers/mmp/orders.h"),
        ("harness/cells/cell.cpp", "solvers/mmp/orders.h"),
        ("meshes/generators/cones.cpp", "solvers/mmp/orders.h"),
        ("meshes/load.cpp", "harness/base/error.h"),
    ],
)
def test_an_include_against_the_rule_is_found(file: str, included: str) -> None:
    (line,) = violations({file: [included]})
    assert line.startswith(f"{file} includes {included}: ")


def test_a_variant_composes_families_and_nobody_composes_a_variant() -> None:
    variant: Includes = {"solvers/lazy/lazy.cpp": ["solvers/mmp/orders.h", "solvers/core/solver.h"]}
    assert violations(variant) == []
    (line,) = violations(variant | {"solvers/lazier/lazier.cpp": ["solvers/lazy/lazy.h"]})
    assert line.startswith("solvers/lazy/lazy.cpp includes solvers/mmp/orders.h: a variant")


def imported(files: Iterable[Path]) -> set[str]:
    """Top-level names of the modules that Python files import."""
    names = set()
    for file in files:
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Import):
                names |= {name.name.split(".")[0] for name in node.names}
            elif isinstance(node, ast.ImportFrom) and node.level == 0:
                names.add(str(node.module).split(".")[0])
    return names


MODULES = {
    "plots": {"plots"},
    "gate": {"gate"},
    "results": {"results"},
    "datasets": {"fetch", "fetching"},
}
"""By folder, the names that an import from elsewhere would have."""
USED = {"plots": {"results"}, "gate": {"plots", "results"}}
"""By folder, the folders that it may import; all others meet in files only."""


@pytest.mark.parametrize("folder", MODULES)
def test_python_folders_import_in_one_direction(folder: str) -> None:
    found = imported((ROOT / folder).rglob("*.py"))
    assert "__future__" in found
    for other, modules in MODULES.items():
        assert other in {folder, *USED.get(folder, set())} or not found & modules


def test_figures_are_drawn_from_files_without_starting_a_program() -> None:
    assert "subprocess" not in imported((ROOT / "plots").glob("*.py"))
