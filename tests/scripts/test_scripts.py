"""The shell scripts' options and set-up, in a copy of the checkout's scripts; nothing is built."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = ["run_all.sh", "run_tests.sh", "check_performance.sh", "tests/fuzz/fuzz.sh"]

Ended = subprocess.CompletedProcess[str]


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """What the scripts need, without solvers, in a folder whose name has spaces."""
    copy = tmp_path / "a path with spaces"
    copy.mkdir()
    for name in SCRIPTS:
        (copy / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, copy / name)
    for folder in ["tools", "plots", "results/published"]:
        shutil.copytree(ROOT / folder, copy / folder)
    for file in [ROOT / "results" / "run.schema.json", *(ROOT / "results").glob("*.py")]:
        shutil.copy(file, copy / "results")
    return copy


@pytest.fixture
def fake_path(tmp_path: Path) -> Callable[..., dict[str, str]]:
    """fake_path(name="script", ...) is an environment whose PATH has the basic tools and these."""

    def make(**commands: str) -> dict[str, str]:
        folder = tmp_path / "bin"
        folder.mkdir()
        for tool in "bash cat date dirname grep head id mkdir sed tail tee".split():
            (folder / tool).symlink_to(str(shutil.which(tool)))
        for name, text in commands.items():
            file = folder / name.replace("_", "-")
            file.unlink(missing_ok=True)
            file.write_text(f"#!/bin/bash\n{text}\n")
            file.chmod(0o755)
        return {"PATH": str(folder)}

    return make


def run(script: Path, *arguments: str, env: dict[str, str] | None = None, cwd: str = "/") -> Ended:
    return subprocess.run(
        [script, *arguments],
        env=env,
        cwd=cwd,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=60,
    )


@pytest.mark.parametrize("script", SCRIPTS)
def test_help_lists_every_option_from_any_folder(checkout: Path, script: str) -> None:
    ended = run(checkout / script, "--help")
    assert ended.returncode == 0 and ended.stderr == ""
    text = (checkout / script).read_text()
    steps = ["build", "peers", "fetch", "run", "check", "plot"] if script == "run_all.sh" else []
    options = [word for word in ["--corpus", "--preset", "--out", "--run", "--jobs"] if f"{word})" in text]
    for word in ["--no-install", "--help", *steps, *options]:
        assert word in ended.stdout


@pytest.mark.parametrize("script", SCRIPTS)
def test_unknown_option_names_the_help(checkout: Path, script: str) -> None:
    ended = run(checkout / script, "--fast")
    name = Path(script).name
    says = f"{name}: unknown option --fast; see {name} --help\n"
    assert (ended.returncode, ended.stderr) == (1, says)


def test_a_command_on_a_release_of_debian_is_refused_in_one_line(
    checkout: Path, fake_path: Callable[..., dict[str, str]]
) -> None:
    script = checkout / "tools/on_debian.sh"
    for words, says in {
        (): "needs a release and a command; see on_debian.sh --help",
        ("trixie",): "needs a release and a command; see on_debian.sh --help",
        ("--fast", "trixie", "true"): "unknown option --fast; see on_debian.sh --help",
        ("--roots", "--mirror"): "--roots needs a value; see on_debian.sh --help",
        ("../etc", "true"): "a release is a name such as trixie, not '../etc'",
    }.items():
        ended = run(script, *words)
        assert (ended.returncode, ended.stderr) == (1, f"on_debian.sh: {says}\n")
    environment = fake_path(id='echo "$USER_ID"')
    for user, says in {
        "1000": "needs root, for debootstrap, mount and chroot",
        "0": "needs debootstrap (Debian's package debootstrap)",
    }.items():
        ended = run(script, "trixie", "true", env=environment | {"USER_ID": user})
        assert (ended.returncode, ended.stderr) == (1, f"on_debian.sh: {says}\n")
    assert not (checkout / "build").exists()


def test_unknown_step_lists_the_steps(checkout: Path) -> None:
    ended = run(checkout / "run_all.sh", "biuld")
    assert ended.returncode == 1
    assert "unknown step biuld; steps are build peers fetch run check plot" in ended.stderr


def test_unknown_preset_lists_the_presets(checkout: Path) -> None:
    ended = run(checkout / "run_tests.sh", "--preset=fast")
    assert ended.returncode == 1 and "presets are ci debug release" in ended.stderr


@pytest.mark.parametrize(
    "option",
    ["--corpus", "--out", "--run", "--meshes", "--solvers", "--sources", "--repetitions"],
)
def test_option_without_value_is_an_error(checkout: Path, option: str) -> None:
    for arguments in ([option], [option, "--no-install"]):
        ended = run(checkout / "run_all.sh", *arguments)
        assert ended.returncode == 1 and f"{option} needs a value" in ended.stderr


@pytest.mark.parametrize("option", ["--sources", "--repetitions"])
@pytest.mark.parametrize("number", ["0", "-1", "two"])
def test_counts_must_be_positive_numbers(checkout: Path, option: str, number: str) -> None:
    ended = run(checkout / "run_all.sh", option, number)
    assert ended.returncode == 1
    assert f"{option} must be a positive integer, not '{number}'" in ended.stderr


@pytest.mark.parametrize("number", ["0", "-1", "two", "99999999"])
@pytest.mark.parametrize("option", ["--seconds", "--jobs"])
def test_fuzzing_takes_positive_numbers_and_known_targets(
    checkout: Path, option: str, number: str
) -> None:
    ended = run(checkout / "tests/fuzz/fuzz.sh", option, number)
    assert ended.returncode == 1
    assert f"{option} must be a positive integer, not '{number}'" in ended.stderr
    ended = run(checkout / "tests/fuzz/fuzz.sh", "of")
    assert ended.returncode == 1 and "unknown target of; targets are manifest" in ended.stderr


@pytest.mark.parametrize("script", SCRIPTS)
def test_no_install_prints_the_line_that_would_and_stops(
    checkout: Path, fake_path: Callable[..., dict[str, str]], script: str
) -> None:
    env = fake_path(dpkg_query="exit 1", apt_get="echo installed >&2")
    ended = run(checkout / script, "--no-install", env=env)
    assert ended.returncode == 1 and "installed" not in ended.stderr
    line = ended.stderr.splitlines()[-1]
    assert line.startswith("  sudo apt-get install --no-install-recommends ")
    assert {"g++", "cmake", "ninja-build", "libcli11-dev"} <= set(line.split())


def test_without_root_and_sudo_the_line_is_printed(
    checkout: Path, fake_path: Callable[..., dict[str, str]]
) -> None:
    env = fake_path(dpkg_query="exit 1", id="echo 1000", apt_get="exit 0")
    ended = run(checkout / "run_all.sh", "build", env=env)
    assert ended.returncode == 1 and "sudo apt-get install" in ended.stderr


def test_root_installs_what_is_missing_and_failure_shows_apts_words(
    checkout: Path, fake_path: Callable[..., dict[str, str]]
) -> None:
    env = fake_path(
        dpkg_query="exit 1",
        id="echo 0",
        env='shift; exec "$@"',
        apt_get='echo "apt was asked: $*"; [[ $* == *update* ]]',
    )
    ended = run(checkout / "run_all.sh", "build", env=env)
    assert ended.returncode == 1
    assert "apt was asked: -y" in ended.stderr and "install --no-install" in ended.stderr
    assert "apt-get could not install: g++" in ended.stderr


def test_steps_that_need_the_program_say_how_to_get_it(checkout: Path) -> None:
    for step in ["fetch", "run"]:
        ended = run(checkout / "run_all.sh", step, "--no-install")
        assert ended.returncode == 1 and "run ./run_all.sh build" in ended.stderr


def test_check_and_plot_without_any_run_say_how_to_get_one(checkout: Path) -> None:
    for step in ["check", "plot"]:
        ended = run(checkout / "run_all.sh", step, "--no-install")
        assert ended.returncode == 1 and "start one with ./run_all.sh run" in ended.stderr


def test_plot_alone_draws_the_newest_run_twice_in_a_row(checkout: Path) -> None:
    folder = checkout / "results" / "runs" / "20260102T030405Z-golden"
    shutil.copytree(ROOT / "tests" / "plots" / "golden" / "run", folder)
    (checkout / "results" / "runs" / "20250101T000000Z-older").mkdir()
    for _ in range(2):
        ended = run(checkout / "run_all.sh", "plot", "--no-install")
        assert ended.returncode == 0, ended.stderr
        assert ended.stdout.splitlines()[-1].endswith(f": {folder}/report.html")
    assert (folder / "tables" / "table_5_2.md").exists()
    assert (folder / "figures" / "speedup.pdf").exists()
    assert (folder / "report.html").exists()
    assert "plot: done" in (checkout / "build" / "logs" / "run_all.log").read_text()


def test_failed_check_still_draws_the_tables_and_ends_in_error(checkout: Path) -> None:
    shutil.copytree(ROOT / "tests" / "plots" / "golden" / "run", checkout / "my run")
    arguments = ["check", "plot", "--no-install", "--run", "my run"]
    ended = run(checkout / "run_all.sh", *arguments, cwd=str(checkout))
    assert ended.returncode == 1 and "check failed" in ended.stderr
    assert "FAILED: ich/rocker-arm/src:4711" in ended.stdout
    assert (checkout / "my run" / "tables" / "table_5_1.tex").exists()


def test_an_old_run_is_redrawn_where_it_is_without_the_program(checkout: Path) -> None:
    shutil.copytree(ROOT / "tests" / "plots" / "golden" / "run", checkout / "old run")
    ended = run(checkout / "run_all.sh", "plot", "--no-install", "--run", str(checkout / "old run"))
    assert ended.returncode == 0, ended.stderr
    assert (checkout / "old run" / "report.html").exists()
    assert not (checkout / "results" / "runs").exists()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["plot", "--out", "x"], "check and plot take --run DIR"),
        (["run", "plot", "--run", "x"], "run writes to --out DIR"),
        (["run", "--resume", "x", "--out", "y"], "--out cannot be used with --resume"),
        (["plot", "--resume", "x"], "--out and --resume are for run"),
        (["plot", "--run", "x", "--no-install"], "no such folder"),
    ],
)
def test_the_folder_to_write_and_the_one_to_read_are_not_confused(
    checkout: Path, arguments: list[str], words: str
) -> None:
    ended = run(checkout / "run_all.sh", *arguments)
    assert ended.returncode == 1 and words in ended.stdout + ended.stderr


def test_run_folder_that_holds_results_is_not_written_to(checkout: Path) -> None:
    bench = checkout / "build" / "release" / "geodesic-bench"
    bench.parent.mkdir(parents=True)
    bench.write_text("#!/bin/bash\nexit 0\n")
    bench.chmod(0o755)
    shutil.copytree(ROOT / "tests" / "plots" / "golden" / "run", checkout / "old")
    ended = run(checkout / "run_all.sh", "run", "--no-install", "--out", str(checkout / "old"))
    assert ended.returncode == 1 and "already contains a run" in ended.stderr


def test_an_interrupted_run_names_the_command_that_continues_it(checkout: Path) -> None:
    bench = checkout / "build" / "release" / "geodesic-bench"
    bench.parent.mkdir(parents=True)
    bench.write_text(
        '#!/bin/bash\necho "asked: $*"\nmkdir -p "${@: -1}"; echo > "${@: -1}/request.json"\n'
        "exit 130"
    )
    bench.chmod(0o755)
    out = checkout / "a run"
    ended = run(checkout / "run_all.sh", "run", "--no-install", "--out", str(out))
    assert ended.returncode == 130
    assert f"To continue: {checkout}/run_all.sh run --preset release --resume '{out}'" in ended.stdout
    ended = run(checkout / "run_all.sh", "run", "--no-install", "--resume", str(out))
    assert f"asked: run --resume {out}\n" in ended.stdout


def test_options_reach_the_program(checkout: Path) -> None:
    bench = checkout / "build" / "release" / "geodesic-bench"
    bench.parent.mkdir(parents=True)
    bench.write_text(
        '#!/bin/bash\necho "asked: $*"\nmkdir -p "${@: -1}"; echo > "${@: -1}/run.json"'
    )
    bench.chmod(0o755)
    out = checkout / "new run"
    ended = run(
        checkout / "run_all.sh", "run", "--no-install", "--corpus=tiny", "--solvers", "mmp,ich",
        "--meshes", "cube", "--repetitions", "2", "--out", str(out), env=dict(os.environ),
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    asked = f"run --corpus tiny --meshes cube --repetitions 2 --solvers mmp,ich --out {out}"
    assert f"asked: {asked}" in ended.stdout
    assert ended.stdout.splitlines()[-1] == f"Results: {out}/run.json"


def test_peers_are_built_and_run_beside_the_solvers(checkout: Path) -> None:
    bench = checkout / "build" / "release" / "geodesic-bench"
    bench.parent.mkdir(parents=True)
    bench.write_text(
        '#!/bin/bash\necho "asked: $*"\nmkdir -p "${@: -1}"; echo > "${@: -1}/run.json"'
    )
    bench.chmod(0o755)
    build = checkout / "peers" / "build.py"
    build.parent.mkdir()
    build.write_text(
        "import sys\nwords = sys.argv[3:]\n"
        "at = words.index('--words') + 1 if '--words' in words else 0\n"
        "print(f'--plugin\\nvtp.so\\n--solvers\\n{words[at]},vtp' if at else words)"
    )
    build.chmod(0o755)
    installed = checkout / "bin"
    installed.mkdir()
    for name in ("dpkg-query", "patch"):
        (installed / name).write_text("#!/bin/bash\necho -n installed\n")
        (installed / name).chmod(0o755)
    env = dict(os.environ, PATH=f"{installed}:{os.environ['PATH']}")
    ended = run(
        checkout / "run_all.sh", "peers", "run", "--no-install", "--peers", "vtp,pvtp",
        "--solvers", "mmp", "--out", str(checkout / "new"), env=env,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    assert "['vtp', 'pvtp']" in ended.stdout
    assert "asked: run --corpus standard --plugin vtp.so --solvers mmp,vtp --out" in ended.stdout

    suite = checkout / "harness" / "suites" / "tiny.json"
    suite.parent.mkdir(parents=True)
    suite.write_text('{"solvers": ["mmp", "steiner?points=1,3"]}')
    ended = run(
        checkout / "run_all.sh", "run", "--no-install", "--peers", "vtp", "--corpus", "tiny",
        "--out", str(checkout / "newer"), env=env,
    )  # fmt: skip
    assert f"asked: run {suite} --plugin vtp.so --solvers mmp,steiner?points=1,3,vtp" in ended.stdout


CTEST = (
    '<testsuite name="x"\n\ttests="4"\n\tfailures="{failures}"\n'
    '\tdisabled="0"\n\tskipped="1"\n\t>'
)
PYTEST = '<testsuites><testsuite name="pytest" errors="0" failures="0" skipped="2" tests="9">'


@pytest.fixture
def ci(checkout: Path) -> Callable[..., Ended]:
    """ci(ctest, tests, job, fuzzing) runs .ci/run with stand-ins for the scripts, which end with the
    exit codes `tests`, `job` and `fuzzing`."""
    (checkout / ".ci").mkdir()
    shutil.copy(ROOT / ".ci" / "run", checkout / ".ci")

    def start(ctest: str, tests: str, job: str, fuzzing: str = "0") -> Ended:
        reports = checkout / "reports"
        reports.mkdir()
        (reports / "ctest.xml").write_text(ctest)
        (reports / "pytest.xml").write_text(PYTEST)
        logs = '"$(dirname "$0")"/build/logs'
        copy = f'mkdir -p {logs}; cp "$(dirname "$0")"/reports/* {logs}'
        (checkout / "run_tests.sh").write_text(f"#!/bin/bash\n{copy}; exit {tests}\n")
        (checkout / "run_all.sh").write_text(f'#!/bin/bash\necho "asked: $*"; exit {job}\n')
        (checkout / "tests/fuzz/fuzz.sh").write_text(f"#!/bin/bash\necho fuzzed; exit {fuzzing}\n")
        slurm = checkout / "tests" / "slurm" / "slurm.sh"
        slurm.parent.mkdir()
        slurm.write_text("#!/bin/bash\necho queued\n")
        slurm.chmod(0o755)
        return run(checkout / ".ci" / "run")

    return start


def test_ci_ends_with_the_number_of_tests(ci: Callable[..., Ended]) -> None:
    ended = ci(CTEST.format(failures=0), "0", "0")
    assert ended.returncode == 0
    assert "3 tests skipped" in ended.stdout
    assert ended.stdout.splitlines()[-1] == "15 passed, 0 failed"
    assert "queued" in ended.stdout
    assert "asked: --preset ci --corpus tiny --repetitions 2" in ended.stdout


def test_ci_fails_with_a_failed_test_and_still_runs_the_job(ci: Callable[..., Ended]) -> None:
    ended = ci(CTEST.format(failures=1), "1", "0")
    assert ended.returncode == 1 and "asked:" in ended.stdout
    assert ended.stdout.splitlines()[-1] == "13 passed, 2 failed"


def test_ci_fails_with_a_failed_job(ci: Callable[..., Ended]) -> None:
    ended = ci(CTEST.format(failures=0), "0", "1")
    assert ended.returncode == 1
    assert ended.stdout.splitlines()[-1] == "13 passed, 2 failed"


def test_ci_says_so_where_the_public_codes_cannot_be_had(ci: Callable[..., Ended]) -> None:
    ended = ci(CTEST.format(failures=0), "0", "$([[ $1 == peers ]] && echo 3 || echo 0)")
    assert ended.returncode == 0
    assert "== not run: the public codes libigl-exact,pvtp cannot be had here" in ended.stdout


def test_ci_fails_with_a_finding_and_still_runs_the_job(ci: Callable[..., Ended]) -> None:
    ended = ci(CTEST.format(failures=0), "0", "0", "1")
    assert ended.returncode == 1 and "asked:" in ended.stdout
    assert ended.stdout.splitlines()[-1] == "14 passed, 1 failed"


def build_with_fake_cmake(checkout: Path, tmp_path: Path, version: str) -> Ended:
    cmake = tmp_path / "bin" / "cmake"
    cmake.parent.mkdir()
    answer = f'[[ $1 == --version ]] && echo "cmake version {version}" || echo "asked: $*"'
    cmake.write_text(f"#!/bin/bash\n{answer}\n")
    cmake.chmod(0o755)
    env = dict(os.environ, PATH=f"{cmake.parent}:{os.environ['PATH']}")
    return run(checkout / "run_all.sh", "build", "--no-install", env=env)


@pytest.mark.parametrize(("made_in", "fresh"), [("/somewhere/else", True), (None, False)])
def test_build_folder_made_elsewhere_is_configured_afresh(
    checkout: Path, tmp_path: Path, made_in: str | None, fresh: bool
) -> None:
    build = checkout / "build" / "release"
    build.mkdir(parents=True)
    (build / "CMakeCache.txt").write_text(f"CMAKE_CACHEFILE_DIR:INTERNAL={made_in or build}\n")
    ended = build_with_fake_cmake(checkout, tmp_path, "3.25.1")
    assert ended.returncode == 0, ended.stderr
    assert ("asked: --fresh --preset release" in ended.stdout) == fresh
    assert "asked: --build --preset release" in ended.stdout


def test_cmake_that_is_too_old_is_named(checkout: Path, tmp_path: Path) -> None:
    ended = build_with_fake_cmake(checkout, tmp_path, "3.22.1")
    assert ended.returncode == 1 and "cmake 3.22.1 is too old" in ended.stderr
