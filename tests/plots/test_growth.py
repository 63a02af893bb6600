"""Growth: exponents of a known law, and the refusal of meshes that are no series."""

from __future__ import annotations

import pytest
from synthetic import mesh, row, run_of, solver

from plots import growth
from results.reader import ResultError, Run

SIZES = {"m10": 10_000, "m100": 100_000, "m1000": 1_000_000}


def series_of(sizes: dict[str, int], exponent: float) -> Run:
    """Returns a run in which the time (ns) and the number of windows are n**exponent: 1 ns per window.

    @param sizes number of vertices, by mesh"""
    rows = [
        row("fast", name, cpu_time=1e-6 * n**exponent, window_propagations=round(n**exponent))
        for name, n in sizes.items()
    ]
    return run_of([solver("fast")], [mesh(*each) for each in sizes.items()], rows)


def test_the_exponent_of_a_power_law_is_found() -> None:
    fits = growth.exponents(series_of(SIZES, 1.25))
    time, windows = fits.rows[0][-2:]
    assert time.value == pytest.approx(1.25)
    assert windows.value == pytest.approx(1.25)
    assert time.low == pytest.approx(1.25, abs=1e-6)


def test_times_are_drawn_and_listed_with_their_intervals() -> None:
    rows = [
        row("fast", name, cpu_time=n * (1 + repetition), window_propagations=n, repetition_index=repetition)
        for name, n in SIZES.items()
        for repetition in range(3)
    ]
    run = run_of([solver("fast")], [mesh(*each) for each in SIZES.items()], rows)
    field = growth.table(run).rows[0][3]
    assert field.low is not None and field.high is not None and field.low < field.high and "[" in field.text
    (bars,) = growth.figure(run).figure.axes[0].collections
    assert [segment[:, 1].tolist() for segment in bars.get_segments()][0] == pytest.approx([10, 30])


def test_time_per_window_is_shown_in_nanoseconds_and_by_the_smallest_mesh() -> None:
    table = growth.table(series_of(dict(reversed(SIZES.items())), 1.5))
    assert [row[2].value for row in table.rows] == [10_000, 100_000, 1_000_000]
    assert [row[-2].text for row in table.rows] == ["1.0"] * 3
    assert [row[-1].value for row in table.rows] == pytest.approx([1, 1, 1])


@pytest.mark.parametrize("sizes", [[10, 1000], [100, 120, 399]])
def test_too_few_sizes_or_too_near_are_refused_with_what_to_do(sizes: list[int]) -> None:
    with pytest.raises(ResultError, match="no solver has 3 meshes.*run --corpus growth"):
        growth.table(series_of({f"m{n}": n for n in sizes}, 1.5))


def test_meshes_of_different_surfaces_are_no_series() -> None:
    sizes = dict(zip(["horse", "bunny", "cow"], SIZES.values(), strict=True))
    with pytest.raises(ResultError, match="meshes of one surface"):
        growth.table(series_of(sizes, 1.5))


def test_each_surface_has_a_series_of_its_own() -> None:
    small = {"h-1k": 1_000, "h-2k": 2_000, "h-4k": 4_000}
    large = {"d-10k": 10_000, "d-100k": 100_000, "d-1m": 1_000_000}
    two = series_of(small | large, 1.5)
    assert [row[1].text for row in growth.exponents(two).rows] == ["h", "d"]
    assert [row[-1].value for row in growth.table(two).rows] == pytest.approx([1] * 6, rel=1e-5)
    assert len(growth.figure(two).figure.axes) == 2


@pytest.mark.parametrize(
    ("name", "surface"), [("growth-1m", "growth-"), ("my_scan_lod2", "my_scan_lod"), ("3d", "3d")]
)
def test_a_surface_is_the_name_up_to_its_first_number(name: str, surface: str) -> None:
    assert growth.surface(mesh(name)) == surface
