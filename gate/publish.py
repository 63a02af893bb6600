"""`geodesic-bench publish`: writes a run as a file for results/contributed/.

It is the run's file without folders and the name of the host, and with the licence of each mesh that is
not in datasets/manifest.json. It is written only if `check-result` finds no fault.
"""

from __future__ import annotations

import gzip
import json
import re
import shlex
import sys
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from results import console

if __name__ == "__main__":
    console.prepare("geodesic-bench publish", place="--output")  # before imports that may fail

from gate import check_result
from gate.findings import GateError
from results import checksum, outcomes
from results.reader import ResultError, Run, newest_run, read_run
from results.text import read_text

ABSOLUTE = re.compile(r"""(?<![\w.:/~-])/(?:[^\s'",;:=()/]+/)*([^\s'",;:=()/]*)""")
"""Matches an absolute path in a text. Group 1 is its last name."""
SUFFIX = ".json.gz"
NEXT = (
    "Add it to results/contributed/ of a clone, and open a pull request with it (docs/contributed-results.md)."
)


def published(run: Run, licences: Mapping[str, str]) -> str:
    """Returns the text of the published file.

    @param licences licences, by mesh
    @raises ResultError if the rows are in a separate file, or if a licence names an unknown mesh"""
    if run.rows_file:
        raise ResultError(f"{run.file}: its rows are in {run.rows_file.name}, and a contribution is one file")
    if unknown := [name for name in licences if name not in run.meshes]:
        raise ResultError(f"--licence: the run has no mesh {', '.join(unknown)}")
    data = json.loads(read_text(run.file))
    context, ours = data["context"], data["context"]["geodesic_bench"]
    context.pop("host_name", None)
    for plugin in ours.get("plugins", []):
        if "file" in plugin:
            plugin["file"] = "/".join(Path(plugin["file"]).parts[-2:])  # the folder has the name of the public code
        else:
            plugin["external"] = plugin["solvers"][0]
    for part in ours.get("parts", []):
        part |= {"host": "", "folder": Path(part["folder"]).name}
    for mesh in ours["meshes"]:
        if mesh["name"] in licences:
            mesh["licence"] = licences[mesh["name"]]
    for row in data["benchmarks"]:
        row.pop("recordings", None)  # they name files in the run's folder
    folders: set[str] = set()
    for one in (ours, *ours.get("parts", [])):
        one["command"] = _without_folders(one["command"], folders)
    data = _cleared(data, sorted(folders, key=len, reverse=True))
    ours = data["context"]["geodesic_bench"]
    ours.pop("checksum", None)
    ours["checksum"] = checksum.computed(json.dumps(data, ensure_ascii=False))
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")) + "\n"


def _without_folders(command: str, folders: set[str]) -> str:
    """Replaces each absolute path by its last name, and adds its folder to `folders`."""

    def name(match: re.Match[str]) -> str:
        path = match[0]
        if not path.startswith("/"):
            return path
        folders.add(f"{Path(path).parent}/")
        return Path(path).name

    try:
        words = shlex.split(command)
    except ValueError:  # of a version that recorded words without quotes
        words = command.split()
    return shlex.join(re.sub(r"[^,=]+", name, word) for word in words)


def _cleared(value: Any, folders: Sequence[str]) -> Any:
    """Removes the folders from every text, and replaces other absolute paths by their last names."""
    if isinstance(value, dict):
        return {key: _cleared(one, folders) for key, one in value.items()}
    if isinstance(value, list):
        return [_cleared(one, folders) for one in value]
    if not isinstance(value, str):
        return value
    for folder in folders:
        value = value.replace(folder, "")
    return ABSOLUTE.sub(r"\1", value)


def default_name(run: Run) -> str:
    """Returns a name such as 2026-11-23-amd-epyc-7b13-standard.json.gz."""
    words = " ".join([*run.processors, run.ours["corpus"]]).lower()
    words = re.sub(r"\((r|tm)\)|\b(cpu|processor)\b|@.*?ghz", " ", words)
    return "-".join([run.ours["started"][:10], *re.findall(r"[a-z0-9.]+", words)]) + SUFFIX


def main(arguments: Sequence[str] | None = None) -> int:
    parser = console.run_parser(
        __doc__,
        "geodesic-bench publish results/runs/mine",
        "geodesic-bench publish results/runs/mine --licence 'scan=CC BY 4.0, by its authors'",
    )
    parser.add_argument(
        "--licence", action="append", default=[], metavar="MESH=TEXT",
        help="licence of a mesh of your own; repeatable",
    )  # fmt: skip
    parser.add_argument(
        "-o", "--output", type=Path, metavar=f"FILE{SUFFIX}",
        help="file to write (default: in the current folder, named by date, processor and corpus)",
    )  # fmt: skip
    options = parser.parse_args(arguments)
    if options.output and not options.output.name.endswith(SUFFIX):
        parser.error(f"--output {options.output}: a result is written as {SUFFIX}")
    if wrong := [word for word in options.licence if not re.fullmatch(r"[^=]+=.*\S.*", word)]:
        parser.error(f"--licence {wrong[0]}: not MESH=TEXT")
    try:
        run = read_run(options.run or newest_run())
        text = published(run, dict(word.split("=", 1) for word in options.licence))
        packed = gzip.compress(text.encode(), mtime=0)  # the same bytes for the same run
        with tempfile.TemporaryDirectory(prefix="geodesic-publish-") as scratch:
            trial = Path(scratch) / f"run{SUFFIX}"
            trial.write_bytes(packed)
            found = list(check_result.problems(read_run(trial), *check_result.known()))
        for line in outcomes.first(found):
            console.say(f"FAILED: {line}")
        if found:
            return 1
        file = options.output or Path(default_name(run))
        if file.exists():
            raise ResultError(f"{file}: is there already: give another --output")
        file.write_bytes(packed)
        console.say(str(file))
        console.say(NEXT)
    except (ResultError, GateError, OSError) as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    sys.exit(main())
