"""How a command of this folder speaks: one line for whatever ends it, on any terminal.

Every command imports it before anything else, so that a package that is missing is told as well.
"""

from __future__ import annotations

import io
import os
import signal
import sys
from pathlib import Path
from types import TracebackType

HERE = Path(__file__).resolve().parent
PACKAGES = "python3-jsonschema, python3-matplotlib, python3-numpy and python3-scipy"


def printable(text: str) -> str:
    r"""Control characters as \x1b and the like: what a file says cannot move the cursor."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def complaint(error: BaseException) -> str:
    """One line; of an error of the system with the file, and what to do."""
    if isinstance(error, OSError) and error.strerror:
        # The system names no file that could be opened and then not be written, nor the output.
        what = error.strerror if error.filename is None else f"{error.strerror}: {error.filename}"
        return f"cannot write ({printable(what)}): is there another place (--out)?"
    return printable(str(error))


def complain(error: BaseException) -> int:
    """Says it; returns the exit code."""
    print(f"{Path(sys.argv[0]).name}: {complaint(error)}", file=sys.stderr)
    try:
        print(end="", flush=True)
    except OSError:  # what is left could not be written at the end either, and Python would say so
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 1


def _end(
    kind: type[BaseException], error: BaseException, trace: TracebackType | None
) -> None:
    """In place of a traceback, where it is no fault of the program."""
    local = isinstance(error, ImportError) and (HERE / f"{error.name}.py").exists()
    if isinstance(error, ImportError) and not local:
        what = f"{error}: it needs {PACKAGES}, as Debian's /usr/bin/python3 has them"
        complain(ImportError(what))
    elif isinstance(error, OSError):
        complain(error)
    elif isinstance(error, KeyboardInterrupt):
        complain(KeyboardInterrupt("interrupted; what has its name already is whole"))
    else:
        sys.__excepthook__(kind, error, trace)


if Path(sys.argv[0]).resolve().parent == HERE:  # and not a test that draws by itself
    sys.excepthook = _end
    os.environ["MPLBACKEND"] = "agg"  # no window is opened, whatever the shell asks for
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # `| head` ends it silently
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            # By lines: what cannot be written is noticed while it can still be said.
            stream.reconfigure(errors="backslashreplace", line_buffering=True)
