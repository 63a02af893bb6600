"""Names: of the solvers in a tree, and those that nothing has, in messages: the same text as
solvers/core/messages.h writes."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from pathlib import Path


def unknown_name(kind: str, name: str, known: Iterable[str]) -> str:
    """Returns "no corpus named 'quik' (did you mean 'quick'?); there are: quick, tiny"."""
    names = sorted(known)
    message = f"no {kind} named '{name}'"
    if not names:
        return f"{message}; there are: none"
    if nearest := difflib.get_close_matches(name, names, n=1):
        message += f" (did you mean '{nearest[0]}'?)"
    if len(names) <= 50:
        return f"{message}; there are: {', '.join(names)}"
    near = difflib.get_close_matches(name, names, n=8, cutoff=0)
    return f"{message}; the nearest of {len(names)}: {', '.join(near)}"


def registered(tree: Path) -> dict[str, Path]:
    """Returns the files of a tree that register solvers, by the solver's name. Nothing need be built."""
    return {
        name: file
        for file in sorted((tree / "solvers").glob("**/*.cpp"))
        for name in re.findall(r'\.name = "([^"]+)"', file.read_text("utf-8"))
    }
