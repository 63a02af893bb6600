"""The command line of the gate; ./check_performance.sh calls it and documents its options."""

from __future__ import annotations

import argparse
import math
import subprocess
import sys
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import NoReturn

from . import check
from .builds import Tree, build, tree_of
from .findings import ERROR, GateError
from .program import Program
from .verdict import as_text, write

ROOT = Path(__file__).resolve().parent.parent
GATE = ROOT / "build" / "gate"
NOISE = GATE / "noise.json"


class Parser(argparse.ArgumentParser):
    """Argparse exits with 2, which here means a wrong answer."""

    def error(self, message: str) -> NoReturn:
        raise GateError(f"{message}; see check_performance.sh --help")


def _levels(text: str) -> tuple[int, ...]:
    known = {str(level): level for level in check.ALL_LEVELS}
    chosen = set(text.split(","))
    if not chosen <= known.keys():
        raise argparse.ArgumentTypeError(f"'{text}': levels are 0, 1, 2, 3 and 4, as in 0,1,2")
    return tuple(sorted(known[word] for word in chosen))


def _margin(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 1 < value < 10:
        raise argparse.ArgumentTypeError(f"'{text}': a margin is a ratio above 1, as in 1.10")
    return value


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = -1.0
    if not 0 <= value < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}': seconds, 0 or more, as in 300")
    return value


def _sessions(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}': at least one session, as in 3")
    return int(text)


def parse(words: Sequence[str] | None) -> argparse.Namespace:
    parser = Parser(prog="check_performance.sh", add_help=False)
    parser.add_argument("base", nargs="?")
    parser.add_argument("head", nargs="?")
    parser.add_argument("--levels", type=_levels, default=check.ALL_LEVELS)
    parser.add_argument("--margin", type=_margin, default=check.MARGIN)
    parser.add_argument("--budget", type=_seconds, default=check.BUDGET)
    parser.add_argument("--solvers", default="")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--strict", action="store_true")
    parser.add_argument("--a-a", type=_sessions, metavar="N")
    parser.add_argument("--update-baseline", action="store_true")
    parser.add_argument("--reason", default="")
    options = parser.parse_args(words)
    if options.update_baseline and (options.base or options.solvers or options.a_a):
        parser.error("--update-baseline takes the working tree and the whole suite")
    if options.update_baseline and not options.reason.strip():
        parser.error('--update-baseline needs --reason "why the change may be accepted"')
    if options.reason and not options.update_baseline:
        parser.error("--reason is for --update-baseline")
    if options.a_a and options.head:
        parser.error("--a-a takes one revision")
    if not options.update_baseline and not options.a_a and options.base is None:
        parser.error("the base is missing: name a revision, as in check_performance.sh main")
    return options


def _ready(trees: list[Tree], chosen: check.Options) -> list[Program]:
    """Built programs with the meshes of the suite."""
    check.say(f"building {' and '.join(tree.label for tree in trees)}")
    build(trees, chosen.solvers, chosen.out)
    cache = GATE / "meshes"
    manifest = ROOT / "datasets" / "manifest.json"
    programs = [Program(tree.name, tree.label, tree.program, cache, manifest) for tree in trees]
    fetch = [sys.executable, str(ROOT / "datasets" / "fetch.py"), "--corpus", check.CORPUS]
    fetch += ["--cache", str(cache), "--bench", str(programs[-1].path)]
    ended = subprocess.run(fetch, capture_output=True, text=True)
    if ended.returncode != 0:
        last = (ended.stderr.strip().splitlines() or ["it printed no error"])[-1]
        raise GateError(f"the meshes of the suite could not be generated: {last}")
    return programs


def gate(options: argparse.Namespace) -> int:
    """The exit code. An error that prevents a verdict is written to verdict.md too."""
    out = (options.out or GATE / datetime.now(UTC).strftime("%Y%m%dT%H%M%SZ")).absolute()
    out.mkdir(parents=True, exist_ok=True)
    try:
        return judge(options, out)
    except GateError as error:
        (out / "verdict.md").write_text(f"## error: {error}\n", encoding="utf-8")
        raise


def judge(options: argparse.Namespace, out: Path) -> int:
    chosen = check.Options(
        out=out,
        levels=options.levels,
        margin=options.margin,
        budget=options.budget,
        solvers=tuple(name for name in options.solvers.split(",") if name),
        strict=options.strict,
        noise_file=NOISE,
    )
    if options.update_baseline:
        [program] = _ready([tree_of(ROOT, "head", None)], chosen)
        print("\n".join(check.update_baseline(program, ROOT, options.reason.strip(), chosen)))
        return 0
    if options.a_a:
        [program] = _ready([tree_of(ROOT, "head", options.base)], chosen)
        verdict = check.against_itself(program, options.a_a, chosen)
    else:
        head_tree = tree_of(ROOT, "head", options.head)
        base, head = _ready([tree_of(ROOT, "base", options.base), head_tree], chosen)
        verdict = check.check(base, head, head_tree.folder, chosen)
    print(as_text(verdict), end="")
    write(verdict, out)
    check.say(f"Report: {out}/verdict.md and verdict.json")
    return verdict.exit_code


def complain(line: str) -> int:
    print(f"check_performance.sh: {line}", file=sys.stderr)
    return ERROR


def main(words: Sequence[str] | None = None) -> int:
    try:
        return gate(parse(words))
    except GateError as error:
        return complain(str(error))
    except OSError as error:
        where = error.filename or "the standard output"
        return complain(f"cannot write {where}: {error.strerror}; --out names another folder")
    except KeyboardInterrupt:
        print("check_performance.sh: interrupted", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
