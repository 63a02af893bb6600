"""What the gate says while it measures. It goes to the error stream: the output is only the verdict."""

from __future__ import annotations

import sys

from results import console


def say(line: str) -> None:
    console.say(line, sys.stderr)


def about(seconds: float) -> str:
    """Returns a duration as text, such as "about 40 s" or "about 3 min"."""
    if seconds < 90:
        return f"about {max(10 * round(seconds / 10), 10)} s"
    return f"about {round(seconds / 60)} min"
