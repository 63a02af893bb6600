"""What disturbed a measurement: time that the hypervisor took, and involuntary switches."""

from __future__ import annotations

import resource
from dataclasses import dataclass
from pathlib import Path

STAT = Path("/proc/stat")
STEAL = 7  # column of the line "cpu": user nice system idle iowait irq softirq steal
MOST_STOLEN = 0.01
"""Of all processors' time."""
LEAST_TICKS = 1
"""Of 10 ms: a pair lasts only a few dozen, and a single one says nothing."""
MOST_SWITCHES = 500.0
"""Involuntary switches a second of CPU time. A core shared with two or three others has 200 to 350,
at which the CPU time of paired solves still spreads by only 2 to 3%."""
LEAST_SECONDS = 0.05
"""Of CPU time that switches are counted over: a single one says nothing."""


@dataclass(frozen=True)
class Moment:
    """Counters of the machine and of this process's children, all ever growing."""

    stolen: int
    total: int
    switches: int
    child_seconds: float


def now() -> Moment:
    ticks = _ticks()
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return Moment(
        stolen=ticks[STEAL] if len(ticks) > STEAL else 0,
        total=sum(ticks[: STEAL + 1]),
        switches=children.ru_nivcsw,
        child_seconds=children.ru_utime + children.ru_stime,
    )


def _ticks() -> list[int]:
    """Of all processors together since the start; empty where there is no /proc."""
    try:
        return [int(word) for word in STAT.read_text().splitlines()[0].split()[1:]]
    except (OSError, IndexError, ValueError):
        return []


def disturbance(before: Moment, after: Moment) -> str:
    """What went on in between, in words; empty when it was quiet enough to measure."""
    total = after.total - before.total
    stolen = after.stolen - before.stolen
    if stolen > max(MOST_STOLEN * total, LEAST_TICKS):
        return f"{stolen / total:.1%} of the time was stolen by the hypervisor"
    seconds = max(after.child_seconds - before.child_seconds, LEAST_SECONDS)
    switches = (after.switches - before.switches) / seconds
    if switches > MOST_SWITCHES:
        return f"{switches:.0f} involuntary switches a second"
    return ""
