"""The tables of the golden run, in every format. They contain all failures.

After an intended change: python3 -m plots summary summary_by_mesh times every_solver table_thesis \\
  strip_depth performance ratios claims solvers --run tests/plots/golden/run \\
  --out tests/plots/golden/tables
"""

from __future__ import annotations

import csv
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from synthetic import Changed

from plots import performance, ratio_tables, ratios, solvers, strip_depth, summary
from plots.catalogue import TABLES
from plots.measures import TIME, median_of, percent, time_unit
from results import published
from results.console import ROOT
from results.reader import ResultError, Run, read_run
from results.table import (
    BLANK, FORMATS, Field, Table, four_digits, mark, to_csv, to_latex, to_markdown, to_tabular, to_text,
    write,
)  # fmt: skip

ROCKER_ARM = "rocker-arm (stand-in for rocker arm)"
NAMES = [
    "summary", "summary_by_mesh", "times", "every_solver", "table_thesis", "strip_depth", "performance",
    "ratios", "claims", "solvers",
]  # fmt: skip


def rows_of(table: Table, name: str) -> list[list[str]]:
    """Returns the texts of the rows whose first column has the value or text `name`."""
    return [[c.text for c in row] for row in table.rows if name in (row[0].value, row[0].text)]


def field_of(table: Table, name: str, measure: str, column: str) -> Field:
    for row in table.rows:
        if row[0].value == name and row[1].text == measure:
            return row[table.header.index(column)]
    raise AssertionError(f"no row {measure} of {name}")


@pytest.mark.parametrize("name", NAMES)
def test_tables_are_the_golden_ones(golden_run: Run, golden_tables: Path, name: str) -> None:
    table = TABLES[name](golden_run)
    for extension, render in FORMATS.items():
        assert render(table) == (golden_tables / f"{name}{extension}").read_text(), extension


def test_every_time_of_a_mesh_is_in_seconds_in_one_table(golden_run: Run) -> None:
    table = summary.times(golden_run)
    assert len(table.header) == 2 + len(golden_run.solvers)
    fields = [field for row in table.rows for field in row[2:] if isinstance(field.value, float)]
    for row, mesh in zip(table.rows, (row[0].value for row in table.rows), strict=True):
        time = median_of(golden_run, str(mesh), "mmp", TIME)
        assert time and row[table.header.index("mmp")].value == time.value
    assert len(fields) == 18  # of 21: two are not supported, one is wrong


@pytest.mark.parametrize("name", ["summary_by_mesh", "times", "every_solver", "performance", "answers"])
def test_a_time_stands_beside_its_interval(golden_run: Run, name: str) -> None:
    """A text with the value of a time without its ends would be read as exact."""
    table = TABLES[name](golden_run)
    for row in table.rows:
        if name == "performance" and not re.match(r"(Time|Wall time|Preparation) \(\w+\)$", row[1].text):
            continue
        columns = {"every_solver": (2, 3), "answers": (4, 5, 6, 7)}.get(name, range(2, len(row)))
        timed = [row[i] for i in columns if row[i].low is not None]
        assert all(re.search(r" \[[\d.,]+, [\d.,]+\]", field.text) for field in timed), [f.text for f in timed]


@pytest.mark.parametrize("name", ["strip_depth", "ratios"])
def test_a_table_can_be_drawn_alone(
    golden_folder: Path, tmp_path: Path, name: str
) -> None:
    out = tmp_path / "a b"
    command = [sys.executable, "-m", "plots", name]
    command += ["--run", str(golden_folder), "--out", str(out)]
    subprocess.run(command, check=True, cwd=ROOT, capture_output=True)
    assert {file.suffix for file in out.glob(f"{name}.*")} == set(FORMATS)


def test_a_run_that_has_nothing_to_do_with_the_thesis_does_not_show_it(golden_run: Run) -> None:
    run = golden_run.of_meshes(["flat-grid"])
    assert "published" not in to_markdown(performance.table(run)).lower()
    with pytest.raises(ResultError, match="no mesh is or stands for a model of the thesis"):
        ratio_tables.claims(run)


def test_out_of_memory_of_the_thesis_is_shown(changed: Changed) -> None:
    table = performance.table(read_run(changed(paper_like)))
    terrain = "jacksboro-terrain (stand-in for cervino terrain)"
    cell = field_of(table, terrain, "Time (s), published for cervino terrain", "mmp")
    assert cell.text == "out of memory"


def paper_like(data: dict[str, Any]) -> None:
    """Orders the meshes differently from the thesis. Two meshes belong to one model, one mesh is huge."""
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
    table = strip_depth.table(read_run(changed(paper_like)))
    assert [(row[0].text, row[1].text) for row in table.rows] == [
        ("horse", "the thesis's horse"),
        ("rocker-arm-482k", "stand-in for rocker arm"),
        ("rocker-arm", "stand-in for rocker arm"),
        ("jacksboro-terrain", "stand-in for cervino terrain"),
        ("flat-grid", ""),
    ]


def test_published_ratios_stand_once_under_all_meshes_of_a_model(changed: Changed) -> None:
    table = ratio_tables.ratios(read_run(changed(paper_like)))
    first = [row[1:3] for row in table.rows if row[0].text == "Time / edge-based"]
    rocker_arm = [(model.text, origin.text) for model, origin in first if "rocker" in model.text]
    assert rocker_arm == [
        ("rocker-arm-482k (stand-in for rocker arm)", "ours"),
        (ROCKER_ARM, "ours"),
        ("rocker arm", "published, context only"),
    ]


def test_huge_counts_are_grouped_by_thousands(changed: Changed) -> None:
    table = performance.table(read_run(changed(paper_like)))
    terrain = "jacksboro-terrain (stand-in for cervino terrain)"
    assert "F: 3,145,728" in [row[0] for row in rows_of(table, terrain)]
    assert field_of(table, terrain, "Window propagations", "edge-based").text == "3,271,799,000"
    assert re.fullmatch(r"\d,\d{3}\.\d+ .*", field_of(table, terrain, "Time (s)", "mmp").text)


def test_solver_that_was_not_run_has_no_column_and_another_gives_the_limit(
    changed: Changed,
) -> None:
    def change(data: dict[str, Any]) -> None:
        ours = data["context"]["geodesic_bench"]
        ours["solvers"] = [s for s in ours["solvers"] if s["name"] not in ("mmp", "edge-based")]
        names = [solver["name"] for solver in ours["solvers"]]
        data["benchmarks"] = [row for row in data["benchmarks"] if row["solver"] in names]

    run = read_run(changed(change))
    table = performance.table(run)
    assert "mmp" not in table.header
    assert field_of(table, "horse", "Window propagations", "Window limit").text == "2,870,000"
    ratios = ratio_tables.ratios(run)
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
    table = performance.table(run)
    assert field_of(table, "horse", "Time (ms)", "edge-based").text == "missing"
    assert ["horse", "the thesis's horse", "48,485", "missing", "missing"] in [
        [cell.text for cell in row[:5]] for row in strip_depth.table(run).rows
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
    compared = {"table_thesis", "summary_by_mesh", "times"}  # they contain numbers only
    assert all(TABLES[name](run).name == name for name in NAMES if name not in compared)
    table = performance.table(run)
    assert field_of(table, "horse", "Time (s)", "mmp").text == "crashed"
    claims = ratio_tables.claims(run)
    assert {row[5].text for row in claims.rows} == {"crashed"}


def test_ratios_are_paired_by_source_and_repetition(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        rows = [row for row in data["benchmarks"] if row["mesh"] == "horse"]
        for row in rows:
            drift = (1 + row["source"]) * (1 + row["repetition_index"])
            row["cpu_time"] = drift * (5 if row["solver"] == "mmp" else 1)

    table = ratio_tables.ratios(read_run(changed(change)))
    row = next(r for r in table.rows if r[1].text == "horse" and r[2].text == "ours")
    assert row[table.header.index("mmp")].text == "5.000 [5.000, 5.000]"


def test_unknown_model_of_the_thesis_is_an_error(changed: Changed) -> None:
    def change(data: dict[str, Any]) -> None:
        data["context"]["geodesic_bench"]["meshes"][0]["thesis_model"] = "cow"

    run = read_run(changed(change))
    with pytest.raises(ResultError, match="'cow' is not a model.*rocker arm"):
        strip_depth.table(run)


def test_the_table_of_solvers_has_their_own_description_and_what_the_thesis_says(
    changed: Changed,
) -> None:
    def change(data: dict[str, Any]) -> None:
        data["context"]["geodesic_bench"]["solvers"][2]["remarks"] = "a | heap"

    table = solvers.table(read_run(changed(change)))
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


SMALL = Table(
    "small", "A small table", ["Name", "Value"], 1,
    [
        [Field("a_b & 50%", "a"), Field("1.5 [1, 2]", 1.5, 1.0, 2.0, note="first")],
        [Field("", "a"), Field("lost", note="second")],
        [Field("c|d", "c"), Field("2", 2.0, note="first")],
        [Field("d", "d"), BLANK],
    ],
    ["A $ remark."],
)  # fmt: skip


def test_notes_share_a_mark_when_equal() -> None:
    text = to_markdown(SMALL)
    assert "lost <sup>b</sup>" in text and "| 2 <sup>a</sup> |" in text
    assert text.count("first") == 1


def test_csv_has_intervals_and_whole_notes() -> None:
    parsed = list(csv.DictReader(to_csv(SMALL).splitlines()))
    assert parsed[0] == {
        "Name": "a", "Value": "1.5", "Value, low": "1", "Value, high": "2", "notes": "first",
    }  # fmt: skip
    assert parsed[1]["Value"] == "lost" and parsed[1]["Value, low"] == ""


def test_latex_is_escaped_and_ruled_between_groups() -> None:
    text = to_latex(SMALL)
    assert r"a\_b \& 50\%" in text
    assert text.count(r"\midrule") == 1 + 2  # the head, two changes of the first column


def test_latex_is_the_content_of_a_float_and_its_first_line_shows_the_float() -> None:
    first, *lines = to_latex(SMALL).splitlines()
    assert first.startswith("% ") and r"\caption{A small table} \label{tab:small} \input{small}" in first
    text = "\n".join(lines)
    assert "longtable" not in text and "\\caption" not in text and "%" not in text.replace(r"\%", "")
    for begin in re.findall(r"\\begin\{(\w+)\}", text):
        assert text.count(rf"\begin{{{begin}}}") == text.count(rf"\end{{{begin}}}") == 1
    assert text.index(r"\end{adjustbox}") < text.index(r"A \$ remark.") < text.index("first")


def test_latex_has_a_file_for_each_page_of_whole_groups(tmp_path: Path) -> None:
    row, names = [BLANK], ["a"] * 40 + ["b"] * 30 + ["c"] * 130
    rows = [[Field(f"{name}{index}", name), *row] for index, name in enumerate(names)]
    files = write(replace(SMALL, rows=rows), tmp_path)
    latex = [file for file in files if file.suffix == ".tex"]
    assert [file.name for file in latex] == ["small.tex", *(f"small_{number}.tex" for number in range(2, 6))]
    texts = [file.read_text() for file in latex]
    parts = [re.findall(r"^([abc]\d+) &", text, re.MULTILINE) for text in texts]
    assert sum(parts, []) == [row[0].text for row in rows]
    assert list(map(len, parts)) == [40, 30, 60, 60, 10]
    assert r"\input{small_2}" in texts[1].splitlines()[0] and "(2 of 5)" in texts[1].splitlines()[0]


def test_marks_go_on_after_z() -> None:
    assert [mark(i) for i in (0, 25, 26, 51, 52)] == ["a", "z", "aa", "az", "ba"]


def test_a_terminal_gets_aligned_columns() -> None:
    assert to_text(SMALL).splitlines() == [
        "A small table", "  Name              Value", "  a_b & 50%  1.5 [1, 2] a",
        "                   lost b", "  c|d                 2 a", "  d", "A $ remark.", "a: first",
        "b: second",
    ]  # fmt: skip


def test_a_table_without_a_title_has_no_heading() -> None:
    table = replace(SMALL, title="")
    assert to_markdown(table).startswith("| Name |") and to_text(table).startswith("  Name")


def test_markdown_and_latex_are_escaped_and_control_characters_shown() -> None:
    assert r"c\|d" in to_markdown(SMALL) and r"A \$ remark." in to_markdown(SMALL)
    assert r"a\_b \& 50\% & 1.5 [1, 2]\textsuperscript{a} \\" in to_tabular(SMALL)
    odd = replace(SMALL, rows=[[Field("\x1b[2J"), Field("1")]])
    assert "\x1b" not in to_text(odd) and r"\x1b[2J" in to_text(odd)


@pytest.mark.parametrize(
    ("value", "four", "three", "ratio"),
    [
        (0.99996, "1.000", "1.00", "1.000"),
        (9.9994, "9.999", "10.0", "9.999"),
        (9.99996, "10.00", "10.0", "10.0"),
        (99.96, "99.96", "100", "100.0"),
        (99.996, "100.0", "100", "100.0"),
        (999.96, "1000", "1,000", "1,000.0"),
        (0, "0.000", "0.00", "0.000"),
    ],
)
def test_rounding_up_to_a_power_of_ten_adds_no_digit(value: float, four: str, three: str, ratio: str) -> None:
    assert (four_digits(value), ratios.number(value), ratios.plain(value)) == (four, three, ratio)


def test_the_least_time_has_three_digits_also_where_it_is_rounded_up() -> None:
    assert time_unit([9.996]).text(9.996) == "10.0 s"
    assert time_unit([9.994]).text(9.994) == "9.99 s"
    assert time_unit([0.09996]).text(0.09996) == "100 ms"


def test_a_percentage_just_below_a_hundred_is_no_power_of_ten() -> None:
    assert [percent(error) for error in (0.994, 0.9951, 1)] == ["99%", "100%", "100%"]
