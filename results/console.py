"""Output and errors of commands: an error is one line, on any terminal.

A command calls `prepare` before it imports a module that may be missing.
"""

from __future__ import annotations

import argparse
import io
import json
import os
import re
import signal
import sys
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, NoReturn, Self, TextIO

if TYPE_CHECKING:
    from _typeshed import SupportsWrite

from .names import unknown_name

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = "python3-jinja2, python3-jsonschema, python3-matplotlib, python3-numpy and python3-scipy"
EXIT_INTERRUPTED = 130
ERASE_LINE = "\r\033[K"


def printable(text: str) -> str:
    r"""Escapes control characters, as in \x1b, so that no text of a file can move the cursor."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def say(line: str, stream: TextIO | None = None) -> None:
    """Prints a line with control characters escaped. @param stream None for the standard output"""
    print(printable(line), file=stream, flush=True)


def reason_of(error: OSError) -> str:
    """Returns "No space left on device: /the/file". The file is omitted if the error names none, as
    for errors of an open file or of the output."""
    return ": ".join(str(part) for part in (error.strerror or error, error.filename) if part)


class StatusLine:
    """One line on the terminal of the error stream that is kept up to date. Nothing is written elsewhere. It
    is erased before another line is printed, and at the end of the block."""

    def __init__(self) -> None:
        self._stream = sys.stderr if sys.stderr.isatty() else None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.clear()

    def show(self, text: str) -> None:
        if self._stream:
            print(f"{ERASE_LINE}{printable(text)}", end="", file=self._stream, flush=True)

    def clear(self) -> None:
        if self._stream:
            print(ERASE_LINE, end="", file=self._stream, flush=True)


_name = ""
_packages = PACKAGES
_place = "--out"


def program() -> str:
    """Returns the name at the beginning of messages: the name given to `prepare`, else the name of the
    script, or of the package that runs with -m."""
    script = Path(sys.argv[0])
    if _name:
        return _name
    return script.parent.name if script.name == "__main__.py" else script.name


def complaint(error: BaseException) -> str:
    """Returns the error as one line. An error of the system has its file and a suggestion."""
    if isinstance(error, OSError) and error.strerror:
        return f"cannot write ({printable(reason_of(error))}): is there another place ({_place})?"
    return printable(str(error))


def complain(error: BaseException) -> int:
    """Prints the error to the error stream and returns the exit code."""
    print(f"{program()}: {complaint(error)}", file=sys.stderr)
    try:
        print(end="", flush=True)
    except OSError:  # the output is closed: without this, Python would report it again at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 1


def interrupted(left: str = "files that have their final name are complete") -> int:
    """Prints that the command was interrupted and what it leaves; returns the exit code."""
    complain(KeyboardInterrupt(f"interrupted; {left}"))
    return EXIT_INTERRUPTED


class Parser(argparse.ArgumentParser):
    """Reports an invalid argument in one line, with the same exit code as every other error."""

    def __init__(self, description: str | None, *examples: str) -> None:
        lines = ["examples:", *(f"  {example}" for example in examples)]
        super().__init__(
            prog=program(), description=description, epilog="\n".join(lines) if examples else None,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )  # fmt: skip

    def print_help(self, file: SupportsWrite[str] | None = None) -> None:
        """Raises OSError if the help cannot be written; argparse ignores that since Python 3.12."""
        print(self.format_help(), end="", file=file)
        sys.stdout.flush()

    def error(self, message: str) -> NoReturn:
        if word := re.match(r"unrecognized arguments: (--[^ =]+)", message):
            options = [name for name in self._option_string_actions if name.startswith("--")]
            message = unknown_name("option", word[1], options)
        self.exit(1, f"{self.prog}: {printable(message)}; see {self.prog} --help\n")


RUN = "run folder (default: the newest of results/runs)"


def bench() -> str:
    """Returns the path of geodesic-bench: what GEODESIC_BENCH names, or the checkout's build.
    @raises FileNotFoundError when there is neither"""
    built = ROOT / "build" / "release" / "geodesic-bench"
    if not (named := os.environ.get("GEODESIC_BENCH")) and not built.exists():
        raise FileNotFoundError(f"{built}: not built; ./run_all.sh build makes it, or set GEODESIC_BENCH")
    return named or str(built)


def plugin_words() -> list[str]:
    """Returns the words that load the plug-ins of this command into geodesic-bench, which started it."""
    words: list[str] = json.loads(os.environ.get("GEODESIC_PLUGINS", "[]"))
    return words


def run_parser(description: str | None, *examples: str) -> Parser:
    """Returns a parser with the optional argument RUN of type Path."""
    parser = Parser(description, *examples)
    parser.add_argument("run", nargs="?", type=Path, metavar="RUN", help=RUN)
    return parser


def prepare(name: str = "", packages: str = PACKAGES, place: str = "--out") -> None:
    """Prepares the process for a command: an error that is not a fault of the program ends it with one
    line, a closed pipe ends it silently, and any text can be printed.

    @param name name of the command for the user, if it is not the name of the script
    @param packages names of the Debian packages that it needs
    @param place the option that names the place of the output"""
    global _name, _packages, _place
    _name, _packages, _place = name, packages, place
    sys.excepthook = _end
    os.environ["MPLBACKEND"] = "agg"  # matplotlib opens no window
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            # Line buffering: a full disk is detected while it can still be reported.
            stream.reconfigure(errors="backslashreplace", line_buffering=True)


def _end(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
    ours = isinstance(error, ImportError) and (ROOT / str(error.name).split(".")[0]).exists()
    if isinstance(error, ImportError) and not ours:
        complain(ImportError(f"{error}: it needs {_packages}, as Debian's /usr/bin/python3 has them"))
    elif isinstance(error, OSError):
        complain(error)
    elif isinstance(error, KeyboardInterrupt):
        interrupted()
    else:
        sys.__excepthook__(kind, error, trace)
