"""Options and set-up of the shell scripts, in a copy of them. Nothing is built."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).resolve().parents[2]
BENCH = Path(os.environ.get("GEODESIC_BENCH") or ROOT / "build" / "release" / "geodesic-bench")
SCRIPTS = ["run_all.sh", "run_tests.sh", "check_performance.sh", "tests/fuzz/fuzz.sh", "tools/lint.sh"]
KNOWN_BY = [
    "datasets/manifest.json", "peers/vtp/adapter.cpp", "peers/pvtp/adapter.cpp",
    "solvers/mmp/mmp.cpp", "solvers/chen_han/chen_han.cpp",
]  # fmt: skip
"""Files that say which names there are."""
GOLDEN = ROOT / "tests" / "plots" / "golden" / "run"

Ended = subprocess.CompletedProcess[str]
FakePath = Callable[..., dict[str, str]]


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """The files that the scripts need, in a folder whose name has spaces."""
    copy = tmp_path / "a path with spaces"
    copy.mkdir()
    for name in [*SCRIPTS, "new_solver.sh", *KNOWN_BY]:
        (copy / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, copy / name)
    for folder in ["tools", "gate", "plots", "results/published"]:
        shutil.copytree(ROOT / folder, copy / folder, dirs_exist_ok=True)
    for file in [ROOT / "results" / "run.schema.json", *(ROOT / "results").glob("*.py")]:
        shutil.copy(file, copy / "results")
    return copy


def program(file: Path, text: str) -> Path:
    """Writes a Bash script. Replaces an existing file."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.unlink(missing_ok=True)
    file.write_text(f"#!/bin/bash\n{text}\n")
    file.chmod(0o755)
    return file


@pytest.fixture
def fake_path(tmp_path: Path) -> FakePath:
    """fake_path(name="script", ...) returns an environment whose PATH has the basic tools and these scripts."""

    def make(**commands: str) -> dict[str, str]:
        folder = tmp_path / "bin"
        folder.mkdir()
        for tool in "bash cat date dirname grep head id mkdir sed tail tee".split():
            (folder / tool).symlink_to(str(shutil.which(tool)))
        for name, text in commands.items():
            program(folder / name.replace("_", "-"), text)
        return {"PATH": str(folder)}

    return make


def before_others(command: Path) -> dict[str, str]:
    """Returns an environment whose PATH begins with the folder of the command."""
    return dict(os.environ, PATH=f"{command.parent}:{os.environ['PATH']}")


def bench(checkout: Path, writes: str = "run.json", code: int = 0) -> None:
    """Replaces geodesic-bench by a script that prints its arguments and writes a file into the last one, a folder."""
    program(checkout / "build" / "release" / "geodesic-bench",
            f'echo "asked: $*"\nmkdir -p "${{@: -1}}"; echo >"${{@: -1}}/{writes}"; exit {code}')  # fmt: skip


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


@pytest.mark.parametrize("script", [*SCRIPTS, "new_solver.sh"])
def test_help_lists_every_option_from_any_folder(checkout: Path, script: str) -> None:
    ended = run(checkout / script, "--help")
    assert ended.returncode == 0 and ended.stderr == ""
    text = (checkout / script).read_text()
    words = {
        "run_all.sh": ["build", "peers", "fetch", "run", "check", "plot"],
        "check_performance.sh": ["2 wrong answer", "4 not"],
        "new_solver.sh": ["template", "edge-based", "mmp", "chen-han"],
    }
    cases = re.findall(r"^ +((?:--[a-z-]+[ |\\\n]*)+)\)", text, re.MULTILINE)
    options = re.findall(r"--[a-z-]+", " ".join(cases))
    if "\ninstall=" in text:
        options.append("--no-install")
    for word in ["--help", *options, *words.get(script, [])]:
        assert word in ended.stdout


@pytest.mark.parametrize("script", [*SCRIPTS, "new_solver.sh"])
def test_unknown_option_names_the_help(checkout: Path, script: str) -> None:
    ended = run(checkout / script, "--fast")
    name = Path(script).name
    says = f"{name}: unknown option --fast; see {name} --help\n"
    assert (ended.returncode, ended.stderr) == (1, says)


def test_a_command_on_a_release_of_debian_is_refused_in_one_line(checkout: Path) -> None:
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
    assert not (checkout / "build").exists()


@pytest.mark.parametrize(
    ("commands", "says"),
    [
        ({"id": "echo 1000"}, "needs root, for debootstrap, mount and chroot"),
        (
            {"id": "echo 0", "unshare": "exit 1"},
            "may not mount here (CAP_SYS_ADMIN is needed; a container: --privileged)",
        ),
    ],
)
def test_where_no_chroot_can_be_made_the_exit_code_is_77(
    checkout: Path, fake_path: FakePath, commands: dict[str, str], says: str
) -> None:
    ended = run(checkout / "tools/on_debian.sh", "--bare", "trixie", "true", env=fake_path(**commands))
    assert (ended.returncode, ended.stderr) == (77, f"on_debian.sh: {says}\n")
    assert not (checkout / "build").exists()


OF_RUN_ALL = "corpus preset folder peers solvers meshes sources out run resume external plugin seed".split()
NO_NUMBERS = [("--sources", "0"), ("--sources", "-1"), ("--repetitions", "two"), ("--sources", "99999999")]


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ("run_all.sh biuld", "unknown step biuld; steps are build peers fetch run check plot"),
        ("run_tests.sh --preset=fast", "unknown preset fast; presets are release ci debug"),
        ("run_all.sh --preset debug", "unknown preset debug; presets are release ci"),
        *((f"run_all.sh --{option} --no-install", f"--{option} needs a value") for option in OF_RUN_ALL),
        ("run_all.sh --out", "--out needs a value"),
        ("check_performance.sh --out", "--out needs a value"),
        *((f"run_all.sh {option} {number}", f"{option} must be a positive integer, not '{number}'")
          for option, number in NO_NUMBERS),
        ("tests/fuzz/fuzz.sh --seconds 0", "--seconds must be a positive integer, not '0'"),
        ("tests/fuzz/fuzz.sh --jobs=two", "--jobs must be a positive integer, not 'two'"),
        ("tests/fuzz/fuzz.sh of", "unknown target of; targets are manifest"),
        ("run_all.sh fetch --no-install", "run ./run_all.sh build"),
        ("run_all.sh run --no-install", "run ./run_all.sh build"),
        ("run_all.sh check --no-install", "start one with ./run_all.sh run"),
        ("run_all.sh plot --no-install", "start one with ./run_all.sh run"),
        ("run_all.sh plot --out x", "check and plot take --run DIR"),
        ("run_all.sh run plot --run x", "run writes to --out DIR"),
        ("run_all.sh run --resume x --out y", "--out cannot be used with --resume"),
        ("run_all.sh plot --resume x", "--out and --resume are for run"),
    ],
)  # fmt: skip
def test_what_cannot_be_done_is_refused_with_the_reason(checkout: Path, words: str, says: str) -> None:
    script, *arguments = words.split()
    ended = run(checkout / script, *arguments)
    assert ended.returncode == 1 and says in ended.stderr


def test_a_folder_that_is_no_run_is_named(checkout: Path) -> None:
    ended = run(checkout / "run_all.sh", "plot", "--run", "x", "--no-install")
    assert ended.returncode == 1 and "no such folder" in ended.stdout + ended.stderr


@pytest.mark.parametrize("script", SCRIPTS)
def test_no_install_prints_the_line_that_would_and_stops(
    checkout: Path, fake_path: FakePath, script: str
) -> None:
    env = fake_path(dpkg_query="exit 1", apt_get="echo installed >&2")
    ended = run(checkout / script, "--no-install", env=env)
    assert ended.returncode == 1 and "installed" not in ended.stderr
    line = ended.stderr.splitlines()[-1]
    assert line.startswith("  sudo apt-get install --no-install-recommends ")
    of_builds = {"g++", "cmake", "ninja-build", "libcli11-dev"}
    assert ({"mypy"} if script == "tools/lint.sh" else of_builds) <= set(line.split())


def test_without_root_and_sudo_the_line_is_printed(checkout: Path, fake_path: FakePath) -> None:
    env = fake_path(dpkg_query="exit 1", id="echo 1000", apt_get="exit 0")
    ended = run(checkout / "run_all.sh", "build", env=env)
    assert ended.returncode == 1 and "sudo apt-get install" in ended.stderr


def test_root_installs_what_is_missing_and_failure_shows_apts_words(
    checkout: Path, fake_path: FakePath
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


def test_plot_alone_draws_the_newest_run_over_what_was_drawn_before(checkout: Path) -> None:
    folder = checkout / "results" / "runs" / "20260102T030405Z-golden"
    shutil.copytree(GOLDEN, folder)
    (folder / "tables").mkdir()
    for file in (folder / "report.html", folder / "tables" / "performance.md"):
        file.write_text("old")
    (checkout / "results" / "runs" / "20250101T000000Z-older").mkdir()
    ended = run(checkout / "run_all.sh", "plot", "--no-install")
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.splitlines()[-1].endswith(f": {folder}/report.html")
    for file in (folder / "report.html", folder / "tables" / "performance.md"):
        assert file.read_text() != "old"
    assert (folder / "figures" / "speedup.pdf").exists()
    assert "plot: done" in (checkout / "build" / "logs" / "run_all.log").read_text()


def test_one_figure_and_one_table_are_drawn_alone(checkout: Path) -> None:
    shutil.copytree(GOLDEN, checkout / "my run")
    words = ["plot", "--no-install", "--run", "my run", "--only", "times,speedup"]
    ended = run(checkout / "run_all.sh", *words, cwd=str(checkout))
    assert ended.returncode == 0, ended.stderr
    assert "/my run/figures/speedup.png (also .pdf, .md)" in ended.stdout and "report.html" not in ended.stdout
    drawn = {file.stem for folder in ("tables", "figures") for file in (checkout / "my run" / folder).iterdir()}
    assert drawn == {"times", "speedup"}


def test_failed_check_still_draws_an_old_run_where_it_is_and_ends_in_error(checkout: Path) -> None:
    shutil.copytree(GOLDEN, checkout / "my run")
    (checkout / "plots" / "report.py").write_text(
        "import pathlib, sys\npathlib.Path(sys.argv[1], 'report.html').touch()\n"
    )
    arguments = ["check", "plot", "--no-install", "--run", "my run"]
    ended = run(checkout / "run_all.sh", *arguments, cwd=str(checkout))
    assert ended.returncode == 1 and "check failed" in ended.stderr
    assert "FAILED: ich/rocker-arm/src:4711" in ended.stdout
    assert (checkout / "my run" / "report.html").exists()
    assert not (checkout / "results" / "runs").exists()


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ("--corpsu quick", "unknown option --corpsu (did you mean --corpus?)"),
        ("--corpus quik", "--corpus: no corpus named 'quik' (did you mean 'quick'?)"),
        ("--solvers mmp,mpm", "--solvers: no solver named 'mpm' (did you mean 'mmp'?)"),
        ("--solvers mmp?k=1,x,mmp --meshes hors", "--meshes: no mesh named 'hors' (did you mean 'horse'?)"),
        ("--peers foo", "--peers: no peer named 'foo'"),
        ("--folder nowhere", "--folder: no such folder: "),
        ("--resume plots", "/plots has no request.json: no run began there"),
        ("--only spedup", "--only: no table or figure named 'spedup' (did you mean 'speedup'?)"),
        ("build --only speedup", "--only is for plot"),
        ("plot --run plots", "/plots has no run.json: it is no run that has ended"),
    ],
)  # fmt: skip
def test_names_and_folders_are_checked_before_the_first_step(
    checkout: Path, words: str, says: str
) -> None:
    ended = run(checkout / "run_all.sh", *words.split(), "--no-install", cwd=str(checkout))
    assert ended.returncode == 1 and says in ended.stderr and ended.stderr.count("\n") == 1
    assert ended.stdout == ""


def test_run_folder_that_holds_results_is_not_written_to(checkout: Path) -> None:
    bench(checkout)
    shutil.copytree(GOLDEN, checkout / "old")
    ended = run(checkout / "run_all.sh", "run", "--no-install", "--out", str(checkout / "old"))
    assert ended.returncode == 1 and "already contains a run" in ended.stderr


def test_an_interrupted_run_names_the_command_that_continues_it(checkout: Path) -> None:
    bench(checkout, "request.json", 130)
    out = checkout / "a run"
    options = ["run", "--no-install", "--corpus", "tiny", "--solvers=mmp"]
    ended = run(checkout / "run_all.sh", *options, "--out", str(out))
    assert ended.returncode == 130
    (hint,) = re.findall("To continue: (.*)", ended.stdout)
    assert shlex.split(hint) == [f"{checkout}/run_all.sh", *options, "--resume", str(out)]
    ended = run(checkout / "run_all.sh", "run", "--no-install", "--resume", str(out))
    assert f"asked: run --resume {out}\n" in ended.stdout


def test_every_option_of_run_is_one_of_the_main_job_too(checkout: Path) -> None:
    left = {"--shard": "merged runs (docs/clusters.md)", "--program": "of the gate", "--plan": "prints only",
            "--benchmark": "flags of Google Benchmark", "--manifest": "fetch reads the manifest of the checkout"}  # fmt: skip
    helps = [subprocess.run(words, capture_output=True, text=True, check=True).stdout
             for words in ([str(BENCH), "run", "--help"], [str(checkout / "run_all.sh"), "--help"])]  # fmt: skip
    of_run, of_job = (set(re.findall(r"--[a-z][a-z-]*", text.partition("\nExamples")[0])) for text in helps)
    assert of_run - of_job == {*left}
    words = ["--seed=5", "--interleave", "--external", "mine=a {mesh}", "--solvers", "mine"]
    bench(checkout)
    ended = run(checkout / "run_all.sh", "run", "--no-install", "--out", str(checkout / "x"), *words)
    asked = f"--seed 5 --interleave --external mine=a {{mesh}} --solvers mine --out {checkout}/x"
    assert f"asked: run --corpus standard {asked}\n" in ended.stdout, ended.stderr


def test_every_solver_is_known_before_the_program_is_built() -> None:
    listed = subprocess.run([BENCH, "list"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"^  ([a-z][a-z-]*)  ", listed.partition("\n\n")[0], re.MULTILINE)[1:]
    assert {"edge-based", "straight-graph", "saddle-vertex-graph"} <= {*names}
    ended = run(ROOT / "tools" / "check_words.py", "--solvers", ",".join(names))
    assert ended.returncode == 0, ended.stderr


def test_the_recorded_command_is_that_of_the_main_job_without_its_folder(checkout: Path) -> None:
    program(checkout / "build/release/geodesic-bench", 'echo "recorded: $GEODESIC_COMMAND"; exit 1')
    words = ["run", "--no-install", "--meshes", "scans/a b.ply,cube", "--out", str(checkout / "x"), "--sources", "2"]
    ended = run(checkout / "run_all.sh", *words)
    assert "recorded: ./run_all.sh run --no-install --meshes scans/a\\ b.ply\\,cube --sources 2\n" in ended.stdout


def test_options_reach_the_program(checkout: Path) -> None:
    bench(checkout)
    out = checkout / "new run"
    ended = run(
        checkout / "run_all.sh", "run", "--no-install", "--corpus=tiny", "--solvers", "mmp,ich",
        "--meshes", "cube", "--repetitions", "2", "--out", str(out), env=dict(os.environ),
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    asked = f"run --meshes cube --repetitions 2 --solvers mmp,ich --out {out}"
    assert f"asked: {asked}" in ended.stdout
    assert ended.stdout.splitlines()[-1] == f"Results: {out}/run.json"


def test_peers_are_built_and_run_beside_the_solvers(checkout: Path) -> None:
    bench(checkout)
    build = checkout / "peers" / "build.py"
    build.write_text(
        "import sys\nwords = sys.argv[3:]\n"
        "at = words.index('--words') + 1 if '--words' in words else 0\n"
        "print(f'--plugin\\nvtp.so\\n--solvers\\n{words[at]},vtp' if at else words)"
    )
    env = before_others(program(checkout / "bin" / "dpkg-query", "echo -n installed"))
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
    assert "asked: run --corpus tiny --plugin vtp.so --solvers mmp,steiner?points=1,3,vtp" in ended.stdout


CTEST = """<testsuite name="x"\n\ttests="4"\n\tfailures="1"\n\t>
\t<testcase name="alone" classname="alone" time="0.1" status="run">
\t<testcase name="left out" classname="left out" time="0" status="disabled">
\t<testcase name="crashed.1" classname="crashed.1" time="0.1" status="{crashed}">
\t<testcase name="cases.1" classname="cases.1" time="0.1" status="{cases}">
"""
CASES = '<testsuite name="A" tests="5" failures="{}" disabled="1" skipped="0" errors="0" time="0">'
PYTEST = '<testsuites><testsuite name="pytest" errors="0" failures="0" skipped="2" tests="9">'


@pytest.fixture
def ci(checkout: Path) -> Callable[..., Ended]:
    """ci(SCRIPT, NAME=EXIT_CODE...) runs .ci/SCRIPT. Stand-ins for the scripts end with these exit codes.
    `crashed` and `cases` are the results of two programs of GoogleTest."""
    shutil.copytree(ROOT / ".ci", checkout / ".ci")

    def start(script: str, crashed: str = "run", cases: str = "run", **ends: object) -> Ended:
        reports = {
            "build/logs/ctest.xml": CTEST.format(crashed=crashed, cases=cases),
            "build/logs/pytest.xml": PYTEST,
            "build/ci/tests/reports/cases.1.xml": CASES.format(int(cases == "fail")),
        }
        made = "".join(
            f"mkdir -p '{file.parent}'\ncat >'{file}' <<'END'\n{text}\nEND\n"
            for file, text in ((checkout / name, text) for name, text in reports.items())
        )
        for name in ["run_tests.sh", "run_all.sh", "tools/lint.sh", "tools/on_debian.sh",
                     "tests/fuzz/fuzz.sh", "build/ci/geodesic-bench"]:  # fmt: skip
            stem = Path(name).stem
            before = made if name == "run_tests.sh" else ""
            program(checkout / name, f'{before}echo "{stem}: $*"; exit {ends.get(stem, 0)}')
        program(checkout / "bin" / "ccache", "exit 1")
        debootstrap = program(checkout / "bin" / "debootstrap", "exit 1")
        return run(checkout / ".ci" / script, env=before_others(debootstrap))

    return start


@pytest.mark.parametrize(
    ("ends", "last"),
    [
        ({}, "15 passed, 0 failed"),
        ({"cases": "fail", "run_tests": 1}, "13 passed, 2 failed"),
        ({"crashed": "fail", "run_tests": 1}, "13 passed, 2 failed"),
        ({"on_debian": 1}, "14 passed, 1 failed"),
        ({"on_debian": 77}, "15 passed, 0 failed"),
        ({"on_debian": 77, "run_all": 1}, "14 passed, 1 failed"),
    ],
)
def test_ci_ends_with_the_number_of_tests_and_runs_the_job_whatever_they_say(
    ci: Callable[..., Ended], ends: dict[str, Any], last: str
) -> None:
    """Counts the tests of a GoogleTest program one by one, unless the program ended without a report.
    Where no bare Debian can be made, the main job runs on what the tests built."""
    no_chroot = ends.get("on_debian") == 77
    ended = ci("run", **ends)
    assert ended.returncode == (0 if last.endswith(" 0 failed") else 1)
    assert f"{5 if no_chroot else 4} tests skipped" in ended.stdout
    assert ended.stdout.splitlines()[-1] == last
    main_job = "--preset ci --corpus tiny --repetitions 2"
    assert f"on_debian: --bare bookworm ./run_all.sh {main_job}" in ended.stdout
    assert (f"run_all: {main_job}" in ended.stdout) == no_chroot


@pytest.mark.parametrize(
    ("ends", "last"),
    [
        ({}, "7 passed, 0 failed"),
        ({"fuzz": 1}, "6 passed, 1 failed"),
        ({"run_all": "$([[ $2 == peers ]] && echo 3)"}, "7 passed, 0 failed"),
    ],
)
def test_the_nightly_jobs_are_all_run_and_counted(
    ci: Callable[..., Ended], ends: dict[str, Any], last: str
) -> None:
    ended = ci("nightly", **ends)
    assert ended.returncode == (0 if last.endswith(" 0 failed") else 1)
    assert ended.stdout.splitlines()[-1] == last and "fuzz: " in ended.stdout
    missing = "== not run: the public codes libigl-exact,pvtp cannot be had here"
    assert (missing in ended.stdout) == ("run_all" in ends)


def build_with_fake_cmake(checkout: Path, tmp_path: Path, version: str) -> Ended:
    answer = f'[[ $1 == --version ]] && echo "cmake version {version}" || echo "asked: $*"'
    env = before_others(program(tmp_path / "bin" / "cmake", answer))
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
