"""The reader accepts files that match the schema. For other files it states the error in one line."""

from __future__ import annotations

import gzip
import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from results.reader import SCHEMA, Cell, ResultError, Run, newest_run, read_file, read_run

Change = Callable[[dict[str, Any]], object]
Changed = Callable[[Change], Path]

COMPARE = Path("/usr/share/benchmark/compare.py")
"""Google Benchmark's tool. Debian's Python has the modules that it imports."""

PROGRAMS = [
    {"name": name, "path": f"/bin/{name}", "sha256": 64 * "a", "revision": "unknown",
     "modified": None, "compiler": "g++", "compiler_flags": "", "build_type": "Release"}
    for name in ("base", "head")
]  # fmt: skip


def error_of(folder: Path) -> str:
    with pytest.raises(ResultError) as raised:
        read_run(folder)
    message = str(raised.value)
    assert "\n" not in message
    return message


def test_schema_is_a_schema() -> None:
    jsonschema.Draft202012Validator.check_schema(json.loads(SCHEMA.read_text()))


def test_golden_run_has_typed_rows(golden_run: Run) -> None:
    row = golden_run.cell("horse", "edge-based")[0]
    assert (row.source, row.repetition, row.ok, row.reference) == (0, 0, True, "mmp")
    assert row.numbers["window_propagations"] == 3191999
    assert golden_run.meshes["rocker-arm"].stand_in
    assert not golden_run.solvers["dijkstra"].exact
    assert golden_run.sources["horse"] == [0, 31415]


def test_numbers_of_an_object_have_its_name_before_theirs(golden_run: Run, tmp_path: Path) -> None:
    data = json.loads(golden_run.file.read_text())
    phases = {"propagation": 0.2, "trimming": 0.1, "queue": 0.05, "timer_overhead": 0.02}
    ok = next(i for i, row in enumerate(data["benchmarks"]) if row["outcome"] == "ok")
    data["benchmarks"][ok]["phase_seconds"] = phases
    file = tmp_path / "run.json"
    file.write_text(json.dumps(data))
    numbers = read_file(file).row(ok).numbers
    assert {name: numbers[f"phase_seconds.{name}"] for name in phases} == phases
    del phases["queue"]
    file.write_text(json.dumps(data))
    with pytest.raises(ResultError, match="queue"):
        read_file(file)


def test_failed_row_has_its_message_and_no_numbers(golden_run: Run) -> None:
    (row,) = golden_run.cell("flat-grid", "fwp-ch")
    assert not row.ok and row.outcome == "wrong answer" and row.message and row.numbers == {}


def test_skipped_mesh_and_skipped_solver_are_told(golden_run: Run) -> None:
    skipped_mesh = golden_run.skip("stanford-bunny", "mmp")
    assert skipped_mesh is not None and "cache" in skipped_mesh.why
    assert golden_run.skip("horse", "ch") is not None
    assert golden_run.skip("horse", "mmp") is None


def test_missing_folder_and_missing_file_are_named(tmp_path: Path) -> None:
    assert str(tmp_path / "nowhere") in error_of(tmp_path / "nowhere")
    assert "run.json: no such file; was the run interrupted?" in error_of(tmp_path)


@pytest.mark.parametrize("length", [0, 1, 20000, None])
def test_truncated_file_and_bytes_that_are_no_text_are_no_json(
    golden_folder: Path, tmp_path: Path, length: int | None
) -> None:
    whole = (golden_folder / "run.json").read_bytes()
    (tmp_path / "run.json").write_bytes(b"\xff{}" if length is None else whole[:length])
    assert "run.json: not JSON, perhaps truncated" in error_of(tmp_path)


def test_a_packed_file_is_the_file_and_a_broken_one_is_refused(
    golden_run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    packed, file = gzip.compress(golden_run.file.read_bytes()), tmp_path / "run.json.gz"
    file.write_bytes(packed)
    assert read_file(file).columns.length == golden_run.columns.length
    for data, why in [
        (packed[:-9], "truncated; get a whole copy"),
        (b"{}", "not packed by gzip, or damaged; get a whole copy"),
        (packed[:50] + bytes(9) + packed[59:], "not packed by gzip, or damaged; get a whole copy"),
    ]:
        file.write_bytes(data)
        assert error_of(file) == f"{file}: {why}"
    monkeypatch.setattr("results.text.MOST", 1 << 20)
    file.write_bytes(gzip.compress(bytes(2 << 20)))
    assert error_of(file) == f"{file}: more than 1 MB"


def test_byte_order_mark_of_utf_8_is_no_part_of_the_text_and_utf_16_is_named(
    golden_folder: Path, tmp_path: Path
) -> None:
    file = tmp_path / "run.json"
    file.write_text((golden_folder / "run.json").read_text(), encoding="utf-8-sig")
    assert read_run(tmp_path).rows
    for encoding in ("utf-16-le", "utf-16-be"):
        file.write_text("\ufeff{}", encoding=encoding)
        assert error_of(tmp_path) == f"{file}: the text is UTF-16; save it as UTF-8"


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ('{"name": "geodesic"}', "'context' is a required property"),
        ("[]", "[] is not of type 'object'"),
        (100_000 * "[" + 100_000 * "]", "nested too deep for a result file"),
    ],
    ids=["another object", "a list", "nested 100,000 deep"],
)
def test_another_json_is_no_result_file(tmp_path: Path, text: str, says: str) -> None:
    (tmp_path / "run.json").write_text(text)
    message = error_of(tmp_path)
    assert "run.json: " in message and says in message


def row(number: int, **values: Any) -> Change:
    return lambda data: data["benchmarks"][number].update(values)


def ours(**values: Any) -> Change:
    return lambda data: data["context"]["geodesic_bench"].update(values)


def without(key: str) -> Change:
    return lambda data: data["benchmarks"][0].pop(key)


def one_among_many(share: float) -> Change:
    def change(data: dict[str, Any]) -> None:
        for one in data["benchmarks"]:
            one["stolen_share"] = 0.5
        data["benchmarks"][5]["stolen_share"] = share

    return change


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda data: data["benchmarks"].clear(), ["benchmarks: []"]),
        (row(3, wavefront_sd=float("nan")), ["benchmarks[3].wavefront_sd: nan is not a finite number"]),
        (row(3, wavefront_sd=float("-inf")), ["benchmarks[3].wavefront_sd", "-inf is not a finite number"]),
        (row(3, window_limit=None), ["benchmarks[3].window_limit"]),
        (one_among_many(-0.5), ["benchmarks[5].stolen_share"]),
        (one_among_many(1.5), ["benchmarks[5].stolen_share"]),
        (row(0, cpu_time="fast"), ["benchmarks[0].cpu_time: 'fast' is not of type 'number'"]),
        (row(0, source=1.5), ["benchmarks[0].source"]),
        (row(0, source=-1), ["benchmarks[0].source"]),
        (row(0, mesh=7), ["benchmarks[0].mesh"]),
        (row(0, name=7), ["benchmarks[0].name"]),
        (row(0, error_occurred=True), ["benchmarks[0]"]),
        (row(3, windows=7), ["benchmarks[3]", "'windows'"]),
        (ours(extra=1), ["context.geodesic_bench", "'extra'"]),
        (ours(schema_version=1), ["schema_version: 1 is not one of [2, 3]"]),
        (lambda data: data["context"].pop("geodesic_bench"), ["context: 'geodesic_bench' is a required property"]),
        *((without(key), ["benchmarks[0]", f"'{key}'"]) for key in ("outcome", "cpu_time", "solver", "source")),
        (row(0, outcome="error", error_occurred=True), ["benchmarks[0]", "'error_message'"]),
        (row(0, run_type="aggregate"), ["benchmarks[0].run_type"]),
        (row(2, mesh="teapot"), ["benchmarks[2].mesh: 'teapot' is not among the context's meshes"]),
        (row(2, solver="x"), ["benchmarks[2].solver: 'x' is not among the context's solvers"]),
        (row(2, source=5), ["benchmarks[2].source: 5 is not among the context's sources of horse"]),
        (row(1, processor="other"), ["].processor: horse, source 0, was measured on two processors"]),
    ],
)  # fmt: skip
def test_what_is_not_to_the_schema_is_named(changed: Changed, change: Change, says: list[str]) -> None:
    message = error_of(changed(change))
    assert all(word in message for word in says), message


def test_unknown_key_of_google_benchmark_is_allowed(changed: Changed) -> None:
    read_run(changed(lambda data: data["context"].update(json_schema_version=1)))


def test_newest_run_is_the_last_by_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("results.reader.RUNS", tmp_path)
    with pytest.raises(ResultError, match="no run there yet"):
        newest_run()
    for name in ["20260102T000000Z-b", "20260101T000000Z-z"]:
        (tmp_path / name).mkdir()
        (tmp_path / name / "run.json").touch()
    (tmp_path / "20260103T000000Z-unfinished").mkdir()
    assert newest_run().name == "20260102T000000Z-b"


def test_real_run_is_to_the_schema(real_run: Path) -> None:
    run = read_run(real_run)
    assert {row.mesh for row in run.rows} == set(run.meshes)
    assert {row.solver for row in run.rows} == set(run.solvers)
    assert [row.message for row in run.rows if row.outcome not in ("ok", "unsupported")] == []


def test_every_cell_of_a_real_run_has_a_file_to_the_schema(real_run: Path) -> None:
    cells = [row for file in (real_run / "cells").iterdir() for row in read_file(file).rows]

    def key(row: Any) -> Any:
        return row.mesh, row.solver, row.source, row.repetition

    assert sorted(map(key, cells)) == sorted(map(key, read_run(real_run).rows))


def test_an_interleaved_run_has_its_programs_and_their_rows_apart(changed: Changed) -> None:
    def add_head(data: dict[str, Any]) -> None:
        head = [{**row, "program": "head"} for row in data["benchmarks"]]
        for row in data["benchmarks"]:
            row["program"] = "base"
        data["benchmarks"] += head
        data["context"]["geodesic_bench"]["interleaved"] = True
        data["context"]["geodesic_bench"]["programs"] = PROGRAMS

    run = read_run(changed(add_head))
    cell = Cell("mmp", "horse", 0)
    assert run.interleaved and str(cell) == "mmp/horse/src:0"
    assert len(run.cells()[cell]) == 2 * len(run.cells("head")[cell]) == 4
    assert {row.program for row in run.cells("base")[cell]} == {"base"}


def test_a_file_of_another_revision_is_read_without_the_schema(changed: Changed) -> None:
    folder = changed(lambda data: [row.update(novelty=7) for row in data["benchmarks"]])
    with pytest.raises(ResultError, match="novelty"):
        read_file(folder / "run.json")
    run = read_file(folder / "run.json", of_any_revision=True)
    assert run.row(0).ok and "novelty" not in run.row(0).data
    folder = changed(lambda data: data["context"].pop("geodesic_bench"))
    with pytest.raises(ResultError, match="not a result file of geodesic-bench"):
        read_file(folder / "run.json", of_any_revision=True)


def test_a_run_of_some_meshes_has_their_rows_only(golden_run: Run) -> None:
    some = golden_run.of_meshes(["horse"])
    assert {row.mesh for row in some.rows} == {"horse"} == set(some.meshes)
    with pytest.raises(ResultError, match="no mesh named 'dragon'; there are: "):
        golden_run.of_meshes(["dragon"])


@pytest.mark.skipif(not COMPARE.exists(), reason="libbenchmark-tools is not installed")
def test_google_benchmarks_own_tool_compares_two_of_our_files(golden_run: Run, tmp_path: Path) -> None:
    files = []
    for factor in (1, 2):
        data = json.loads(golden_run.file.read_text())
        data["benchmarks"] = [row for row in data["benchmarks"] if row["outcome"] == "ok"]
        for row in data["benchmarks"]:
            row["real_time"] *= factor
            row["cpu_time"] *= factor
        files.append(tmp_path / f"{factor}.json")
        files[-1].write_text(json.dumps(data))
    ended = subprocess.run(
        ["/usr/bin/python3", COMPARE, "--no-color", "benchmarks", *files], capture_output=True, text=True
    )
    assert ended.returncode == 0, ended.stderr
    name = data["benchmarks"][0]["run_name"]
    line = next(line for line in ended.stdout.splitlines() if line.startswith(name))
    assert line.split()[1:3] == ["+1.0000", "+1.0000"]
