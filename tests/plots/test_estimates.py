"""Medians, paired geometric means and their intervals."""

from __future__ import annotations

import pytest
from estimates import geometric_mean, median


def test_median_counts_every_source_once() -> None:
    assert median([[1.0], [2.0, 2.0, 2.0, 2.0, 2.0], [9.0]]).value == 2.0
    assert median([[1.0, 5.0, 3.0]]).value == 3.0


def test_geometric_mean_of_reciprocals_is_reciprocal() -> None:
    there = geometric_mean([[[2.0, 4.0], [8.0]], [[3.0]]])
    back = geometric_mean([[[0.5, 0.25], [0.125]], [[1 / 3]]])
    assert there.value * back.value == pytest.approx(1, rel=1e-12)
    assert there.low * back.high == pytest.approx(1, rel=1e-12)


def test_geometric_mean_over_meshes_ranges_over_their_means() -> None:
    estimate = geometric_mean([[[2.0, 8.0]], [[9.0]]])
    assert estimate.value == pytest.approx(6)
    assert [estimate.least, estimate.most] == pytest.approx([4, 9])


def test_same_sample_gives_the_same_interval() -> None:
    sample = [[1.0, 1.1, 1.3], [1.2, 1.25], [0.9, 1.0, 0.95]]
    assert median(sample) == median(sample)


def test_interval_holds_the_value_and_lies_within_the_range() -> None:
    estimate = median([[1.0, 1.1, 1.3], [1.2, 1.25], [0.9, 1.0, 0.95]])
    assert estimate.least <= estimate.low <= estimate.value <= estimate.high <= estimate.most


def test_constant_sample_has_no_spread() -> None:
    estimate = median([[3.0, 3.0], [3.0]])
    assert (estimate.low, estimate.high) == (3.0, 3.0)


def test_spread_between_sources_is_not_hidden_by_many_repetitions() -> None:
    estimate = median([[1.0] * 50, [2.0] * 50, [3.0] * 50])
    assert (estimate.low, estimate.high) == (1.0, 3.0)


@pytest.mark.parametrize("sample", [[], [[]], [[1.0], []]])
def test_empty_samples_are_refused(sample: list[list[float]]) -> None:
    with pytest.raises(ValueError, match="at least one source"):
        median(sample)
