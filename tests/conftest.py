"""Of all tests: what they must not inherit from the shell they are started in, and the program."""

import os
import signal
from pathlib import Path

import pytest

# Shells have what they start with `&` ignore Ctrl-C, and programs hand that down.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def bench() -> Path:
    """The program under test."""
    program = os.environ.get("GEODESIC_BENCH")
    if program is None:
        pytest.skip("GEODESIC_BENCH names no program; ./run_tests.sh sets it")
    return Path(program).resolve()
