"""The checksum of a result file: SHA-256 of its text without the key and without space between words.
Rows in a file beside it have a sum of their own in that text."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

_WORDS = re.compile(r'"(?:[^"\\]|\\.)*"|[^\s"]+')
_KEY = re.compile(r',"checksum":"([0-9a-f]{64})"')


def stated(text: str) -> str | None:
    """What the file says of itself; None when it says nothing."""
    found = _KEY.search("".join(_WORDS.findall(text)))
    return found[1] if found else None


def computed(text: str) -> str:
    """What the file should say. It does not depend on how the text is indented."""
    compact = _KEY.sub("", "".join(_WORDS.findall(text)), count=1)
    return hashlib.sha256(compact.encode()).hexdigest()


def of_file(file: Path) -> str:
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
