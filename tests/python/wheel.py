#!/usr/bin/python3
"""A wheel is made from the source distribution alone, as `pip install` makes it, and its solvers are
right. A test that takes two minutes, for .ci/nightly."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from python_package import make_source_distribution

FROM_WHEEL = """
import geodesic_bench as gb
from geodesic_bench.results import reader
assert reader.SCHEMA.exists()
mesh = gb.Mesh([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
print(gb.__file__, *{mesh.distances([1], solver=name)[2] for name in gb.solvers()})
"""
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


if __name__ == "__main__":
    sys.exit(pytest.main([__file__, "-q"]))
