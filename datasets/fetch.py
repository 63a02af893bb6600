#!/usr/bin/python3
"""Fills the dataset cache with the meshes of the manifest.

Generated meshes are made by geodesic-bench; downloaded ones are copied from the folder that
GEODESIC_DATASETS_MIRROR names, laid out like the upstream sites. Every file is checked before it
appears in the cache; what is there already is left alone.

Exit codes: 0 all that was asked for is there, 3 something is missing but the rest was fetched,
1 an error that concerns all.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from fetching.cache import Cache, CacheError, default_cache
from fetching.manifest import DEFAULT_MANIFEST, Manifest, ManifestError, Mesh
from fetching.sources import DEFAULT_BENCH, Fetcher, Unavailable, mirror_from_environment

EXIT_ERROR = 1
EXIT_MISSING = 3


def parse_arguments(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", metavar="NAME", help="a mesh of the manifest")
    parser.add_argument("--corpus", action="append", default=[], help="all meshes of a corpus")
    parser.add_argument("--bench", type=Path, default=DEFAULT_BENCH, help="geodesic-bench program")
    parser.add_argument("--cache", type=Path, default=default_cache(), help="folder to fill")
    parser.add_argument("--manifest", type=Path, default=DEFAULT_MANIFEST)
    arguments = parser.parse_args(words)
    if not arguments.names and not arguments.corpus:
        parser.error("name a --corpus or meshes")
    return arguments


def fetch_all(fetcher: Fetcher, meshes: list[Mesh]) -> int:
    """Fetches one after the other, a line for each new or missing one; counts the missing."""
    fetched = missing = 0
    for mesh in meshes:
        try:
            if fetcher.fetch(mesh):
                fetched += 1
                print(f"{mesh['name']}: fetched", flush=True)
        except Unavailable as error:
            missing += 1
            print(f"{mesh['name']}: missing: {error}", file=sys.stderr, flush=True)
    there = len(meshes) - fetched - missing
    print(f"{len(meshes)} meshes: {there} there already, {fetched} fetched, {missing} missing")
    return missing


def main(words: list[str] | None = None) -> int:
    arguments = parse_arguments(words)
    try:
        manifest = Manifest(arguments.manifest)
        meshes = manifest.select(arguments.corpus, arguments.names)
        fetcher = Fetcher(Cache(arguments.cache), arguments.bench, mirror_from_environment())
        missing = fetch_all(fetcher, meshes)
    except (ManifestError, CacheError) as error:
        print(f"fetch.py: {error}", file=sys.stderr)
        return EXIT_ERROR
    return EXIT_MISSING if missing else 0


if __name__ == "__main__":
    sys.exit(main())
