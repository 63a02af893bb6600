"""A bad input as a row of a table: its files, the command, and the expected error output."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Case:
    name: str
    command: str
    """Bash command. It runs in a folder that contains only `files` and `hill.obj`, a valid mesh. The PATH
    has every program of the project by its name, and the commands of bin/."""
    says: list[str]
    """Words of the error output: the cause (file and place, flag and value, or key) and the remedy."""
    code: int = 1
    files: Mapping[str, str | bytes] = field(default_factory=dict)
    given: str = ""
    """Commands that bash runs before."""
    lines: int = 1
    """Number of lines of the error output."""
    needs: str = ""
    """A command of bin/ that some machines do not permit. The test is skipped on these machines."""
