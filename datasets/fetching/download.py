"""The places of upstream files, and downloads over HTTP that resume earlier ones."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

import requests

from .archive import MAX_BYTES, PIECE
from .cache import check_sha256, sha256_of
from .reporting import Bars, FetchError, Unavailable

TIMEOUTS = (10.0, 30.0)  # seconds: to connect, and between two bytes
OK, PARTIAL, GONE, NO_SUCH_RANGE = 200, 206, (404, 410), 416

# Maps the path of an upstream file to a Path in a folder, or to an http(s) address. Raises
# Unavailable if the folder lacks the file.
Origin = Callable[[str], Path | str]


def origin_from_environment(variable: str, upstream: Callable[[str], str]) -> Origin:
    """Returns the mirror that an environment variable names, or else the upstream sites.

    `upstream`: maps a path to its address at the upstream sites. A mirror is a folder, or a file:// or
    http(s):// address, with the same paths below it. Raises FetchError for another kind of address.
    """
    place = os.environ.get(variable, "")
    if not place:
        return upstream
    parts = urlsplit(place)
    if parts.scheme in ("http", "https") and parts.netloc:
        return lambda path: f"{place.rstrip('/')}/{path}"
    if parts.scheme == "file" and parts.netloc in ("", "localhost"):
        return lambda path: _in_mirror(Path(url2pathname(parts.path)) / path)
    if "://" in place:
        raise FetchError(
            f"{variable} is {place}: it must be a folder, or an address that begins with "
            "file:///, http:// or https://"
        )
    return lambda path: _in_mirror(Path(place) / path)


def _in_mirror(file: Path) -> Path:
    if not file.is_file():
        raise Unavailable(f"is not in the mirror: there is no {file}")
    return file


class Downloader:
    """A session with all sites. A host that could not be reached is not tried again."""

    def __init__(self, progress: Bars, mirror_variable: str) -> None:
        """`mirror_variable`: environment variable that messages suggest to set."""
        self._progress = progress
        self._mirror_variable = mirror_variable
        self._session = requests.Session()
        # No compression in transit: a range counts uncompressed bytes.
        self._session.headers["Accept-Encoding"] = "identity"
        self._unreachable: dict[str, str] = {}

    def close(self) -> None:
        self._session.close()

    def complete(self, url: str, part: Path, sha256: str, label: str) -> None:
        """Completes `part`, which may hold the beginning, to the file with this sha256.

        Raises Unavailable; `part` then holds a beginning that can be resumed, or is removed.
        """
        begun = part.exists()
        if begun and sha256_of(part) == sha256:
            return
        self._transfer(url, part, label)
        if begun and sha256_of(part) != sha256:  # a wrong beginning or a wrong rest
            part.unlink()
            self._transfer(url, part, label)
        try:
            check_sha256(part, sha256, url)
        except Unavailable:
            part.unlink()
            raise

    def _transfer(self, url: str, part: Path, label: str) -> None:
        """Appends the missing bytes to `part`, or writes it anew if the server does not support that.

        Raises Unavailable.
        """
        have = part.stat().st_size if part.exists() else 0
        with self._request(url, have) as response:
            status = response.status_code
            if status in (OK, PARTIAL):
                self._receive(response, part, have if status == PARTIAL else 0, label)
                return
            if have and status == NO_SUCH_RANGE:  # it is longer than the file
                part.unlink()
            elif status in GONE:
                raise Unavailable(
                    f"is no longer at {url} ({status} {response.reason}); "
                    f"{self._mirror_variable} can name a mirror that still has it"
                )
            else:
                raise Unavailable(f"{url} answers {status} {response.reason}")
        self._transfer(url, part, label)  # without a beginning, so this happens once

    def _request(self, url: str, have: int) -> requests.Response:
        host = urlsplit(url).netloc
        if host in self._unreachable:
            raise Unavailable(self._unreachable[host])
        headers = {"Range": f"bytes={have}-"} if have else {}
        try:
            return self._session.get(url, headers=headers, stream=True, timeout=TIMEOUTS)
        except requests.ConnectionError as error:
            self._unreachable[host] = (
                f"cannot reach {host} ({_cause_of(error)}): check the network, "
                f"or set {self._mirror_variable} to a mirror"
            )
            raise Unavailable(self._unreachable[host]) from error
        except requests.RequestException as error:
            raise Unavailable(f"{url} cannot be had: {_cause_of(error)}") from error

    def _receive(self, response: requests.Response, part: Path, have: int, label: str) -> None:
        """Writes the body after the first `have` bytes. Raises Unavailable if the body is incomplete."""
        length = response.headers.get("Content-Length", "")
        total = have + int(length) if length.isdecimal() else None
        cause = None
        # The length is checked below. urllib3 2 would check it too, but drop the last bytes of an
        # incomplete body.
        response.raw.enforce_content_length = False
        with part.open("ab" if have else "wb") as file:
            with self._progress.download(label, total, have) as advance:
                try:
                    for piece in response.iter_content(PIECE):
                        file.write(piece)
                        advance(len(piece))
                        if file.tell() > MAX_BYTES:
                            break
                except requests.RequestException as error:
                    cause = _cause_of(error)
            size = file.tell()
        if size > MAX_BYTES:
            part.unlink()
            raise Unavailable(f"{response.url} has more than {MAX_BYTES} bytes: not used")
        if total is not None and size < total:
            cause = cause or "connection closed"
        if cause is not None:
            of_total = "" if total is None else f" of {total}"
            raise Unavailable(
                f"{response.url} broke off after {size}{of_total} bytes ({cause}): "
                "fetch again to continue"
            )


def _cause_of(error: BaseException) -> str:
    """Returns the innermost reason, as "Connection refused" instead of the names of five exceptions."""
    while True:
        inner = [error.__cause__, getattr(error, "reason", None), *error.args, error.__context__]
        nested = [each for each in inner if isinstance(each, BaseException)]
        if not nested:
            break
        error = nested[0]
    strerror = getattr(error, "strerror", None)
    return str(strerror or error or type(error).__name__).split("\n")[0]
