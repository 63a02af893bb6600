"""Text files that a user wrote, or that another program saved."""

from __future__ import annotations

import codecs
from pathlib import Path


class NotUtf8(ValueError):
    """A text of another encoding that is known."""


def read_text(file: Path) -> str:
    """Returns the text without the byte order mark of UTF-8 that some editors put first.

    @raises NotUtf8 for the byte order marks of UTF-16
    @raises OSError, UnicodeDecodeError"""
    try:
        return file.read_text("utf-8-sig")
    except UnicodeDecodeError as error:
        if error.object.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
            raise NotUtf8(f"{file}: the text is UTF-16; save it as UTF-8") from None
        raise
