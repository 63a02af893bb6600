#!/usr/bin/python3
"""Is anything lost when runs are killed? Kills many, at random moments, and resumes them.

    tools/kill_study.py --bench build/release/geodesic-bench [--kills 200] [--seed 1]

Every run must end with the files of an uninterrupted run, equal in every byte except times. Saved cells
must not be measured again, and no process may be left. Prints a table in Markdown and exits with 1 at
the first loss, whose folder it keeps.
"""

from __future__ import annotations

import argparse
import shutil
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "reliability"))

from killing import Killing, Lost  # noqa: E402  (needs the path above)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--bench", type=Path, required=True, help="the program geodesic-bench")
    parser.add_argument("--kills", type=int, default=200, metavar="N")
    parser.add_argument("--seed", type=int, default=1)
    wish = parser.parse_args()
    if not wish.bench.is_file():
        parser.error(f"there is no program {wish.bench}; ./run_all.sh build makes it")
    folder = Path(tempfile.mkdtemp(prefix="geodesic-kills-"))
    began = time.monotonic()
    try:
        killing = Killing(wish.bench, folder, wish.seed)
        killing.until_killed(wish.kills)
    except Lost as lost:
        print(f"kill_study.py: lost: {lost} (seed {wish.seed}; kept: {folder})", file=sys.stderr)
        return 1
    shutil.rmtree(folder)
    tally = killing.tally
    print("| runs | kills | of them | files compared a run | seconds |\n|---|---|---|---|---|")
    kinds = ", ".join(f"{count} {name}" for name, count in sorted(tally.kills.items()))
    seconds = round(time.monotonic() - began)
    print(f"| {tally.runs} | {tally.total} | {kinds} | {len(killing.expected)} | {seconds} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
