"""The cluster fixture for the tests of this folder. tests/slurm/slurm.sh starts them."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "reliability")]

from cluster import Cluster, why_not  # noqa: E402  (needs the path above)


@pytest.fixture(scope="session")
def cluster() -> Iterator[Cluster]:
    if "GEODESIC_SLURM_TEST" not in os.environ:
        pytest.skip("three minutes with a cluster of its own: tests/slurm/slurm.sh")
    if reason := why_not():
        pytest.skip(reason)
    with Cluster(nodes=3) as running:
        yield running
