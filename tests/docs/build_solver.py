#!/usr/bin/python3
"""build_solver.py FOLDER: builds only solvers/variants/FOLDER of a checkout, as a plug-in. The checkout's
build/release/geodesic-bench loads it from then on. This takes seconds. A build of everything takes
minutes. GEODESIC_BUILD names the build folder of the program under test."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "package"))

from installed import install  # noqa: E402  (needs the path above)

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(OneSolver LANGUAGES CXX)
find_package(GeodesicBench REQUIRED)
find_package(hwy REQUIRED)
# The folder's list file names the target as in the tree.
function(geodesic_add_solver folder)
  _geodesic_add_solver(geodesic_solver_${{folder}} BY_NAME_ONLY ${{ARGN}})
endfunction()
add_subdirectory("{solver}" solver)
"""


def main(folder: str) -> None:
    build = ROOT / "build" / "release" / "one solver"
    prefix = build / "package"
    shutil.rmtree(prefix, ignore_errors=True)
    project = build / "project"
    project.mkdir(parents=True, exist_ok=True)
    (project / "CMakeLists.txt").write_text(PROJECT.format(solver=ROOT / "solvers" / "variants" / folder))
    package = install(Path(os.environ["GEODESIC_BUILD"]), prefix)
    built = package.build(project, build / "build")
    shutil.copy(built / "solver" / f"libgeodesic_solver_{folder}.so", build.parent / "plugin.so")


if __name__ == "__main__":
    main(*sys.argv[1:])
