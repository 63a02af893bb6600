"""Extracts named files from an archive. Names that point outside the archive are refused."""

from __future__ import annotations

import gzip
import stat
import tarfile
import zipfile
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path, PurePosixPath
from typing import IO

from .reporting import Unavailable

MAX_BYTES = 2 << 30  # largest size of an upstream or unpacked file: ten times the largest mesh
PIECE = 1 << 20

# Exceptions of Python's readers for files that are damaged, encrypted or not an archive.
DAMAGE = (
    zipfile.BadZipFile,
    tarfile.TarError,
    gzip.BadGzipFile,
    zlib.error,
    EOFError,
    RuntimeError,
)


def extract(archive: Path, targets: Mapping[str, Path]) -> None:
    """Writes members of a zip, npz or tgz archive to their targets. Nothing else is unpacked.

    Raises Unavailable if the name of a member points outside the archive, if a member is missing or is
    not a regular file, if it unpacks to more than MAX_BYTES, or if the archive is damaged.
    """
    for member in filter(points_outside, targets):
        raise Unavailable(f"'{member}' points outside {archive.name}: not unpacked")
    opened = _zip_reader if archive.suffix in (".zip", ".npz") else _tar_reader
    member = ""
    try:
        with opened(archive) as read:
            for member, target in targets.items():
                with read(member) as source:
                    _copy(source, target, f"{member} in {archive.name}")
    except KeyError:
        raise Unavailable(f"{archive.name} holds no {member}") from None
    except DAMAGE as error:
        raise Unavailable(f"{archive.name} cannot be unpacked: {error}") from error


def points_outside(name: str) -> bool:
    """Whether a path in an archive or package leads outside it."""
    path = PurePosixPath(name)
    return path.is_absolute() or ".." in path.parts or "\\" in name


def gunzip(packed: Path, target: Path) -> None:
    """Unpacks a .gz file. Raises Unavailable if it is damaged or unpacks to more than MAX_BYTES."""
    try:
        with gzip.open(packed) as source:
            _copy(source, target, packed.name)
    except DAMAGE as error:
        raise Unavailable(f"{packed.name} cannot be unpacked: {error}") from error


Reader = Callable[[str], AbstractContextManager[IO[bytes]]]
"""Opens a member of an archive. Raises KeyError when it is missing."""


@contextmanager
def _zip_reader(archive: Path) -> Iterator[Reader]:
    with zipfile.ZipFile(archive) as opened:

        def read(member: str) -> IO[bytes]:
            mode = opened.getinfo(member).external_attr >> 16  # 0 if the system that made it has no modes
            if stat.S_IFMT(mode) not in (0, stat.S_IFREG) or member.endswith("/"):
                raise _no_plain_file(archive, member)
            return opened.open(member)

        yield read


@contextmanager
def _tar_reader(archive: Path) -> Iterator[Reader]:
    with tarfile.open(archive, "r:gz") as opened:

        def read(member: str) -> IO[bytes]:
            info = opened.getmember(member)
            source = opened.extractfile(info) if info.isreg() else None
            if source is None:
                raise _no_plain_file(archive, member)
            return source

        yield read


def _no_plain_file(archive: Path, member: str) -> Unavailable:
    return Unavailable(f"{member} in {archive.name} is not a regular file: not unpacked")


def _copy(source: IO[bytes] | gzip.GzipFile, target: Path, what: str) -> None:
    size = 0
    with target.open("wb") as file:
        while piece := source.read(PIECE):
            size += len(piece)  # counts unpacked bytes, because sizes in headers can be wrong
            if size > MAX_BYTES:
                raise Unavailable(f"{what} unpacks to more than {MAX_BYTES} bytes: not used")
            file.write(piece)
