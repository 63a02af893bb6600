#!/usr/bin/python3
"""Checks the names and folders that ./run_all.sh was given, before it builds anything.

A solver is known by its registration in solvers/, since nothing may be built yet; what its
parameters are is checked when it runs.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from results import console
from results.names import registered, unknown_name


class WordError(Exception):
    """A word that names nothing."""


def drawings() -> set[str]:
    """Returns the names of all tables and figures; none where NumPy is yet to be installed."""
    try:
        from plots.catalogue import EVERYTHING
    except ImportError:
        return set()
    return set(EVERYTHING)


def peers() -> set[str]:
    return {file.parent.name for file in (ROOT / "peers").glob("*/adapter.cpp")}


def check_name(option: str, kind: str, name: str, known: set[str]) -> None:
    if name not in known:
        raise WordError(f"{option}: {unknown_name(kind, name, known)}")


def check_solvers(words: str, known: set[str]) -> None:
    """@param words such as "mmp,steiner?points=1,3": what follows a `?` may be a value"""
    is_value = False
    for word in words.split(","):
        name = word.partition("?")[0]
        if not is_value or name in known:
            check_name("--solvers", "solver", name, known)
        is_value = "?" in word or (is_value and name not in known)


def check_meshes(words: str, known: set[str]) -> None:
    """Files and patterns are checked by the run, which says what is wrong with them."""
    for word in words.split(","):
        if not re.search(r"[/.*?\[]", word) and not (ROOT / word).exists():
            check_name("--meshes", "mesh", word, known)


def check_folder(option: str, folder: Path, file: str, without: str) -> None:
    if not folder.is_dir():
        raise WordError(f"{option}: no such folder: {folder}")
    if file and not (folder / file).is_file():
        raise WordError(f"{option}: {folder} has no {file}: {without}")


def read_manifest() -> Any:
    try:
        return json.loads((ROOT / "datasets" / "manifest.json").read_text("utf-8"))
    except (OSError, ValueError) as error:
        raise WordError(f"datasets/manifest.json of the checkout cannot be read: {error}") from None


def check(options: dict[str, str]) -> None:
    """@param options by their names without dashes. @raises WordError"""
    if {"corpus", "meshes"} & options.keys():
        manifest = read_manifest()
        if "corpus" in options:
            check_name("--corpus", "corpus", options["corpus"], set(manifest["corpora"]))
        if "meshes" in options:
            check_meshes(options["meshes"], {mesh["name"] for mesh in manifest["meshes"]})
    if options.get("peers", "all") != "all":
        for name in options["peers"].split(","):
            check_name("--peers", "peer", name, peers())
    if "solvers" in options:
        check_solvers(options["solvers"], set(registered(ROOT)) | (peers() if "peers" in options else set()))
    if "only" in options:
        for name in options["only"].split(","):
            check_name("--only", "table or figure", name, drawings() or {name})
    if "resume" in options:
        check_folder("--resume", Path(options["resume"]), "request.json", "no run began there")
    if "run" in options:
        check_folder("--run", Path(options["run"]), "run.json", "it is no run that has ended")
    if "folder" in options:
        check_folder("--folder", Path(options["folder"]), "", "")


def main() -> int:
    parser = console.Parser(__doc__)
    for name in ("corpus", "meshes", "peers", "solvers", "resume", "run", "folder", "only"):
        parser.add_argument(f"--{name}")
    given = parser.parse_args()
    try:
        check({name: value for name, value in vars(given).items() if value})
    except WordError as error:
        return console.complain(error)
    return 0


if __name__ == "__main__":
    console.prepare("run_all.sh")
    sys.exit(main())
