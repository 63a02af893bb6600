"""A bad input as a row of a table: how it is made, what is typed, and what is said of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Case:
    name: str
    command: str
    """What is typed into bash, in an empty folder that holds `files` and `hill.obj`, a good mesh.
    Every program of the project is on the PATH by its name, and so are the words of bin/."""
    says: list[str]
    """Words of the error output: the thing (file and place, flag and value, key) and what to do."""
    code: int = 1
    files: Mapping[str, str | bytes] = field(default_factory=dict)
    given: str = ""
    """What bash does before."""
    lines: int = 1
    """Of the error output."""
    needs: str = ""
    """A word of bin/ that not every machine permits; where it does not, the test is skipped."""
