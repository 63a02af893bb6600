"""What ends the gate, and its exit codes."""

from __future__ import annotations

GOOD = 0
ERROR = 1
"""A usage or harness error: nothing was judged, or something that must be compared is not there."""
WRONG = 2
"""A wrong answer, or none where there should be one."""
REGRESSION = 3
INCONCLUSIVE = 4
"""Only with --strict: the machine was too noisy to tell."""


class GateError(Exception):
    """Ends the gate with ERROR; its message says what is wrong and what to do."""
