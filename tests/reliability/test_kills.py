"""Nothing is lost by a kill: a short form of kill_study.py, and that it would find a loss."""

from __future__ import annotations

from pathlib import Path

import pytest
from killing import Killing, Lost


@pytest.mark.parametrize("seed", [1, 2])
def test_killed_runs_end_as_if_they_had_not_been_killed(
    bench: Path, tmp_path: Path, seed: int
) -> None:
    killing = Killing(bench, tmp_path, seed)
    killing.until_killed(8)
    assert killing.tally.total == 8


def test_a_loss_is_found(bench: Path, tmp_path: Path) -> None:
    killing = Killing(bench, tmp_path, 1)
    lost = next(name for name in killing.expected if name.endswith(".npy"))
    killing.expected[lost] += b"x"
    with pytest.raises(Lost, match="differs"):
        killing.until_killed(1)
