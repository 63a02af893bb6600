"""check_performance.sh as a command, in small repositories. Nothing of this project is built."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from gate_world import FAKE, WORLD

from gate.__main__ import parse
from gate.builds import BUILD
from gate.findings import ERROR, GOOD, REGRESSION

ROOT = Path(__file__).resolve().parents[2]

Ended = subprocess.CompletedProcess[str]

# Stands in for the build of a revision: installs the fake program with the world of the revision.
CMAKE = f"""#!/bin/sh
test -f broken && {{ echo "main.cpp:7: error: expected ';'"; exit 1; }}
case "$*" in
  --version) echo "cmake version 3.25.1" ;;
  --build*)
    cp fake_bench.py {BUILD}/geodesic-bench
    cp world.json {BUILD}/geodesic-bench.json
    chmod +x {BUILD}/geodesic-bench ;;
  *) mkdir -p {BUILD} ;;
esac
"""


class Repository:
    """A checkout with the scripts, the gate and fake solvers."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / "a path with spaces"
        self.folder.mkdir()
        shutil.copy(ROOT / "check_performance.sh", self.folder)
        for name in ("tools", "gate"):
            shutil.copytree(ROOT / name, self.folder / name)
        (self.folder / "results").mkdir()
        for file in (*(ROOT / "results").glob("*.py"), ROOT / "results" / "run.schema.json"):
            shutil.copy(file, self.folder / "results")
        (self.folder / "datasets").mkdir()
        (self.folder / "datasets" / "fetch.py").write_text("")
        shutil.copy(FAKE, self.folder)
        (self.folder / "CMakeLists.txt").write_text("")
        (self.folder / ".gitignore").write_text("/build/\n__pycache__/\n")
        self.tools = folder / "bin"
        self.tools.mkdir()
        for name, text in {"cmake": CMAKE, "dpkg-query": "#!/bin/sh\nprintf installed\n"}.items():
            (self.tools / name).write_text(text)
            (self.tools / name).chmod(0o755)
        self.set()
        self.git("init", "-q", "-b", "main")
        self.commit()

    def git(self, *words: str) -> None:
        identity = ["-c", "user.name=a", "-c", "user.email=a@b.c"]
        subprocess.run(["git", *identity, *words], cwd=self.folder, check=True)

    def commit(self) -> None:
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", "a revision")

    def set(self, solver: str = "mmp", **facts: object) -> None:
        world = json.loads(json.dumps(WORLD))
        world["solvers"][solver].update(facts)
        (self.folder / "world.json").write_text(json.dumps(world))

    def check(self, *words: str) -> Ended:
        path = f"{self.tools}:{Path(sys.executable).parent}:{os.environ['PATH']}"
        return subprocess.run(
            [self.folder / "check_performance.sh", "--no-install", *words],
            cwd="/", env=dict(os.environ, PATH=path), capture_output=True, text=True, timeout=60,
        )  # fmt: skip


@pytest.fixture
def repository(tmp_path: Path) -> Repository:
    return Repository(tmp_path)


def error_of(ended: Ended) -> str:
    """Returns the line that states the error."""
    assert ended.returncode == ERROR, ended.stdout + ended.stderr
    assert ended.stdout == ""
    return ended.stderr.splitlines()[-1]


def test_good_and_worse_working_trees_against_a_base(repository: Repository) -> None:
    levels = ("main", "--levels", "0,3")
    ended = repository.check(*levels)
    assert ended.returncode == GOOD, ended.stderr
    assert ended.stdout.startswith("good: working tree against main (")
    repository.set(peak_bytes=20_000_000)
    out = repository.folder / "some out"
    ended = repository.check(*levels, f"--out={out}")
    assert ended.returncode == REGRESSION
    assert ended.stdout.splitlines()[1].startswith("  level 3 FAILED: mmp/cube/src:0: peak memory")
    assert (out / "verdict.md").read_text().startswith("## REGRESSION: working tree against main")
    assert json.loads((out / "verdict.json").read_text())["exit_code"] == REGRESSION


def test_all_measures_on_after_a_failure(repository: Repository) -> None:
    repository.set(peak_bytes=20_000_000)
    ended = repository.check("main", "--levels=3,4")
    assert ended.returncode == REGRESSION, ended.stderr
    assert "Level 4. CPU time, interleaved pairs: skipped: level 3 has failed" in ended.stdout
    ended = repository.check("main", "--levels=3,4", "--all")
    assert ended.returncode == REGRESSION, ended.stderr
    assert "Level 4. CPU time, interleaved pairs, margin 1.1: 4 rows compared" in ended.stdout


def test_two_revisions_are_compared_whatever_the_working_tree_holds(repository: Repository) -> None:
    repository.set(peak_bytes=20_000_000)
    repository.commit()
    (repository.folder / "broken").touch()
    ended = repository.check("main~1", "main", "--levels=3")
    assert ended.returncode == REGRESSION, ended.stderr
    assert ended.stdout.startswith("REGRESSION: main (")
    ended = repository.check("main", "main~1", "--levels=3")
    assert ended.returncode == GOOD, ended.stderr


def test_missing_base_says_how_to_get_one(repository: Repository) -> None:
    line = error_of(repository.check("origin/nothing"))
    assert "no revision 'origin/nothing'" in line and "fetch" in line


def test_base_that_does_not_build_is_named_with_its_first_error(repository: Repository) -> None:
    (repository.folder / "broken").touch()
    repository.commit()
    (repository.folder / "broken").unlink()
    out = repository.folder / "out"
    line = error_of(repository.check("main", f"--out={out}"))
    assert "the base, main (" in line and "does not build: main.cpp:7: error" in line
    assert (out / "verdict.md").read_text().startswith("## error: the base, main (")
    assert "base-build.log" in line


def test_no_baseline_says_how_to_make_it_and_its_history_has_the_reasons(repository: Repository) -> None:
    assert "--update-baseline writes it" in error_of(repository.check("main", "--levels=1"))
    ended = repository.check("--update-baseline", "--reason", "the first one")
    assert ended.returncode == GOOD, ended.stderr
    folder = repository.folder / "results" / "baseline"
    assert (folder / "counters.csv").read_text().splitlines()[1] == "ich,cube,0,20000,,,,,,9"

    repository.set(propagations=10_500)
    ended = repository.check("main", "--levels=1")
    assert ended.returncode == REGRESSION and "window_propagations +5.00%" in ended.stdout
    ended = repository.check("--update-baseline", "--reason", "fewer square roots")
    assert "mmp: window_propagations +5.00% to +5.00% on 2 meshes" in ended.stdout
    history = (folder / "CHANGES.md").read_text()
    assert history.index("the first one") < history.index("fewer square roots")
    assert history.index("fewer square roots") < history.index("+5.00% to +5.00%")
    assert repository.check("main", "--levels=1").returncode == GOOD
    again = repository.check("--update-baseline", "--reason", "no change")
    assert "nothing changed" in again.stdout
    assert "no change" not in (folder / "CHANGES.md").read_text()


def test_baseline_of_wrong_answers_is_refused(repository: Repository) -> None:
    repository.set(outcome="wrong answer")
    line = error_of(repository.check("--update-baseline", "--reason", "faster"))
    assert "the baseline stays as it is: mmp/cube/src:0: wrong answer" in line


def test_margin_below_the_measured_noise_is_refused(repository: Repository) -> None:
    noise = repository.folder / "build" / "gate" / "noise.json"
    noise.parent.mkdir(parents=True)
    noise.write_text(json.dumps({"processor": "fake", "noise": {"mmp/cube/src:0": 1.123}}))
    line = error_of(repository.check("main", "--levels=4", "--margin=1.1"))
    assert "the margin 1.1 is below this machine's noise of mmp/cube/src:0, 1.123" in line
    assert "--margin 1.13" in line


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "the base is missing"),
        (["--update-baseline"], "needs --reason"),
        (["main", "--levels", "5"], "levels are 0, 1, 2, 3 and 4"),
        (["main", "--margin", "0.9"], "a margin is a ratio above 1, as in 1.10"),
        (["--a-a", "0"], "at least one session"),
        (["main", "--reason", "why"], "--reason is for --update-baseline"),
        (["main", "--update-baseline", "--reason", "why"], "takes the working tree and the whole suite"),
        (["--a-a", "2", "--all"], "--all is for a comparison with a base"),
        (["--a-a", "2", "a", "b"], "--a-a takes one revision"),
        (["a", "b", "c"], "unrecognized arguments: c"),
    ],
)
def test_wrong_usage_is_one_line_and_exits_1(
    capsys: pytest.CaptureFixture[str], words: list[str], said: str
) -> None:
    with pytest.raises(SystemExit) as ended:
        parse(words)
    error = capsys.readouterr().err
    assert ended.value.code == ERROR and said in error and error.count("\n") == 1
