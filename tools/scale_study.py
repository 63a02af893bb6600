#!/usr/bin/python3
"""Does a run of a million cells go through? Plans, shards, merges, checks and draws one.

    GEODESIC_BENCH=build/release/geodesic-bench tools/scale_study.py [--meshes 10000] [--shards 100]

The mesh files are real, and a run on them is planned. The results of the shards are invented, in files in
the format of `run`: ten solvers, ten sources, one repetition. Prints a table in Markdown with the time and
the largest memory of each step, and exits with 1 if the steps together take more than two minutes or if
one of them takes more than 2 GB.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

SOLVERS = "edge-based,mmp,fwp-mmp,ich,fwp-ch,ch,dijkstra,fast-marching,steiner"
SOURCES = 10
MOST_SECONDS, MOST_BYTES = 120, 2_000_000_000
TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
PROCESSORS = ("Abacus", "Babbage")

Data = dict[str, Any]


class Scale:
    def __init__(self, bench: Path, folder: Path, meshes: int, shards: int) -> None:
        self.bench, self.folder, self.meshes, self.shards = bench, folder, meshes, shards
        self.steps: list[tuple[str, float, int]] = []
        self.files = folder / "meshes"

    def step(self, name: str, *words: object, also: int = 0) -> str:
        """Runs a command of geodesic-bench and returns its output.

        @param also an exit code besides 0 that is not an error"""
        began = time.monotonic()
        with (self.folder / "output").open("w+", encoding="utf-8") as output:
            process = subprocess.Popen([self.bench, *map(str, words)], stdout=output, cwd=self.folder)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            output.seek(0)
            text = output.read()
        if process.returncode not in (0, also):
            raise SystemExit(f"scale_study.py: {name}: exit code {process.returncode}")
        self.steps.append((name, time.monotonic() - began, usage.ru_maxrss * 1024))
        return text

    def make_meshes(self) -> None:
        """Writes mesh files of different sizes, a hundred per folder. They are planned, but not solved."""
        for index in range(self.meshes):
            file = self.files / f"{index // 100:03}" / f"{index:05}.obj"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(TETRAHEDRON + "# \n" * (index * 37 % 1000))

    def first_shard(self) -> Data:
        """Returns the run.json of a real shard of one tetrahedron, whose cells take little time."""
        small = self.folder / "small"
        words: list[str | Path] = ["run", "--folder", small, "--solvers", SOLVERS, "--sources", "1",
                                   "--repetitions", "1", "--min-time", "0.0001",
                                   "--recordings", "none", "--shard", "1/1"]  # fmt: skip
        small.mkdir()
        (small / "one.obj").write_text(TETRAHEDRON)
        command = [self.bench, *words, "--out", self.folder / "real"]
        subprocess.run(command, check=True, capture_output=True)
        data: Data = json.loads((self.folder / "real" / "run.json").read_text())
        return data

    def make_shards(self, real: Data) -> None:
        """Writes the shards. Each has the sources of some meshes and one of two processors."""
        random = np.random.default_rng(1)
        ours = real["context"]["geodesic_bench"]
        mesh_like, rows_like = ours["meshes"][0], real["benchmarks"]
        sources = list(range(SOURCES))
        names = [f"{index // 100:03}.{index:05}" for index in range(self.meshes)]
        vertices = np.exp(random.uniform(np.log(1e3), np.log(1e6), self.meshes)).astype(int)
        pairs = [(mesh, source) for mesh in range(self.meshes) for source in sources]
        for shard in range(self.shards):
            own = pairs[shard :: self.shards]
            of: dict[int, list[int]] = {}
            for mesh, source in own:
                of.setdefault(mesh, []).append(source)
            meshes = sorted(of)
            ours["processor"] = PROCESSORS[shard % 2]
            ours["meshes"] = [
                mesh_like | {"name": names[m], "vertices": int(vertices[m]),
                             "faces": 2 * int(vertices[m]), "sha256": f"{m:064x}"}
                for m in meshes
            ]  # fmt: skip
            ours["sources"] = {names[m]: of[m] for m in meshes}
            ours["shard"] |= {
                "index": shard + 1, "of": self.shards,
                "places": {names[m]: m for m in meshes},
                "sources": {names[m]: sources for m in meshes},
            }  # fmt: skip
            rows = []
            for place, (mesh, source) in enumerate(own):
                for number, like in enumerate(rows_like):
                    rows.append(self._row(like, names[mesh], source, float(vertices[mesh]), random)
                                | {"family_index": place * len(rows_like) + number})  # fmt: skip
            out = self.folder / "shards" / str(shard + 1)
            out.mkdir(parents=True)
            (out / "run.json").write_text(json.dumps(real | {"benchmarks": rows}, indent=2))

    @staticmethod
    def _row(like: Data, mesh: str, source: int, vertices: float, random: Any) -> Data:
        name = f"{like['solver']}/{mesh}/src:{source}"
        factor = float(random.lognormal(0, 0.3)) * vertices**1.3 / 4
        times = {key: like[key] * factor for key in ("real_time", "cpu_time")}
        counts = {
            key: int(value * vertices)
            for key, value in like.items()
            if key in ("window_propagations", "windows_created", "valid_windows", "window_limit")
        }
        return like | times | counts | {"name": name, "run_name": name, "mesh": mesh, "source": source}


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--meshes", type=int, default=10_000)
    parser.add_argument("--shards", type=int, default=100)
    parser.add_argument("--keep", type=Path, help="folder for the files, which stay there")
    wish = parser.parse_args()
    bench = Path(os.environ.get("GEODESIC_BENCH", "build/release/geodesic-bench")).resolve()
    if not bench.is_file():
        parser.error(f"there is no program {bench}: GEODESIC_BENCH names one")
    folder: Path = (wish.keep or Path(tempfile.mkdtemp(prefix="geodesic-scale-"))).absolute()
    folder.mkdir(exist_ok=True)
    scale = Scale(bench, folder, wish.meshes, wish.shards)
    scale.make_meshes()
    scale.make_shards(scale.first_shard())
    words = ["--folder", scale.files, "--solvers", SOLVERS, "--sources", SOURCES, "--plan"]
    print(scale.step("plan", "run", *words))
    scale.step("shard", "run", *words, "--shard", f"1/{wish.shards}")
    scale.step("merge", "merge", "shards", "--out", "merged")
    scale.step("check", "check", "merged")
    scale.step("report", "report", "merged")
    size = sum(file.stat().st_size for file in (folder / "shards").rglob("run.json"))
    print(f"shards: {size / 1e6:.0f} MB; merged: "
          f"{sum(f.stat().st_size for f in (folder / 'merged').glob('r*')) / 1e6:.0f} MB")  # fmt: skip
    print("\n| step | seconds | memory (MB) |\n|---|--:|--:|")
    for name, seconds, memory in scale.steps:
        print(f"| {name} | {seconds:.1f} | {memory / 1e6:.0f} |")
    seconds = sum(seconds for _, seconds, _ in scale.steps)
    memory = max(memory for _, _, memory in scale.steps)
    print(f"| all | {seconds:.1f} | {memory / 1e6:.0f} |")
    if wish.keep is None:
        shutil.rmtree(folder)
    return 0 if seconds <= MOST_SECONDS and memory <= MOST_BYTES else 1


if __name__ == "__main__":
    sys.exit(main())
