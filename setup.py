"""Packs the Python package: CMake compiles its module (python/CMakeLists.txt), and nothing else does.

The environment variable CMAKE_ARGS is added to the command line that configures the build.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from pybind11 import get_cmake_dir
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


def version() -> str:
    found = re.search(r"project\(\w+ VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text("utf-8"))
    assert found is not None
    return found[1]


class BuildByCMake(build_ext):
    def build_extension(self, ext: Extension) -> None:
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        build = Path(self.build_temp).resolve()
        # CMake itself would take make, even where there is none.
        generator = {"CMAKE_GENERATOR": "Ninja"} if shutil.which("ninja") else {}
        for words in (
            [
                "-S", ROOT, "-B", build, "-DGEODESIC_PYTHON=ON", "-DCMAKE_BUILD_TYPE=Release",
                f"-DPython_EXECUTABLE={sys.executable}", f"-Dpybind11_DIR={get_cmake_dir()}",
                *shlex.split(os.environ.get("CMAKE_ARGS", "")),
            ],
            ["--build", build, "--target", "geodesic_python", "--parallel", str(os.cpu_count())],
            ["--install", build, "--component", "python", "--strip", "--prefix", package],
        ):  # fmt: skip
            subprocess.run(["cmake", *words], check=True, env=generator | os.environ)


setup(
    version=version(),
    # setuptools 66 knows no `license = "MIT"` in pyproject.toml, and 77 warns of any other.
    license="MIT",
    packages=["geodesic_bench", "geodesic_bench.results"],
    # One reader of results, whose files plots and gate import as `results`.
    package_dir={"geodesic_bench": "python/geodesic_bench", "geodesic_bench.results": "results"},
    package_data={
        "geodesic_bench": ["py.typed", "*.pyi"],
        "geodesic_bench.results": ["run.schema.json"],
    },
    ext_modules=[Extension("geodesic_bench._native", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
)
