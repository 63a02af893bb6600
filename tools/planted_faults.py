#!/usr/bin/python3
"""Plants the faults of tools/planted_faults.toml, one at a time, and says which test finds each.

    tools/planted_faults.py --check
    tools/planted_faults.py --build /tmp/planted trim twin

Run it when tests are removed, moved or merged: what a test was the only one to find is then NOT FOUND.

Works in a copy of the checkout with a build folder of its own. Builds what a test needs, runs the tests
of a fault in their order, and stops at the first that fails. A test counts only if it passes without the
fault. Prints a row for each fault: fault | where | found by | seconds. Exit codes: 0 all are found,
1 one is not found, or an error.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from results import console
from results.names import unknown_name

LIST = Path(__file__).with_suffix(".toml")
PRESET = "ci"
LONGEST = 1200
"""Seconds after which a test is stopped and counts as failed: a fault may make a loop endless."""
NOT_FOUND = "NOT FOUND"


class ListError(Exception):
    """The list cannot be used: an entry, or a test that it names."""


@dataclass(frozen=True)
class Fault:
    name: str
    """What is broken, in a sentence."""
    file: str
    old: str
    new: str
    found_by: tuple[str, ...]
    """Tests, from the level where the fault is made to higher ones: "ctest TARGET [GTEST_FILTER]",
    "pytest WORD..." or "verify SOLVER"."""

    def planted(self, text: str) -> str:
        """@raises ListError when the old text does not occur exactly once"""
        count = text.count(self.old)
        if count != 1:
            raise ListError(f"{self.name}: its text occurs {count} times in {self.file}, not once")
        return text.replace(self.old, self.new)

    def check(self) -> None:
        """@raises ListError when the fault cannot be planted, or a test that it names is not there"""
        file = ROOT / self.file
        if not file.is_file():
            raise ListError(f"{self.name}: there is no file {self.file}")
        text = self.planted(file.read_text("utf-8"))
        if self.old == self.new or not self.found_by:
            raise ListError(f"{self.name}: it changes nothing, or no test is named")
        if file.suffix == ".py":
            try:
                compile(text, self.file, "exec")
            except SyntaxError as error:
                raise ListError(f"{self.name}: not Python any more: {error}") from None
        for selector in self.found_by:
            kind, *words = shlex.split(selector)
            if not words or not is_there(kind, words):
                raise ListError(f"{self.name}: there is no test '{selector}'")


def is_there(kind: str, words: Sequence[str]) -> bool:
    """Whether there is such a test, as far as files show."""
    if kind == "ctest":
        called = re.compile(rf"geodesic_add_test\(\s*{re.escape(words[0])}\s")
        return any(called.search(f.read_text("utf-8")) for f in (ROOT / "tests").glob("*/CMakeLists.txt"))
    if kind == "pytest":
        return (ROOT / words[0].partition("::")[0]).exists()
    sources = (file.read_text("utf-8") for file in (ROOT / "solvers").glob("**/*.cpp"))
    return kind == "verify" and any(f'"{words[0]}"' in text for text in sources)


def read_list(file: Path) -> list[Fault]:
    """@raises ListError"""
    try:
        entries = tomllib.loads(file.read_text("utf-8"))["fault"]
        faults = [Fault(found_by=tuple(entry.pop("found_by")), **entry) for entry in entries]
    except (OSError, ValueError, TypeError, KeyError) as error:
        raise ListError(f"{file}: {error}") from None
    names = [fault.name for fault in faults]
    for name in names:
        if names.count(name) > 1:
            raise ListError(f"{name}: two faults have this name")
    return faults


def chosen(faults: Sequence[Fault], words: Sequence[str]) -> list[Fault]:
    """Returns the faults with one of the words in their name or file. @raises ListError"""
    for word in words:
        if not any(word in fault.name or word in fault.file for fault in faults):
            raise ListError(unknown_name("fault", word, (fault.name for fault in faults)))
    return [f for f in faults if not words or any(w in f.name or w in f.file for w in words)]


class Copy:
    """A copy of the checkout with its build folder."""

    def __init__(self, folder: Path) -> None:
        self.tree = folder / "tree"
        self.build = self.tree / "build" / PRESET
        self.log = folder / "log"
        self._passes: set[str] = set()
        self._update()
        for words in (["init", "--quiet"], ["add", "--all"]):  # some tests read what git lists
            self._call(["git", *words], "the copy cannot be a repository")
        self._call(["cmake", "--preset", PRESET, "-DGEODESIC_TESTS=ON"], "the copy cannot be configured")

    def _update(self) -> None:
        """Copies what differs. New files have new times, so that they are built again."""
        listed = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
        ended = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True)
        if ended.returncode != 0:
            raise ListError(f"git does not list the files of {ROOT}: {ended.stderr.strip()}")
        wanted = {name for name in ended.stdout.split("\0") if name and (ROOT / name).is_file()}
        for name in wanted:
            file, copy = ROOT / name, self.tree / name
            if not copy.is_file() or copy.read_bytes() != file.read_bytes():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, copy)
        for copy in [file for file in self.tree.rglob("*.*") if file.is_file()]:
            place = copy.relative_to(self.tree)
            if place.parts[0] not in ("build", ".git") and str(place) not in wanted:
                copy.unlink()

    @contextmanager
    def planted(self, fault: Fault) -> Iterator[None]:
        file = self.tree / fault.file
        text = file.read_text("utf-8")
        file.write_text(fault.planted(text), "utf-8")
        try:
            yield
        finally:
            file.write_text(text, "utf-8")

    def fails(self, selector: str) -> bool:
        """Builds what a test needs and runs it. @raises ListError when that does not build"""
        kind, *words = shlex.split(selector)
        targets = [words[0]] if kind == "ctest" else ["geodesic-bench"]
        if kind == "pytest":
            targets += ["geodesic_python", "geodesic_faulty_plugin"]
        self._call(["cmake", "--build", str(self.build), "--target", *targets], "it does not build")
        bench = str(self.build / "geodesic-bench")
        command, own = [bench, "verify", "--solver", words[0]], {"GEODESIC_BENCH": bench}
        if kind == "pytest":
            command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *words]
        if kind == "ctest":
            of_target = ["-R", rf"^{re.escape(words[0])}\.", "--no-tests=error", "--stop-on-failure"]
            command = ["ctest", "--test-dir", str(self.build), *of_target]
            own |= {"GTEST_FILTER": words[1]} if len(words) > 1 else {}
        return self._run(command, own) != 0

    def passes_without_fault(self, selector: str) -> bool:
        if selector not in self._passes and not self.fails(selector):
            self._passes.add(selector)
        return selector in self._passes

    def _call(self, command: list[str], complaint: str) -> None:
        if self._run(command, {}) != 0:
            raise ListError(f"{complaint}; see {self.log}")

    def _run(self, command: list[str], own: dict[str, str]) -> int:
        """@returns the exit code; that of a killed process after LONGEST seconds"""
        environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", **own}
        if shutil.which("ccache"):
            environment |= {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache", "CCACHE_BASEDIR": str(self.tree)}
        with self.log.open("wb") as log:
            process = subprocess.Popen(
                command, cwd=self.tree, env=environment, stdin=subprocess.DEVNULL, stdout=log,
                stderr=subprocess.STDOUT, start_new_session=True,
            )  # fmt: skip
            try:
                return process.wait(LONGEST)
            except subprocess.TimeoutExpired:
                return 1
            finally:
                if process.poll() is None:
                    os.killpg(process.pid, signal.SIGTERM)  # Ninja ends its compilers, which are in other groups
                    time.sleep(1)
                    os.killpg(process.pid, signal.SIGKILL)
                    process.wait()


def found_by(copy: Copy, fault: Fault, every: bool) -> list[str]:
    """Returns the tests that find a fault: the first one, or all. @raises ListError"""
    failed = []
    with copy.planted(fault):
        for selector in fault.found_by:
            if copy.fails(selector):
                failed.append(selector)
                if not every:
                    break
    for selector in failed:
        if not copy.passes_without_fault(selector):
            raise ListError(f"{selector} fails without a fault; see {copy.log}")
    return failed


def plant_all(copy: Copy, faults: Iterable[Fault], every: bool) -> int:
    """Prints a row for each fault. Returns the number of those that are not found or cannot be judged."""
    bad = count = 0
    for fault in faults:
        began = time.monotonic()
        count += 1
        try:
            failed = found_by(copy, fault, every)
            verdict = ", ".join(failed) or NOT_FOUND
        except ListError as error:
            failed, verdict = [], f"ERROR: {error}"
        bad += not failed
        console.say(f"{fault.name} | {fault.file} | {verdict} | {time.monotonic() - began:.0f}")
    console.say(f"{count} faults: {count - bad} found, {bad} not")
    return bad


def main() -> int:
    parser = console.Parser(__doc__)
    parser.add_argument("words", nargs="*", metavar="WORD", help="only faults with it in name or file")
    parser.add_argument("--list", action="store_true", help="print the faults and their tests")
    parser.add_argument("--check", action="store_true", help="only check that all can be planted")
    parser.add_argument("--all", action="store_true", help="run all tests of a fault, to see doubles")
    parser.add_argument("--build", type=Path, metavar="DIR", help="keep the copy and its build here")
    parser.add_argument("--faults", type=Path, default=LIST, metavar="FILE", help="another list")
    given = parser.parse_args()
    try:
        faults = chosen(read_list(given.faults), given.words)
        for fault in faults:
            fault.check()
        if given.list or given.check:
            for fault in faults if given.list else ():
                console.say(f"{fault.name} | {fault.file} | {', '.join(fault.found_by)}")
            return 0
        with tempfile.TemporaryDirectory() as temporary:
            folder = (given.build or Path(temporary)).resolve()
            folder.mkdir(parents=True, exist_ok=True)
            return 1 if plant_all(Copy(folder), faults, given.all) else 0
    except ListError as error:
        return console.complain(error)


if __name__ == "__main__":
    console.prepare(place="--build")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))  # ends the tests that run, too
    sys.exit(main())
