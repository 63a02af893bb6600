"""An HTTP server on this machine that serves a folder, with or without faults."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path


@dataclass
class Site:
    """Options of the server of a folder, and the requests that it received."""

    folder: Path
    url: str = ""
    ranges: bool = True  # whether it can send the rest of a file
    cut_after: int | None = None  # number of bytes of a body after which it closes the connection
    with_length: bool = True
    stalls: bool = False  # whether it sends nothing after `cut_after` bytes and keeps the connection open
    status: int | None = None  # status of all answers; None: the usual ones
    shifted: bool = False  # whether it sends another range than the requested one
    asked: list[str] = field(default_factory=list)  # "/path" or "/path bytes=9-"
    done: threading.Event = field(default_factory=threading.Event)


class Handler(BaseHTTPRequestHandler):
    site: Site

    def do_GET(self) -> None:  # noqa: N802  (the name that http.server calls)
        site = self.site
        wanted = self.headers.get("Range")
        site.asked.append(" ".join(filter(None, [self.path, wanted])))
        file = site.folder / self.path.lstrip("/")
        if site.status or not file.is_file():
            self.send_error(site.status or 404)
            return
        data = file.read_bytes()
        begin = int(wanted.removeprefix("bytes=").rstrip("-")) if wanted and site.ranges else 0
        if begin and begin >= len(data):
            self.send_error(416)
            return
        self._send(data, max(0, begin - 1) if site.shifted else begin, partial=begin > 0)

    def _send(self, data: bytes, begin: int, partial: bool) -> None:
        body = data[begin:]
        self.send_response(206 if partial else 200)
        if self.site.with_length:
            self.send_header("Content-Length", str(len(body)))
        if partial:
            self.send_header("Content-Range", f"bytes {begin}-{len(data) - 1}/{len(data)}")
        self.end_headers()
        with suppress(ConnectionError):  # the client has closed the connection
            self.wfile.write(body[: self.site.cut_after])
            self.wfile.flush()
        if self.site.stalls:
            self.site.done.wait(30)

    def log_message(self, *words: object) -> None:
        pass


@contextmanager
def serving(folder: Path) -> Iterator[Site]:
    """Serves a folder until the end of the block."""
    site = Site(folder)
    handler = type("SiteHandler", (Handler,), {"site": site})
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        server.daemon_threads = True
        site.url = f"http://127.0.0.1:{server.server_address[1]}"
        thread = threading.Thread(target=server.serve_forever, args=(0.01,))
        thread.start()
        try:
            yield site
        finally:
            site.done.set()
            server.shutdown()
            thread.join()
