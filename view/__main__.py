"""`geodesic-bench view`: a page that turns a model and plays the wavefronts of solvers.

Takes a run whose recordings have frames (`geodesic-bench run --frames`), or a mesh file, which it
solves first from its first vertex. The page needs no other file and no network (docs/view.md).
"""

from __future__ import annotations

import argparse
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from results import console

if __name__ == "__main__":
    # Before imports that may fail.
    console.prepare("geodesic-bench view", place="--output")

from plots.recordings import Recording, recordings
from results.published import THESIS_SOLVERS
from results.reader import ResultError, read_run

from view import three
from view.page import page
from view.scene import scene, with_frames


SOLVER = "edge-based"
"""Default solver for a mesh file."""
MOST_SOLVERS = 8
"""Largest number of solvers on a page: the number of channels in page.js."""


def parse(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = console.Parser(
        __doc__,
        "geodesic-bench view bunny.ply --solvers mmp,edge-based",
        "geodesic-bench view results/runs/mine --mesh horse --solvers mmp,edge-based",
    )
    parser.add_argument("what", type=Path, metavar="RUN_OR_FILE", help="run folder, or mesh file")
    parser.add_argument("--mesh", metavar="NAME", help="mesh of the run (default: the thesis's)")
    parser.add_argument(
        "--solvers", metavar="A,B", type=lambda text: text.split(","),
        help="shown side by side (default: of a run those of the thesis that were recorded, of a "
        f"file {SOLVER})",
    )  # fmt: skip
    parser.add_argument(
        "-o", "--output", type=Path, metavar="FILE.html",
        help="page to write (default: RUN/view-MESH.html, or MESH.html in the current folder)",
    )  # fmt: skip
    parser.add_argument(
        "--up", choices="xyz",
        help="axis that points up at first (default: y, of terrain z)",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    if options.output and options.output.suffix != ".html":
        parser.error(f"--output {options.output}: the page is written as .html")
    if options.mesh and options.what.is_file():
        parser.error("--mesh is for a run, and a file is one mesh")
    return options


def solve(mesh: Path, solvers: Sequence[str], folder: Path) -> int:
    """Runs the solvers on the mesh file and records frames. The run prints its own progress and errors.
    @return the exit code of the run"""
    once = ["--sources", "1", "--repetitions", "1", "--min-time", "0.001"]
    command = [console.bench(), *console.plugin_words(), "run", "--meshes", str(mesh), "--solvers", ",".join(solvers), *once]
    # A reference of another family that takes no longer. The default reference is ten times slower.
    command += ["--reference", "fwp-ch" if SOLVER in solvers else SOLVER]
    command += ["--recordings", "all", "--frames", "--out", str(folder)]
    return subprocess.run(command, stdout=subprocess.DEVNULL).returncode


def recording_of(folder: Path, mesh: str | None) -> Recording:
    """Returns the first recording of a run, or of one of its meshes. @raises ResultError"""
    run = read_run(folder)
    return recordings(run.of_meshes([mesh]) if mesh else run)[0]


def chosen(recording: Recording, solvers: Sequence[str] | None) -> list[str]:
    """Returns the solvers to show. @raises ResultError when one has no frames or there are too many"""
    there = with_frames(recording)
    for solver in solvers or ():
        if solver not in there:
            known = f"those with frames: {', '.join(there)}" if there else "none has frames"
            raise ResultError(
                f"{recording.folder}: no frames of {solver} ({known}); `geodesic-bench run --frames`"
                " records them"
            )
    if solvers and len(solvers) > MOST_SOLVERS:
        raise ResultError(f"--solvers names {len(solvers)}: a page shows {MOST_SOLVERS} at most")
    return list(solvers) if solvers else [one for one in there if one in THESIS_SOLVERS] or there[:MOST_SOLVERS]


def write(recording: Recording, solvers: list[str], up: str | None, command: str, file: Path) -> None:
    mesh = recording.mesh
    summary = f"{mesh.vertices:,} vertices, {mesh.faces:,} faces; source: {recording.origin}."
    title = f"How solvers sweep {mesh.name}" if solvers else f"Geodesic distances on {mesh.name}"
    shown = scene(recording, solvers, "xyz".index(up) if up else None)
    file.write_text(page(title, summary, command, shown), encoding="utf-8")


def main(arguments: Sequence[str] | None = None) -> int:
    options = parse(arguments)
    words = sys.argv[1:] if arguments is None else list(arguments)
    command = shlex.join(["geodesic-bench", "view", *words])
    try:
        if not three.is_there():  # asked before a long solve
            console.say(three.fetch(None), sys.stderr)
        if options.what.is_dir():
            recording = recording_of(options.what, options.mesh)
            solvers = chosen(recording, options.solvers)
            if not solvers:
                console.say("no frames are recorded, so nothing moves: run with --frames")
            file = options.output or options.what / f"view-{recording.folder.parent.name}.html"
            write(recording, solvers, options.up, command, file)
        else:
            file = options.output or Path(f"{options.what.stem}.html")
            with tempfile.TemporaryDirectory(prefix="geodesic-view-") as scratch:
                folder = Path(scratch) / "run"
                if code := solve(options.what, options.solvers or [SOLVER], folder):
                    return code
                recording = recording_of(folder, None)
                write(recording, chosen(recording, options.solvers), options.up, command, file)
        console.say(str(file))
    except (ResultError, three.Unavailable, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
