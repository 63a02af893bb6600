"""Text files that a user wrote, or that another program saved."""

from __future__ import annotations

import codecs
import zlib
from pathlib import Path

MOST = 1 << 30
"""Largest number of bytes that a file may be unpacked to."""


class NotText(ValueError):
    """A text of another encoding that is known, or a packed file that cannot be unpacked."""


def read_text(file: Path) -> str:
    """Returns the text without the byte order mark of UTF-8 that some editors put first. The text of a file
    named *.gz is packed by gzip.

    @raises NotText for the byte order marks of UTF-16 and for a broken packed file
    @raises OSError, UnicodeDecodeError"""
    try:
        data = file.read_bytes()
        text = (_unpacked(file, data) if file.suffix == ".gz" else data).decode("utf-8-sig")
        return text.replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        if error.object.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
            raise NotText(f"{file}: the text is UTF-16; save it as UTF-8") from None
        raise


def _unpacked(file: Path, data: bytes) -> bytes:
    packed = zlib.decompressobj(zlib.MAX_WBITS | 16)
    try:
        text = packed.decompress(data, MOST)
    except zlib.error:
        raise NotText(f"{file}: not packed by gzip, or damaged; get a whole copy") from None
    if not packed.eof:
        what = f"more than {MOST >> 20} MB" if packed.unconsumed_tail else "truncated; get a whole copy"
        raise NotText(f"{file}: {what}")
    return text
