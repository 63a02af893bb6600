"""Merged shards equal the whole run. An error names shards that are not of one run."""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from shards import Sharded, differences

from plots import catalogue
from results import checksum
from results.reader import read_run


@pytest.fixture
def sharded(bench: Path, tmp_path: Path) -> Sharded:
    return Sharded(bench, tmp_path)


@pytest.fixture(scope="module")
def three(bench: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run as a whole, `whole`, and in three `shards`. Tests must not change them."""
    world = Sharded(bench, tmp_path_factory.mktemp("three"))
    assert world.run("--out", "whole", "--recordings", "all").returncode == 0
    world.shards(3, "--recordings", "all")
    return world.folder


@pytest.mark.parametrize("most", ["100", "3"], ids=["JSON", "columns"])
def test_merged_shards_are_the_run_in_one_piece(
    sharded: Sharded, three: Path, tmp_path: Path, most: str
) -> None:
    ended = sharded.merge(three / "shards", "--out", "merged", "--rows-in-json", most)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.startswith("3 shards: 54 rows of 2 meshes, measured on ")
    merged = tmp_path / "merged"
    assert (merged / "rows.npz").exists() == (most == "3")
    assert differences(three / "whole", merged) == []
    assert [part["shard"] for part in read_run(merged).ours["parts"]] == [1, 2, 3]
    assert len(read_run(merged).environments) == 1, "all shards were measured here"
    recordings = [sorted(str(file.relative_to(of)) for file in of.rglob("*.npy"))
                  for of in (three / "whole" / "recordings", merged / "recordings")]  # fmt: skip
    assert recordings[0] and recordings[0] == recordings[1]
    assert sharded.bench_says("check", merged).returncode == 0
    again = sharded.merge(three / "shards", "--out", "merged")
    assert again.returncode == 0, "a merged file can be made again"


def test_all_solvers_of_a_source_are_in_one_shard_also_when_they_alternate(
    sharded: Sharded, tmp_path: Path
) -> None:
    assert sharded.run("--interleave", "--out", "whole").returncode == 0
    shards = sharded.shards(2, "--interleave")
    sources = [{(row.mesh, row.source) for row in read_run(shards / n).rows} for n in "12"]
    assert not sources[0] & sources[1] and len(sources[0] | sources[1]) == 9
    assert sharded.merge(shards, "--out", "merged").returncode == 0
    assert differences(tmp_path / "whole", tmp_path / "merged") == []


def test_a_shard_that_was_stopped_is_named_and_goes_on_as_it_was(
    sharded: Sharded, three: Path, tmp_path: Path
) -> None:
    shutil.copytree(three / "shards", tmp_path / "shards")
    second = tmp_path / "shards" / "2"
    (second / "run.json").unlink()
    next((second / "cells").iterdir()).unlink()
    refused = sharded.merge("shards", "--out", "merged")
    assert refused.returncode == 1 and not (tmp_path / "merged").exists()
    assert "missing: 1 of 3 shards: 2" in refused.stderr
    assert "shards/2 is not finished: geodesic-bench run --resume shards/2" in refused.stderr
    assert sharded.merge("shards", "--out", "part", "--allow-gaps").returncode == 0
    check = sharded.bench_says("check", "part")
    assert check.returncode == 1 and "FAILED: shard 2/3: missing" in check.stdout
    resumed = sharded.bench_says("run", "--resume", second)
    assert resumed.returncode == 0 and "5 of 6 cells are kept" in resumed.stderr
    assert sharded.merge("shards", "--out", "merged").returncode == 0
    assert differences(three / "whole", tmp_path / "merged") == []


Context = dict[str, Any]


def ours(change: Callable[[Context], object]) -> Callable[[Path], None]:
    """Changes the context of the second shard."""

    def apply(shards: Path) -> None:
        file = shards / "2" / "run.json"
        data = json.loads(file.read_text())
        change(data["context"]["geodesic_bench"])
        file.write_text(json.dumps(data))

    return apply


def shard(**values: Any) -> Callable[[Path], None]:
    return ours(lambda context: context["shard"].update(values))


def seed_2(context: Context) -> None:
    context["seed"] = 2
    context["shard"]["suite"] = 64 * "0"


def moved(context: Context) -> None:
    context["sources"]["box"] = context["shard"]["sources"]["box"]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (ours(seed_2), "its solvers, options or suite differ (seed: 2, not 1)"),
        (shard(program=64 * "0"), "another build of geodesic-bench"),
        (shard(meshes=64 * "0"), "was planned for other meshes"),
        (shard(of=4), "is one of 4 shards, and"),
        (shard(index=1), "shard 1/3 is in both"),
        (shard(index=5), "shard 5 of 3"),
        (ours(lambda c: c["meshes"][0].update(sha256=64 * "0")), "mesh box is another file in"),
        (ours(moved), "box, source 0, is in both"),
        (shard(places={}), "has no place in the run"),
        (ours(lambda c: c.pop("shard")), "not a shard of a run: run --shard K/N makes them"),
        (lambda shards: (shards / "2" / "run.json").write_text("{"), "not JSON, perhaps truncated"),
        (lambda shards: shutil.rmtree(shards / "2"), "missing: 1 of 3 shards: 2"),
    ],
)  # fmt: skip
def test_what_is_not_one_run_is_refused_in_a_line(
    sharded: Sharded, three: Path, tmp_path: Path, change: Callable[[Path], None], words: str
) -> None:
    shutil.copytree(three / "shards", tmp_path / "shards")
    change(tmp_path / "shards")
    ended = sharded.merge("shards", "--out", "merged")
    assert ended.returncode == 1 and words in ended.stderr, ended.stderr
    assert len(ended.stderr.splitlines()) == 1 and not (tmp_path / "merged").exists()


def test_a_run_of_its_own_is_not_written_over(sharded: Sharded, three: Path) -> None:
    before = (three / "whole" / "run.json").read_bytes()
    ended = sharded.merge(three / "shards", "--out", three / "whole")
    assert ended.returncode == 1 and "holds a run of its own" in ended.stderr
    assert (three / "whole" / "run.json").read_bytes() == before


def on_another_processor(cell: Path) -> None:
    """Changes the processor and the checksum of a cell. Edits the text, because Python would write some
    numbers with other digits."""
    text = cell.read_text()
    stated = checksum.stated(text)
    assert stated is not None and stated == checksum.computed(text)
    text, places = re.subn(r'("processor":\s*)"[^"]*"', r'\1"Abacus"', text)
    assert places == 2, "of the row and of the environment"
    cell.write_text(text.replace(stated, checksum.computed(text)))


def test_what_another_processor_left_unfinished_is_measured_again(
    sharded: Sharded, tmp_path: Path
) -> None:
    assert sharded.run("--shard", "1/2", "--out", "shards/1").returncode == 0
    cells = sorted((tmp_path / "shards" / "1" / "cells").iterdir())
    for cell in cells:
        on_another_processor(cell)
    cells[0].unlink()
    source = cells[0].stem.split("__src")[1]
    mesh = cells[0].stem.split("__")[1]
    (tmp_path / "shards" / "1" / "run.json").unlink()
    resumed = sharded.bench_says("run", "--resume", "shards/1")
    assert resumed.returncode == 0, resumed.stderr
    assert f"{mesh}, source {source}: was begun on another processor" in resumed.stderr
    assert sharded.run("--shard", "2/2", "--out", "shards/2").returncode == 0
    assert sharded.merge("shards", "--out", "merged").returncode == 0
    run = read_run(tmp_path / "merged")
    [one, other] = sorted(run.processors, key="Abacus".__ne__)
    elsewhere, here = (
        {(row.mesh, row.source) for row in run.rows if row.processor == name} for name in (one, other)
    )
    assert len(elsewhere) == 3 and len(here) == 6 and not elsewhere & here
    assert (mesh, int(source)) in here
    drawn, left_out = catalogue.draw(run, ["ratios", "every_solver"])
    assert list(drawn) == ["ratios"] and list(left_out) == ["every_solver"]
