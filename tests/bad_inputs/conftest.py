"""Makes the tables of this folder importable. Fixtures run commands with every program on the PATH."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from shell import ANSWERS, BENCH, HERE, ROOT, SYSTEM_PATH, Bash, Ended  # noqa: E402  (needs the path above)

SCRIPTS = ["run_all.sh", "run_tests.sh", "check_performance.sh", "new_solver.sh"]
MODULES = {"plots": "plots", "check_run.py": "gate.check_run", "report.py": "plots.report"}
"""Python modules that are commands, by the name at the beginning of their messages."""
HILL = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
SECONDS = 300
"""Time limit of a command on a busy machine. No command waits for a user."""


@pytest.fixture(scope="session")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files of a checkout that the scripts need, without the program. The scripts write logs there."""
    copy = tmp_path_factory.mktemp("checkout")
    for name in SCRIPTS:
        shutil.copy(ROOT / name, copy)
    for folder in ("tools", "gate", "plots", "results/published", "solvers/variants/template"):
        shutil.copytree(ROOT / folder, copy / folder, ignore=shutil.ignore_patterns("__pycache__"))
    for file in [ROOT / "results" / "run.schema.json", *(ROOT / "results").glob("*.py")]:
        shutil.copy(file, copy / "results")
    return copy


@pytest.fixture(scope="session")
def programs(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder for the PATH. It has every program by its name, and the commands of bin/."""
    if not BENCH.exists():
        pytest.skip(f"no program at {BENCH}")
    folder = tmp_path_factory.mktemp("bin")
    scripts = [checkout / name for name in SCRIPTS]
    for program in [*scripts, *(HERE / "bin").iterdir(), ROOT / "datasets" / "fetch.py"]:
        # A small script calls each program, because the shell scripts expect the checkout in their own folder.
        bench = f' --bench "{BENCH.resolve()}"' * (program.name == "fetch.py")
        (folder / program.name).write_text(f'#!/bin/sh\nexec "{program}"{bench} "$@"\n')
        (folder / program.name).chmod(0o755)
    for name, module in MODULES.items():
        call = f'PYTHONPATH="$PYTHONPATH:{ROOT}" exec /usr/bin/python3 -m {module} "$@"'
        (folder / name).write_text(f"#!/bin/sh\n{call}\n")
        (folder / name).chmod(0o755)
    (folder / "geodesic-bench").symlink_to(BENCH.resolve())
    return folder


def shell_in(folder: Path, programs: Path, checkout: Path) -> Bash:
    """Returns a function that runs a command in `here`, a new subfolder that contains only a valid mesh."""
    here = folder / "here"
    here.mkdir()
    (here / "hill.obj").write_text(HILL)
    environment = {
        "PATH": f"{programs}:{SYSTEM_PATH}",
        "HOME": str(folder),
        "LC_ALL": "C.UTF-8",
        "GEODESIC_DATASETS": str(folder / "cache"),
        "CHECKOUT": str(checkout),
    }

    def run(command: str) -> Ended:
        return subprocess.run(
            ["bash", "-c", command], cwd=here, env=environment, stdin=subprocess.DEVNULL,
            capture_output=True, text=True, errors="replace", timeout=SECONDS,
        )  # fmt: skip

    return run


@pytest.fixture
def bash(tmp_path: Path, programs: Path, checkout: Path) -> Bash:
    return shell_in(tmp_path, programs, checkout)


@pytest.fixture(scope="session")
def plain(programs: Path, checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder in which the commands of ANSWERS were run with the file name `plain`."""
    folder = tmp_path_factory.mktemp("plain")
    bash = shell_in(folder, programs, checkout)
    for command in ANSWERS:
        ended = bash(command.format("plain"))
        assert ended.returncode == 0, ended
    return folder / "here"
