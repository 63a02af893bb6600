"""Fixtures of all tests; also resets a signal handler that tests must not inherit from the shell."""

import os
import signal
from pathlib import Path

import pytest

# Commands that a shell starts with `&` ignore Ctrl-C, and their child processes inherit this.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def bench() -> Path:
    """The program under test."""
    program = os.environ.get("GEODESIC_BENCH")
    if program is None:
        pytest.skip("GEODESIC_BENCH names no program; ./run_tests.sh sets it")
    return Path(program).resolve()
