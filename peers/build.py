#!/usr/bin/python3
"""Builds the peers, public codes of the field, as plug-ins of geodesic-bench.

CMake fetches their sources from github.com at the commits of peers/NAME/CMakeLists.txt, or from the
mirror that GEODESIC_PEERS_MIRROR names: a folder or an address with Git repositories OWNER/NAME.
The plug-ins lie beside the program: build/release/peers/NAME/libNAME.so.

Exit codes: 0 built, or nothing was asked for by name; 3 a peer that was named could not be had;
1 wrong use or an error that concerns all; 130 interrupted.
"""

from __future__ import annotations

import argparse
import fcntl
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "datasets")]  # shares the code for names and errors

from results import console

if __name__ == "__main__":
    console.prepare("peers/build.py", packages="python3-tqdm")  # before imports that may fail

from building.compiler import PEERS, Compiler, install_package
from building.flags import Bench, loading
from building.plugin import Builder
from fetching.program import find
from fetching.reporting import EXIT_MISSING, FetchError, Unavailable


def parse_arguments(words: Sequence[str] | None) -> argparse.Namespace:
    parser = console.Parser(__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="a peer (default: all)")
    parser.add_argument(
        "--bench", type=Path, default=ROOT / "build" / "release" / "geodesic-bench",
        help="program to build them for, in its build folder",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="folder to build in (default: peers, beside the program)"
    )
    parser.add_argument(
        "-D", dest="settings", action="append", default=[], metavar="NAME=VALUE",
        help="a setting for CMake: FETCHCONTENT_SOURCE_DIR_LIBIGL=FOLDER compiles that folder, as it is",
    )  # fmt: skip
    parser.add_argument("--peers", type=Path, default=PEERS, help="folder of the peers")
    parser.add_argument(
        "--words", metavar="SOLVERS", help="build nothing: print the words for geodesic-bench "
        "run that add the peers to SOLVERS (empty: to those that run always, and all peers also to cgal)"
    )
    return parser.parse_args(words)


def build_all(builder: Builder, peers: Sequence[Path]) -> int:
    """Builds the peers one by one, prints a line for each and returns the number of missing ones."""
    missing = 0
    for peer in peers:
        try:
            said = builder.build(peer)
            line = "there already" if said is None else f"built with {said}"
        except Unavailable as error:
            missing += 1
            line = f"missing: {error}"
        console.say(f"{peer.name}: {line}")
    kind = "peer" if len(peers) == 1 else "peers"
    console.say(f"{len(peers)} {kind}: {len(peers) - missing} built, {missing} missing")
    return missing


def words_of_run(bench: Bench, plugins: Sequence[Path], solvers: str, oracles: bool) -> list[str]:
    """Returns arguments of `geodesic-bench run`: the plug-ins, and their solvers after `solvers`."""
    beside = solvers or ",".join(bench.beside_peers(oracles))
    names = [beside, *bench.solvers_of(*plugins)]
    return [*loading(plugins), "--solvers", ",".join(names)]


def plugins_there(builder: Builder, peers: Sequence[Path], named: bool) -> list[Path]:
    """Returns the plug-ins that exist. Raises FetchError if a named one is missing, or if all are."""
    plugins = [builder.plugin(peer) for peer in peers]
    there = [plugin for plugin in plugins if plugin.is_file()]
    if not there or (named and there != plugins):
        missing = next(plugin for plugin in plugins if not plugin.is_file())
        raise FetchError(f"there is no {missing}: build it (./run_all.sh peers)")
    return there


@contextmanager
def nobody_else_in(folder: Path) -> Iterator[None]:
    """Raises FetchError while another process builds in the folder: both would write the same files."""
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "lock").open("w") as lock:  # released when the process ends, however it ends
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise FetchError(f"another process builds peers in {folder}: wait for its end") from None
        yield


def run(arguments: argparse.Namespace) -> int:
    program = arguments.bench.resolve()
    if not program.is_file():
        raise FetchError(
            f"there is no {program}: build it (./run_all.sh build) or name it with --bench"
        )
    folder = (arguments.out or program.parent / "peers").resolve()
    known = {file.parent.name: file.parent for file in sorted(arguments.peers.glob("*/adapter.cpp"))}
    names = list(dict.fromkeys(arguments.names or known))
    peers = [find(known, name, "peer").resolve() for name in names]
    bench = Bench(program, folder / "torus.ply")
    builder = Builder(folder, Compiler(folder / "package", arguments.settings), bench)
    if arguments.words is not None:
        plugins = plugins_there(builder, peers, named=bool(arguments.names))
        oracles = not arguments.names  # beside all
        print("\n".join(words_of_run(bench, plugins, arguments.words, oracles)))
        return 0
    with nobody_else_in(folder):
        install_package(program.parent, folder / "package")
        bench.make_mesh()
        missing = build_all(builder, peers)
    return EXIT_MISSING if missing and arguments.names else 0


def main(words: Sequence[str] | None = None) -> int:
    try:
        return run(parse_arguments(words))
    except (FetchError, Unavailable) as error:
        return console.complain(error)
    except OSError as error:  # also if a program is missing
        return console.complain(FetchError(console.reason_of(error)))
    except KeyboardInterrupt:
        return console.interrupted("a peer that was built is there, and the next call continues")


if __name__ == "__main__":
    sys.exit(main())
