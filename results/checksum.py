"""The checksum of a result file: SHA-256 of its text without the key `checksum` and without white space
between words. The text contains a separate checksum of the file with the rows, if there is one."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

_WORDS = re.compile(r'"(?:[^"\\]|\\.)*"|[^\s"]+')
_KEY = re.compile(r',"checksum":"([0-9a-f]{64})"')


def stated(text: str) -> str | None:
    """Returns the checksum that the text states, or None if it states none."""
    found = _KEY.search("".join(_WORDS.findall(text)))
    return found[1] if found else None


def computed(text: str) -> str:
    """Returns the checksum that the text should state. It does not depend on the indentation."""
    compact = _KEY.sub("", "".join(_WORDS.findall(text)), count=1)
    return hashlib.sha256(compact.encode()).hexdigest()


def of_file(file: Path) -> str:
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()
