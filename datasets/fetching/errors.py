"""What can go wrong while fetching, by how far it reaches."""

from __future__ import annotations


class FetchError(Exception):
    """Concerns all of the fetch: nothing more can be had. The message says what to do."""


class CacheError(FetchError):
    """The cache cannot be written."""


class Unavailable(Exception):
    """One mesh or elevation grid cannot be had; the message says why and what to do."""


def printable(text: str) -> str:
    r"""Control characters as \x1b and the like: no file and no site can move the cursor."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def reason_of(error: OSError) -> str:
    """'No space left on device: /the/file'."""
    return ": ".join(str(part) for part in (error.strerror or error, error.filename) if part)
