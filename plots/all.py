#!/usr/bin/python3
"""Everything that can be drawn from a run folder."""

from __future__ import annotations

import sys

import table_5_1
import table_5_2
import table_5_2_ratios
import table_5_3
from command_line import draw
from results import Run
from table import Table

DRAWN = [table_5_1, table_5_2, table_5_2_ratios, table_5_3]


def tables(run: Run) -> list[Table]:
    return [table for module in DRAWN for table in module.tables(run)]


if __name__ == "__main__":
    sys.exit(draw(__doc__, tables))
