"""How a command ends: one line for an error, on any terminal.

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
from typing import NoReturn

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = "python3-jinja2, python3-jsonschema, python3-matplotlib, python3-numpy and python3-scipy"


def printable(text: str) -> str:
    r"""Control characters as \x1b and the like, so that no file can move the cursor."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


_name = ""


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
        # Errors of writing to a file that is open name no file, nor do those of the output.
        what = error.strerror if error.filename is None else f"{error.strerror}: {error.filename}"
        return f"cannot write ({printable(what)}): is there another place (--out)?"
    return printable(str(error))


def complain(error: BaseException) -> int:
    """Prints the error to the error stream; returns the exit code."""
    print(f"{program()}: {complaint(error)}", file=sys.stderr)
    try:
        print(end="", flush=True)
    except OSError:  # the output is closed: without this, Python would report it again at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 1


class Parser(argparse.ArgumentParser):
    """An invalid argument gives one line, and the exit code of every other error."""

    def __init__(self, description: str | None, *examples: str) -> None:
        lines = ["examples:", *(f"  {example}" for example in examples)]
        super().__init__(
            prog=program(), description=description, epilog="\n".join(lines) if examples else None,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )  # fmt: skip

    def error(self, message: str) -> NoReturn:
        self.exit(1, f"{self.prog}: {printable(message)}; see {self.prog} --help\n")


def run_parser(description: str | None, *examples: str) -> Parser:
    """With the option --run, of type Path."""
    parser = Parser(description, *examples)
    parser.add_argument(
        "--run", type=Path, metavar="DIR", help="run folder (default: the newest of results/runs)"
    )
    return parser


def prepare(name: str = "") -> None:
    """Sets the process up as a command: errors that are no fault of the program end in one line,
    a closed pipe ends it silently, and any text can be printed.

    @param name as the user calls the command, where that is not the name of the script"""
    global _name
    _name = name
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
        complain(ImportError(f"{error}: it needs {PACKAGES}, as Debian's /usr/bin/python3 has them"))
    elif isinstance(error, OSError):
        complain(error)
    elif isinstance(error, KeyboardInterrupt):
        complain(KeyboardInterrupt("interrupted; files that have their final name are complete"))
    else:
        sys.__excepthook__(kind, error, trace)
