"""Growth: exponents of a known law, and a clear refusal of meshes that are no series."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from synthetic import data_of, with_rows

from plots import growth
from results.columns import Columns
from results.reader import Mesh, ResultError, Run, Solver

SOLVER = Solver("fast", "F", "", True, False, "")


def run_of(sizes: list[int], exponent: float) -> Run:
    """A run in which time (ns) and windows are n to the exponent: a nanosecond a window."""
    meshes = {f"m{n}": Mesh(f"m{n}", "", n, 2 * n, 1.0, None, False) for n in sizes}
    rows = [
        {"solver": "fast", "mesh": mesh.name, "source": 0, "outcome": "ok",
         "cpu_time": 1e-6 * mesh.vertices**exponent,
         "window_propagations": round(mesh.vertices**exponent)}
        for mesh in meshes.values()
    ]  # fmt: skip
    return Run(
        Path("run.json"), {}, meshes, {"fast": SOLVER}, {name: [0] for name in meshes}, [],
        Columns.of(rows),
    )  # fmt: skip


def test_the_exponent_of_a_power_law_is_found() -> None:
    fits = growth.exponents(run_of([10_000, 100_000, 1_000_000], 1.25))
    time, windows = fits.rows[0][-2:]
    assert time.value == pytest.approx(1.25)
    assert windows.value == pytest.approx(1.25)
    assert time.low == pytest.approx(1.25, abs=1e-6)


def test_time_per_window_is_shown_in_nanoseconds_and_by_the_smallest_mesh() -> None:
    table = growth.table(run_of([1_000_000, 10_000, 100_000], 1.5))
    assert [row[2].value for row in table.rows] == [10_000, 100_000, 1_000_000]
    assert [row[-2].text for row in table.rows] == ["1.0"] * 3
    assert [row[-1].value for row in table.rows] == pytest.approx([1, 1, 1])


@pytest.mark.parametrize("sizes", [[10, 1000], [100, 120, 399]])
def test_too_few_sizes_or_too_near_are_refused_with_what_to_do(sizes: list[int]) -> None:
    with pytest.raises(ResultError, match="no solver has 3 meshes.*run --corpus growth"):
        growth.table(run_of(sizes, 1.5))


def test_meshes_of_different_surfaces_are_no_series() -> None:
    run = run_of([10_000, 100_000, 1_000_000], 1.5)
    names = dict(zip(run.meshes, ["horse", "bunny", "cow"], strict=True))
    meshes = {names[name]: replace(m, name=names[name]) for name, m in run.meshes.items()}
    rows = [row | {"mesh": names[row["mesh"]]} for row in data_of(run)]
    with pytest.raises(ResultError, match="meshes of one surface"):
        growth.table(with_rows(run, rows, meshes=meshes))


def test_each_surface_has_a_series_of_its_own() -> None:
    run = run_of([1_000, 2_000, 4_000, 10_000, 100_000, 1_000_000], 1.5)
    names = dict(zip(run.meshes, ["h-1k", "h-2k", "h-4k", "d-10k", "d-100k", "d-1m"], strict=True))
    meshes = {names[name]: replace(m, name=names[name]) for name, m in run.meshes.items()}
    rows = [row | {"mesh": names[row["mesh"]]} for row in data_of(run)]
    two = with_rows(run, rows, meshes=meshes)
    assert [row[1].text for row in growth.exponents(two).rows] == ["h", "d"]
    assert [row[-1].value for row in growth.table(two).rows] == pytest.approx([1] * 6, rel=1e-5)
    assert len(growth.figure(two).figure.axes) == 2


@pytest.mark.parametrize(
    ("name", "surface"), [("growth-1m", "growth-"), ("my_scan_lod2", "my_scan_lod"), ("3d", "3d")]
)
def test_a_surface_is_the_name_up_to_its_first_number(name: str, surface: str) -> None:
    assert growth.surface(Mesh(name, "", 3, 1, 1.0, None, False)) == surface
