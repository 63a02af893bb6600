"""The tables of the golden run, in every format, and that nothing which failed is left out.

After an intended change: python3 -m plots summary summary_by_mesh every_solver table_thesis \\
  table_5_1 table_5_2 table_5_2_ratios table_5_2_claims table_5_3 --run tests/plots/golden/run \\
  --out tests/plots/golden/tables
"""

from __future__ import annotations

import csv
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from plots import summary, table_5_1, table_5_2, table_5_2_ratios, table_5_3
from plots.catalogue import TABLES
from results import published
from results.console import ROOT
from results.reader import ResultError, Run, read_run
from results.table import (
    BLANK, FORMATS, Cell, Table, mark, to_csv, to_latex, to_markdown, to_tabular, to_text, write,
)  # fmt: skip

Changed = Callable[[Callable[[dict[str, Any]], object]], Path]

ROCKER_ARM = "rocker-arm (stand-in for rocker arm)"
NAMES = [
    "summary", "summary_by_mesh", "every_solver", "table_thesis", "table_5_1", "table_5_2",
    "table_5_2_ratios", "table_5_2_claims", "table_5_3",
]  # fmt: skip


def tables_of(run: Run) -> list[Table]:
    return [TABLES[name](run) for name in NAMES]


def rows_of(table: Table, name: str) -> list[list[str]]:
    """The texts of the rows whose first column belongs to `name`."""
    return [[c.text for c in row] for row in table.rows if name in (row[0].value, row[0].text)]


def cell_of(table: Table, name: str, measure: str, column: str) -> Cell:
    for row in table.rows:
        if row[0].value == name and row[1].text == measure:
            return row[table.header.index(column)]
    raise AssertionError(f"no row {measure} of {name}")


@pytest.mark.parametrize("name", NAMES)
def test_tables_are_the_golden_ones(golden_run: Run, golden_tables: Path, name: str) -> None:
    table = TABLES[name](golden_run)
    for extension, render in FORMATS.items():
        assert render(table) == (golden_tables / f"{name}{extension}").read_text(), extension


@pytest.mark.parametrize("name", ["table_5_1", "table_5_2_ratios"])
def test_a_table_can_be_drawn_alone(
    golden_folder: Path, tmp_path: Path, name: str
) -> None:
    out = tmp_path / "a b"
    command = [sys.executable, "-m", "plots", name]
    command += ["--run", str(golden_folder), "--out", str(out)]
    subprocess.run(command, check=True, cwd=ROOT, capture_output=True)
    assert {file.suffix for file in out.glob(f"{name}.*")} == set(FORMATS)


def test_command_ends_with_one_line_for_a_broken_run(tmp_path: Path) -> None:
    (tmp_path / "run.json").write_text("{")
    command = [sys.executable, "-m", "plots", "--run", str(tmp_path)]
    ended = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    assert ended.returncode == 1
    assert len(ended.stderr.splitlines()) == 1 and str(tmp_path / "run.json") in ended.stderr


def test_every_mesh_of_the_run_has_a_block_and_no_other_model(golden_run: Run) -> None:
    for table in tables_of(golden_run):
        if table.name in ("every_solver", "table_5_2"):
            names = {row[0].value for row in table.rows}
            assert names == {"horse", ROCKER_ARM, "flat-grid"}


def test_a_run_that_has_nothing_to_do_with_the_thesis_does_not_show_it(golden_run: Run) -> None:
    run = golden_run.of_meshes(["flat-grid"])
    assert "published" not in to_markdown(table_5_2.table(run)).lower()
    with pytest.raises(ResultError, match="no mesh is or stands for a model of the thesis"):
        table_5_2_ratios.claims(run)


def test_published_values_stand_under_ours(golden_run: Run) -> None:
    table = table_5_2.table(golden_run)
    assert cell_of(table, "horse", "Time (ms), published", "mmp").text == "3,696"
    propagations = "Window propagations, published"
    assert cell_of(table, "horse", propagations, "Window limit").text == "2,893,843"
    assert cell_of(table, "horse", "Peak wavefront, published", "fwp-ch").value == 22296


def test_out_of_memory_of_the_thesis_is_shown(changed: Changed) -> None:
    table = table_5_2.table(read_run(changed(paper_like)))
    terrain = "jacksboro-terrain (stand-in for cervino terrain)"
    cell = cell_of(table, terrain, "Time (s), published for cervino terrain", "mmp")
    assert cell.text == "out of memory"


def test_stand_in_is_labelled(golden_run: Run) -> None:
    table = table_5_2.table(golden_run)
    labels = [row[0] for row in rows_of(table, ROCKER_ARM)]
    assert labels[:2] == ["rocker-arm", "stand-in for rocker arm"]
    assert "V: 10,044" in labels


def test_stand_in_is_labelled_in_every_format_of_every_table_with_meshes(golden_run: Run) -> None:
    tables = {table.name: table for table in tables_of(golden_run)}
    for name in ["table_5_1", "table_5_2", "table_5_2_ratios"]:
        for extension, render in FORMATS.items():
            assert "stand-in for rocker arm" in render(tables[name]), name + extension


def test_published_values_beside_a_stand_in_are_context(golden_run: Run) -> None:
    table = table_5_2.table(golden_run)
    published_time = "Time (ms), published for rocker arm"
    assert cell_of(table, ROCKER_ARM, published_time, "mmp").text == "36,481"
    ratios = table_5_2_ratios.ratios(golden_run)
    origins = {(row[1].text, row[2].text) for row in ratios.rows}
    assert ("rocker arm", "published, context only") in origins
    assert ("horse", "published") in origins and ("rocker arm", "published") not in origins


def test_stand_ins_are_no_part_of_the_means_over_the_thesis_s_models(golden_run: Run) -> None:
    claims = table_5_2_ratios.claims(golden_run)
    row = next(row for row in claims.rows if row[2].text == "mmp")
    ours = dict(zip(claims.header, row, strict=True))
    ratios = {
        (row[1].text, row[2].text): row[table_5_2_ratios.ratios(golden_run).header.index("mmp")]
        for row in table_5_2_ratios.ratios(golden_run).rows
        if row[0].text == "Time / edge-based"
    }
    assert ours["Ours, the thesis's models"].value == ratios["horse", "ours"].value
    assert ours["Ours, stand-ins"].value == ratios[ROCKER_ARM, "ours"].value


def paper_like(data: dict[str, Any]) -> None:
    """Meshes of the run in another order than the thesis's, two of them for one model, one huge."""
    ours = data["context"]["geodesic_bench"]
    horse = next(mesh for mesh in ours["meshes"] if mesh["name"] == "horse")
    large: dict[str, Any] = {"vertices": 1575425, "faces": 3145728, "stand_in": True}
    ours["meshes"] = [
        {**horse, **large, "name": "jacksboro-terrain", "thesis_model": "cervino terrain"},
        {**horse, **large, "name": "rocker-arm-482k", "thesis_model": "rocker arm"},
        *ours["meshes"][::-1],
    ]
    rows = [row for row in data["benchmarks"] if row["mesh"] == "horse"]
    for name in ["jacksboro-terrain", "rocker-arm-482k"]:
        ours["sources"][name] = ours["sources"]["horse"]
        for row in rows:
            numbers = {key: row[key] * 1000 for key in ["cpu_time", "window_propagations"]
                       if key in row}  # fmt: skip
            data["benchmarks"].append({**row, "mesh": name, **numbers})


def test_rows_are_in_the_thesis_s_order_whatever_the_run_s(changed: Changed) -> None:
    table = table_5_1.table(read_run(changed(paper_like)))
    assert [(row[0].text, row[1].text) for row in table.rows] == [
        ("horse", "the thesis's horse"),
        ("rocker-arm-482k", "stand-in for rocker arm"),
        ("rocker-arm", "stand-in for rocker arm"),
        ("jacksboro-terrain", "stand-in for cervino terrain"),
        ("flat-grid", ""),
    ]


def test_published_ratios_stand_once_under_all_meshes_of_a_model(changed: Changed) -> None:
    table = table_5_2_ratios.ratios(read_run(changed(paper_like)))
    first = [row[1:3] for row in table.rows if row[0].text == "Time / edge-based"]
    rocker_arm = [(model.text, origin.text) for model, origin in first if "rocker" in model.text]
    assert rocker_arm == [
        ("rocker-arm-482k (stand-in for rocker arm)", "ours"),
        (ROCKER_ARM, "ours"),
        ("rocker arm", "published, context only"),
    ]


def test_huge_counts_are_grouped_by_thousands(changed: Changed) -> None:
    table = table_5_2.table(read_run(changed(paper_like)))
    terrain = "jacksboro-terrain (stand-in for cervino terrain)"
    assert "F: 3,145,728" in [row[0] for row in rows_of(table, terrain)]
    assert cell_of(table, terrain, "Window propagations", "edge-based").text == "3,271,799,000"
    assert re.fullmatch(r"\d,\d{3}\.\d+ .*", cell_of(table, terrain, "Time (s)", "mmp").text)


def test_failed_cell_shows_its_outcome_and_message(golden_run: Run) -> None:
    table = table_5_2.table(golden_run)
    cell = cell_of(table, "flat-grid", "Time (\N{MICRO SIGN}s)", "fwp-ch")
    assert cell.text == "wrong answer" and "vertex 17" in cell.note


def test_cell_with_a_failed_source_says_so_beside_its_number(golden_run: Run) -> None:
    table = table_5_2.table(golden_run)
    cell = cell_of(table, ROCKER_ARM, "Time (ms)", "ich")
    assert isinstance(cell.value, float)
    assert "source 4711" in cell.note and "signal 11" in cell.note


def test_missing_source_is_told(golden_run: Run) -> None:
    table = table_5_2.table(golden_run)
    assert "no rows for source 7" in cell_of(table, ROCKER_ARM, "Time (ms)", "fwp-mmp").note


def test_skipped_and_unsupported_cells_say_why(golden_run: Run) -> None:
    table = table_5_2.table(golden_run)
    skipped = cell_of(table, "horse", "Time (ms)", "ch")
    assert skipped.text == "skipped" and "at most 20000 vertices" in skipped.note
    assert cell_of(table, ROCKER_ARM, "Time (ms)", "ch").text == "unsupported"
    assert any("stanford-bunny was skipped" in remark for remark in table.remarks)


def test_solver_that_was_not_run_has_no_column_and_another_gives_the_limit(
    changed: Changed,
) -> None:
    def change(data: dict[str, Any]) -> None:
        ours = data["context"]["geodesic_bench"]
        ours["solvers"] = [s for s in ours["solvers"] if s["name"] not in ("mmp", "edge-based")]
        names = [solver["name"] for solver in ours["solvers"]]
        data["benchmarks"] = [row for row in data["benchmarks"] if row["solver"] in names]

    run = read_run(changed(change))
    table = table_5_2.table(run)
    assert "mmp" not in table.header
    assert cell_of(table, "horse", "Window propagations", "Window limit").text == "2,870,000"
    ratios = table_5_2_ratios.ratios(run)
    assert "Time / edge-based" not in {row[0].text for row in ratios.rows}
    assert summary.overall(run).header[1] == "Time / fwp-mmp"


def test_cell_without_any_row_is_missing(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        data["benchmarks"] = [
            row
            for row in data["benchmarks"]
            if (row["solver"], row["mesh"]) != ("edge-based", "horse")
        ]

    run = read_run(changed(change))
    table = table_5_2.table(run)
    assert cell_of(table, "horse", "Time (ms)", "edge-based").text == "missing"
    assert ["horse", "the thesis's horse", "48,485", "missing", "missing"] in [
        [cell.text for cell in row[:5]] for row in table_5_1.table(run).rows
    ]


def test_run_in_which_everything_failed_still_has_its_tables(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        kept = ["name", "run_name", "run_type", "repetitions", "threads", "solver", "mesh"]
        data["benchmarks"] = [
            {key: row[key] for key in [*kept, "source"]}
            | {"outcome": "crashed", "error_occurred": True, "error_message": "signal 9"}
            for row in data["benchmarks"]
        ]

    run = read_run(changed(change))
    compared = {"table_thesis", "summary_by_mesh"}  # of numbers alone
    assert all(TABLES[name](run).name == name for name in NAMES if name not in compared)
    table = table_5_2.table(run)
    assert cell_of(table, "horse", "Time (s)", "mmp").text == "crashed"
    claims = table_5_2_ratios.claims(run)
    assert {row[5].text for row in claims.rows} == {"crashed"}


def test_ratios_are_paired_by_source_and_repetition(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        rows = [row for row in data["benchmarks"] if row["mesh"] == "horse"]
        for row in rows:
            drift = (1 + row["source"]) * (1 + row["repetition_index"])
            row["cpu_time"] = drift * (5 if row["solver"] == "mmp" else 1)

    table = table_5_2_ratios.ratios(read_run(changed(change)))
    row = next(r for r in table.rows if r[1].text == "horse" and r[2].text == "ours")
    assert row[table.header.index("mmp")].text == "5.000 [5.000, 5.000]"


def test_ratios_of_the_thesis_are_those_of_its_table(golden_run: Run) -> None:
    table = table_5_2_ratios.ratios(golden_run)
    limit = [r for r in table.rows if r[0].text.startswith("Window propagations")]
    row = next(r for r in limit if r[1].text == "horse" and r[2].text == "published")
    assert [cell.text for cell in row[3:8]] == ["1.522", "1.515", "2.745", "2.752", "1.142"]


def test_every_claim_has_the_thesis_and_ours_beside_it(golden_run: Run) -> None:
    claims = table_5_2_ratios.claims(golden_run)
    assert len(claims.rows) == sum(len(claim.solvers) for claim in published.claims())
    for row in claims.rows:
        assert re.search(r"\d", row[4].text) and re.search(r"\[.*\]", row[5].text), row


def test_mean_tells_how_many_meshes_it_lacks(golden_run: Run) -> None:
    claims = table_5_2_ratios.claims(golden_run)
    row = next(r for r in claims.rows if r[2].text == "fwp-ch")
    assert row[5].note == "" and row[9].note == "fwp-ch: a mean over 2 of 3 meshes."


def test_unknown_model_of_the_thesis_is_an_error(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        data["context"]["geodesic_bench"]["meshes"][0]["thesis_model"] = "cow"

    run = read_run(changed(change))
    with pytest.raises(ResultError, match="'cow' is not a model.*rocker arm"):
        table_5_1.table(run)


def test_table_5_3_has_the_solver_s_own_description_and_what_the_thesis_says(
    changed: Changed,
) -> None:
    def change(data: dict[str, Any]) -> None:
        data["context"]["geodesic_bench"]["solvers"][2]["remarks"] = "a | heap"

    table = table_5_3.table(read_run(changed(change)))
    (row,) = rows_of(table, "edge-based")
    assert row[1:4] == ["edge-based", "exact", "list and priority queue"] and row[-1] == "a | heap"
    assert r"a \| heap" in to_markdown(table)
    assert r"$O(n \log_b n + n \log n)$" in to_latex(table)


def test_published_space_follows_the_rule_that_ours_follows() -> None:
    for model in published.models():
        for solver in published.THESIS_SOLVERS:
            space = published.measure(model, "space_mb", solver)
            count = "window_limit" if "mmp" in solver else "peak_wavefront"
            windows = published.measure(model, count, solver)
            if solver != "fwp-mmp" and isinstance(space, float) and windows is not None:
                where = f"{solver} on {model}"
                assert float(windows) * 80e-6 == pytest.approx(space, abs=0.025), where


def small_table() -> Table:
    rows = [
        [Cell("a_b & 50%", "a"), Cell("1.5 [1, 2]", 1.5, 1.0, 2.0, note="first")],
        [Cell("", "a"), Cell("lost", note="second")],
        [Cell("c", "c"), Cell("2", 2.0, note="first")],
        [Cell("d", "d"), BLANK],
    ]
    return Table("small", "A small table", ["Name", "Value"], 1, rows, ["A remark."])


def test_notes_share_a_mark_when_equal() -> None:
    text = to_markdown(small_table())
    assert "lost <sup>b</sup>" in text and "| 2 <sup>a</sup> |" in text
    assert text.count("first") == 1


def test_csv_has_intervals_and_whole_notes() -> None:
    parsed = list(csv.DictReader(to_csv(small_table()).splitlines()))
    assert parsed[0] == {
        "Name": "a", "Value": "1.5", "Value, low": "1", "Value, high": "2", "notes": "first",
    }  # fmt: skip
    assert parsed[1]["Value"] == "lost" and parsed[1]["Value, low"] == ""


def test_latex_is_escaped_and_ruled_between_groups() -> None:
    text = to_latex(small_table())
    assert r"a\_b \& 50\%" in text
    assert text.count(r"\midrule") == 2 + 2  # two heads, two changes of the first column


def test_marks_go_on_after_z() -> None:
    assert [mark(i) for i in (0, 25, 26, 51, 52)] == ["a", "z", "aa", "az", "ba"]


def test_write_makes_the_folder_and_every_format(tmp_path: Path) -> None:
    files = write(small_table(), tmp_path / "new" / "folder")
    assert [file.suffix for file in files] == list(FORMATS)
    assert all(file.stat().st_size for file in files)


SMALL = Table(
    "small", "Ratios", ["Solver", "Ratio"], 1,
    [[Cell("a_b%"), Cell("1.5", note="one mesh")], [Cell("c|d"), Cell("10.25")]], ["A $ remark."],
)  # fmt: skip


def test_a_terminal_gets_aligned_columns() -> None:
    assert to_text(SMALL).splitlines() == [
        "Ratios", "  Solver  Ratio", "  a_b%    1.5 a", "  c|d     10.25", "A $ remark.",
        "a: one mesh",
    ]  # fmt: skip


def test_a_table_without_a_title_has_no_heading() -> None:
    table = replace(SMALL, title="")
    assert to_markdown(table).startswith("| Solver |") and to_text(table).startswith("  Solver")


def test_markdown_and_latex_are_escaped_and_control_characters_shown() -> None:
    assert r"c\|d" in to_markdown(SMALL) and r"A \$ remark." in to_markdown(SMALL)
    assert r"a\_b\% & 1.5 \\" in to_tabular(SMALL)
    odd = replace(SMALL, rows=[[Cell("\x1b[2J"), Cell("1")]])
    assert "\x1b" not in to_text(odd) and r"\x1b[2J" in to_text(odd)
