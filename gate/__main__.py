"""The command line of the gate; ./check_performance.sh calls it and documents its options."""

from __future__ import annotations

import argparse
import math
import subprocess
import sys
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path

from results import console

if __name__ == "__main__":
    console.prepare("check_performance.sh")  # before imports that may fail

from gate import revisions
from gate.builds import Tree, build, tree_of
from gate.findings import GateError
from gate.options import add_to, number
from gate.program import Program
from gate.progress import say
from gate.verdict import as_text, write

ROOT = console.ROOT
GATE = ROOT / "build" / "gate"
NOISE = GATE / "noise.json"


def parse(words: Sequence[str] | None) -> argparse.Namespace:
    seconds = number(lambda value: 0 <= value < math.inf, "seconds, 0 or more, as in 300")
    sessions = number(lambda value: value >= 1 and value % 1 == 0, "at least one session, as in 3")
    parser = console.Parser(__doc__)
    parser.add_argument("base", nargs="?")
    parser.add_argument("head", nargs="?")
    add_to(parser, revisions.ALL_LEVELS)
    parser.add_argument("--budget", type=seconds, default=revisions.BUDGET)
    parser.add_argument("--solvers", default="")
    parser.add_argument("--all", action="store_true", dest="everything")
    parser.add_argument("--a-a", type=sessions, metavar="N")
    parser.add_argument("--update-baseline", action="store_true")
    parser.add_argument("--reason", default="")
    options = parser.parse_args(words)
    if options.update_baseline and (options.base or options.solvers or options.a_a):
        parser.error("--update-baseline takes the working tree and the whole suite")
    if options.update_baseline and not options.reason.strip():
        parser.error('--update-baseline needs --reason "why the change may be accepted"')
    if options.reason and not options.update_baseline:
        parser.error("--reason is for --update-baseline")
    if options.everything and (options.update_baseline or options.a_a):
        parser.error("--all is for a comparison with a base")
    if options.a_a and options.head:
        parser.error("--a-a takes one revision")
    if not options.update_baseline and not options.a_a and options.base is None:
        parser.error("the base is missing: name a revision, as in check_performance.sh main")
    return options


def _ready(trees: list[Tree], chosen: revisions.Options) -> list[Program]:
    """Builds the programs and generates the meshes of the suite."""
    say(f"building {' and '.join(tree.label for tree in trees)}")
    build(trees, chosen.solvers, chosen.out)
    cache = GATE / "meshes"
    manifest = ROOT / "datasets" / "manifest.json"
    programs = [Program(tree.name, tree.label, tree.program, cache, manifest) for tree in trees]
    fetch = [sys.executable, str(ROOT / "datasets" / "fetch.py"), "--corpus", revisions.CORPUS]
    fetch += ["--cache", str(cache), "--bench", str(programs[-1].path)]
    ended = subprocess.run(fetch, capture_output=True, text=True)
    if ended.returncode != 0:
        last = (ended.stderr.strip().splitlines() or ["no error message"])[-1]
        raise GateError(f"the meshes of the suite could not be generated: {last}")
    return programs


def judge(options: argparse.Namespace, out: Path) -> int:
    """Runs the levels, writes the report and returns the exit code."""
    solvers = tuple(name for name in options.solvers.split(",") if name)
    chosen = revisions.Options(out, options.levels, options.margin, options.budget, solvers,
                           strict=options.strict, everything=options.everything, noise_file=NOISE)  # fmt: skip
    if options.update_baseline:
        [program] = _ready([tree_of(ROOT, "head", None)], chosen)
        print("\n".join(revisions.update_baseline(program, ROOT, options.reason.strip(), chosen)))
        return 0
    if options.a_a:
        [program] = _ready([tree_of(ROOT, "head", options.base)], chosen)
        verdict = revisions.against_itself(program, int(options.a_a), chosen)
    else:
        head_tree = tree_of(ROOT, "head", options.head)
        base, head = _ready([tree_of(ROOT, "base", options.base), head_tree], chosen)
        verdict = revisions.compare(base, head, head_tree.folder, chosen)
    print(as_text(verdict), end="")
    write(verdict, out)
    say(f"Report: {out}/verdict.md and verdict.json")
    return verdict.exit_code


def main(words: Sequence[str] | None = None) -> int:
    options = parse(words)
    out = (options.out or GATE / datetime.now(UTC).strftime("%Y%m%dT%H%M%SZ")).absolute()
    try:
        out.mkdir(parents=True, exist_ok=True)
        return judge(options, out)
    except GateError as error:  # CI shows verdict.md, so errors are written there too
        (out / "verdict.md").write_text(f"## error: {error}\n", encoding="utf-8")
        return console.complain(error)
    except OSError as error:
        return console.complain(error)
    except KeyboardInterrupt:
        return console.interrupted()


if __name__ == "__main__":
    sys.exit(main())
