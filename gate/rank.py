"""`geodesic-bench rank`: a solver against others by exactness, paired times, counters and memory.

Measures with `geodesic-bench run --interleave`, whose folder keeps the raw results, and derives
rank.md, rank.tex, rank.json and the figure from it (docs/ranking.md).
"""

from __future__ import annotations

import argparse
import signal
import subprocess
import sys
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from urllib.parse import quote

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench rank")  # before imports that may fail

from results.console import ROOT, Parser, complain
from results.reader import ResultError, Run, read_run

from gate.findings import GateError
from gate.rank_report import as_json, as_latex, as_markdown, summary
from gate.ranking import Ranking, Ratio, rank

PASSED_ON = ("sources", "seed", "min_time", "reference", "vectors", "manifest")
"""Options that are passed to `run` unchanged."""
FORWARDED = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


def parse(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = Parser(
        __doc__,
        "geodesic-bench rank --solver my-variant --against mmp,ich",
        "geodesic-bench rank --solver my-variant --against edge-based --meshes scans/ --pairs 15",
    )
    what = parser.add_argument_group("what is ranked")
    what.add_argument("--solver", metavar="NAME", help="the candidate")
    what.add_argument("--against", metavar="NAMES", help="the other solvers, comma-separated")
    what.add_argument("--corpus", metavar="NAME", help="a corpus of the manifest (default: quick)")
    what.add_argument(
        "--meshes", metavar="NAMES",
        help="mesh files, folders, quoted patterns or names of the manifest, in place of a corpus",
    )  # fmt: skip
    how = parser.add_argument_group("how it is measured")
    how.add_argument("--sources", metavar="N", default="1", help="source vertices a mesh (1)")
    how.add_argument("--pairs", metavar="N", type=_pairs, default=9, help="pairs a source (9)")
    how.add_argument("--seed", metavar="N", help="seed of the choice of sources")
    how.add_argument(
        "--min-time", metavar="SECONDS", default="0.05", help="minimum duration of a time (0.05)"
    )
    how.add_argument("--reference", metavar="NAME", help="exact solver that others are verified by")
    how.add_argument("--vectors", metavar="SET", help="instruction set: auto, plain, avx2 or avx512")
    how.add_argument("--repair", action="store_true", help="repair meshes that need it")
    how.add_argument("--manifest", metavar="FILE", help="list of meshes and corpora")
    where = parser.add_argument_group("folders")
    where.add_argument(
        "--out", type=Path, metavar="DIR", help="default: results/ranks/<UTC time>-<solver>"
    )
    where.add_argument(
        "--resume", type=Path, metavar="DIR", help="finish an interrupted ranking with its options"
    )
    where.add_argument(
        "--run", type=Path, metavar="DIR", help="derive the ranking again; nothing is measured"
    )
    where.add_argument("--no-figure", action="store_true", help="tables only")
    options = parser.parse_args(arguments)
    _check(parser, options)
    return options


def _pairs(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= 1000:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number from 1 to 1000")
    return int(text)


def _check(parser: Parser, options: argparse.Namespace) -> None:
    folders = [name for name in ("out", "resume", "run") if getattr(options, name)]
    if len(folders) > 1:
        parser.error(f"give only one of --{' and --'.join(folders)}")
    if options.resume or options.run:
        return
    for name in ("solver", "against"):
        if not getattr(options, name):
            parser.error(f"--{name} is required")
    others = options.against.split(",")
    for index, name in enumerate(others):
        if name == options.solver:
            parser.error(f"'{name}' cannot be ranked against itself: leave it out of --against")
        if name in others[:index]:
            parser.error(f"--against has '{name}' twice")


def run_command(options: argparse.Namespace, folder: Path) -> list[str]:
    """Returns the command of the run."""
    words = [console.bench(), *console.plugin_words(), "run"]
    if options.resume:
        return [*words, "--resume", str(folder)]
    words += ["--interleave", "--solvers", f"{options.solver},{options.against}"]
    words += ["--repetitions", str(options.pairs), "--recordings", "none", "--out", str(folder)]
    if options.meshes:
        words += ["--meshes", options.meshes]
    if options.corpus or not options.meshes:
        words += ["--corpus", options.corpus or "quick"]
    if options.repair:
        words.append("--repair")
    for name in PASSED_ON:
        if (value := getattr(options, name)) is not None:
            words += [f"--{name.replace('_', '-')}", value]
    return words


def measure(command: list[str]) -> int:
    """Starts the run and returns its exit code. Its progress goes to the terminal. The run has its own
    process group: the terminal sends it no signals, and each signal is forwarded to it once."""
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL, process_group=0)
    handled = [number for number in FORWARDED if signal.getsignal(number) != signal.SIG_IGN]
    before = {
        number: signal.signal(number, lambda received, _: running.send_signal(received))
        for number in handled
    }
    code = running.wait()
    for number, handler in before.items():
        signal.signal(number, handler)
    return code if code >= 0 else 128 - code


def write(ranking: Ranking, run: Run, folder: Path) -> None:
    """Writes rank.md, rank.tex and rank.json."""
    (folder / "rank.md").write_text(as_markdown(ranking, run), encoding="utf-8")
    (folder / "rank.tex").write_text(as_latex(ranking, run), encoding="utf-8")
    (folder / "rank.json").write_text(as_json(ranking), encoding="utf-8")


def draw(ranking: Ranking, folder: Path) -> str:
    """Draws the figure. Returns a line with its file, or with the reason why there is none."""
    try:
        from plots import rank as figure
        from plots.dots import Dot

        def dot(time: Ratio) -> Dot:
            found = time.estimate
            measured = (found.least, found.most)
            return Dot(found.value, found.low, found.high, not time.resolved, measured)

        meshes = {
            mesh: {one.solver: dot(on.time) for one in ranking.standings if (on := one.on(mesh))}
            for mesh in ranking.measurements.meshes
        }
        means = {one.solver: dot(one.time) for one in ranking.standings if one.time}
        figure.write(figure.draw(ranking.candidate, meshes, means), folder)
    except (ImportError, ResultError) as error:
        return f"no figure ({error}); to draw it later: geodesic-bench rank --run {folder}"
    return f"{folder / 'rank.pdf'} (also .png)"


def main(arguments: Sequence[str] | None = None) -> int:
    options = parse(arguments)
    time = datetime.now(UTC).strftime("%Y%m%dT%H%M%SZ")
    home = ROOT if (ROOT / "CMakeLists.txt").exists() else Path.cwd()  # a checkout, or an installed package
    new = home / "results" / "ranks" / f"{time}-{quote(str(options.solver), safe='')}"
    folder = options.resume or options.run or options.out or new
    try:
        code = 0
        if not options.run:
            code = measure(run_command(options, folder))
            if code not in (0, 1, 2) or not (folder / "run.json").exists():
                if (folder / "request.json").exists():
                    print(f"geodesic-bench: to finish the ranking: geodesic-bench rank --resume"
                          f" {folder}", file=sys.stderr)  # fmt: skip
                return code or 1
        run = read_run(folder)
        # The run's first solver is the candidate, by its canonical name.
        ranking = rank(run, options.solver if options.run else None)
        write(ranking, run, folder)
        print(summary(ranking), end="")
        if not options.no_figure:
            print(draw(ranking, folder), file=sys.stderr)
    except (GateError, ResultError, OSError) as error:
        return complain(error)
    print(f"{folder / 'rank.md'} (a table for each mesh; also .tex, .json)", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
