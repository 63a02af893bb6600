"""What commands print, and how they end: one line for an error, on any terminal.

A command calls `prepare` before it imports anything that may be missing.
"""

from __future__ import annotations

import argparse
import io
import os
import signal
import sys
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, NoReturn, TextIO

if TYPE_CHECKING:
    from _typeshed import SupportsWrite

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = "python3-jinja2, python3-jsonschema, python3-matplotlib, python3-numpy and python3-scipy"
EXIT_INTERRUPTED = 130


def printable(text: str) -> str:
    r"""Control characters as \x1b and the like, so that no file can move the cursor."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def say(line: str, stream: TextIO | None = None) -> None:
    """@param stream by default the output"""
    print(printable(line), file=stream, flush=True)


def reason_of(error: OSError) -> str:
    """'No space left on device: /the/file'; without a file where the error names none, as those of
    an open file and of the output."""
    return ": ".join(str(part) for part in (error.strerror or error, error.filename) if part)


_name = ""
_packages = PACKAGES
_place = "--out"


def program() -> str:
    """The name that messages begin with: as given to `prepare`, else that of the script, or of the
    package run with -m."""
    script = Path(sys.argv[0])
    if _name:
        return _name
    return script.parent.name if script.name == "__main__.py" else script.name


def complaint(error: BaseException) -> str:
    """One line; an error of the system with its file and a way out."""
    if isinstance(error, OSError) and error.strerror:
        return f"cannot write ({printable(reason_of(error))}): is there another place ({_place})?"
    return printable(str(error))


def complain(error: BaseException) -> int:
    """Prints the error to the error stream; returns the exit code."""
    print(f"{program()}: {complaint(error)}", file=sys.stderr)
    try:
        print(end="", flush=True)
    except OSError:  # the output is closed: without this, Python would report it again at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 1


def interrupted(left: str = "files that have their final name are complete") -> int:
    """Says so and what is left behind; returns the exit code."""
    complain(KeyboardInterrupt(f"interrupted; {left}"))
    return EXIT_INTERRUPTED


class Parser(argparse.ArgumentParser):
    """An invalid argument gives one line, and the exit code of every other error."""

    def __init__(self, description: str | None, *examples: str) -> None:
        lines = ["examples:", *(f"  {example}" for example in examples)]
        super().__init__(
            prog=program(), description=description, epilog="\n".join(lines) if examples else None,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )  # fmt: skip

    def print_help(self, file: SupportsWrite[str] | None = None) -> None:
        """Raises OSError where it cannot be written, which argparse leaves out from Python 3.12 on."""
        print(self.format_help(), end="", file=file)
        sys.stdout.flush()

    def error(self, message: str) -> NoReturn:
        self.exit(1, f"{self.prog}: {printable(message)}; see {self.prog} --help\n")


RUN = "run folder (default: the newest of results/runs)"


def run_parser(description: str | None, *examples: str) -> Parser:
    """With the argument RUN, of type Path, which may be left out."""
    parser = Parser(description, *examples)
    parser.add_argument("run", nargs="?", type=Path, metavar="RUN", help=RUN)
    return parser


def prepare(name: str = "", packages: str = PACKAGES, place: str = "--out") -> None:
    """Sets the process up as a command: errors that are no fault of the program end in one line,
    a closed pipe ends it silently, and any text can be printed.

    @param name as the user calls the command, where that is not the name of the script
    @param packages of Debian that it needs
    @param place the option that names where it writes"""
    global _name, _packages, _place
    _name, _packages, _place = name, packages, place
    sys.excepthook = _end
    os.environ["MPLBACKEND"] = "agg"  # matplotlib opens no window
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            # By lines: a full disk is noticed while it can still be reported.
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
