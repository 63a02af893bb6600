"""Estimates and their intervals, tests, fits, and the decision rule of paired measurements."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from results.statistics import (
    CONFIDENCE, RESAMPLES, SEED, Decision, decide, geometric_mean, geometric_mean_of_medians, geometric_mean_of_ratios,
    least_for_interval, median, median_interval, power_law, rank_test,
)  # fmt: skip


def test_median_counts_every_source_once() -> None:
    assert median([[1.0], [2.0, 2.0, 2.0, 2.0, 2.0], [9.0]]).value == 2.0
    assert median([[1.0, 9.0, 3.0]]).value == 3.0


def test_geometric_mean_of_reciprocals_is_reciprocal() -> None:
    there = geometric_mean([[[2.0, 4.0], [8.0]], [[3.0]]])
    back = geometric_mean([[[0.5, 0.25], [0.125]], [[1 / 3]]])
    assert there.value * back.value == pytest.approx(1, rel=1e-12)
    assert there.low * back.high == pytest.approx(1, rel=1e-12)


def test_geometric_mean_over_meshes_ranges_over_their_means() -> None:
    estimate = geometric_mean([[[2.0, 8.0]], [[9.0]]])
    assert estimate.value == pytest.approx(6)
    assert [estimate.least, estimate.most] == pytest.approx([4, 9])


def test_meshes_are_drawn_independently_so_that_more_of_them_narrow_the_interval() -> None:
    sample = [[1.0, 1.2], [1.1, 1.4], [0.9, 1.0], [1.3, 1.5]]
    one, nine = geometric_mean([sample]), geometric_mean([sample] * 9)
    width_of_one, width_of_nine = (math.log(m.high / m.low) for m in (one, nine))
    assert width_of_nine == pytest.approx(width_of_one / 3, rel=0.1)


def test_interval_of_a_sample_is_always_the_same_holds_the_value_and_lies_within_the_range() -> None:
    sample = [[1.0, 1.1, 1.3], [1.2, 1.25], [0.9, 1.0, 0.95]]
    estimate = median(sample)
    assert estimate == median(sample)
    assert estimate.least <= estimate.low <= estimate.value <= estimate.high <= estimate.most


@pytest.mark.parametrize(
    ("sample", "ends"),
    [([[3.0, 3.0], [3.0]], (3.0, 3.0)), ([[1.0] * 50, [2.0] * 50, [3.0] * 50], (1.0, 3.0))],
)
def test_spread_is_that_between_sources_however_many_their_repetitions(
    sample: list[list[float]], ends: tuple[float, float]
) -> None:
    estimate = median(sample)
    assert (estimate.low, estimate.high) == ends


@pytest.mark.parametrize("sample", [[], [[]], [[1.0], []]])
def test_empty_samples_are_refused(sample: list[list[float]]) -> None:
    with pytest.raises(ValueError, match="at least one source"):
        median(sample)


@pytest.mark.parametrize(
    ("count", "confidence", "low", "high"),
    [(15, 0.99, 3, 13), (9, 0.95, 2, 8), (6, 0.95, 1, 6), (8, 0.99, 1, 8), (5, 0.95, 1, 5)],
)
def test_interval_of_a_median_is_by_order_statistics(
    count: int, confidence: float, low: int, high: int
) -> None:
    estimate = median_interval(range(count, 0, -1), confidence)
    assert (estimate.low, estimate.high) == (low, high)
    assert (estimate.least, estimate.most) == (1, count)


def test_an_interval_needs_so_many_values() -> None:
    assert [least_for_interval(confidence) for confidence in (0.95, 0.99)] == [6, 8]
    with pytest.raises(ValueError, match="at least one value"):
        median_interval([])


@pytest.mark.parametrize(
    ("ratios", "margin", "decision"),
    [
        ([1.15] * 15, 1.1, Decision.SLOWER),
        ([0.85] * 15, 1.1, Decision.FASTER),
        ([1.02] * 15, 1.1, Decision.SAME),
        ([0.95] * 15, 1.1, Decision.SAME),
        ([1.02] * 12 + [1.2] * 3, 1.1, Decision.UNDECIDED),  # the 3rd largest is above the margin
        ([1.02] * 13 + [1.2] * 2, 1.1, Decision.SAME),
        ([1.2] * 12 + [1.02] * 3, 1.1, Decision.UNDECIDED),
        ([1.2] * 13 + [1.02] * 2, 1.1, Decision.SLOWER),
        ([1.5] * 7, 1.1, Decision.UNDECIDED),  # too few pairs
        ([1.01] * 15, 1, Decision.SLOWER),
        ([0.99] * 15, 1, Decision.FASTER),
        ([1.0] * 15, 1, Decision.UNDECIDED),
    ],
)
def test_the_decision_rule(ratios: list[float], margin: float, decision: Decision) -> None:
    judgement = decide(ratios, margin)
    assert judgement.decision == decision
    if decision == Decision.SAME:
        assert judgement.ratio.value < margin


def test_equals_are_called_slower_as_rarely_as_promised() -> None:
    random = np.random.default_rng(1)
    ratios = np.exp(random.normal(0, 0.02, (4000, 15)))
    slower = sum(decide(list(row), 1).decision == Decision.SLOWER for row in ratios)
    assert slower / len(ratios) <= 0.0075


def test_rank_test_is_exact_for_small_samples_and_1_for_none() -> None:
    assert rank_test([1, 2, 3, 4, 5], [6, 7, 8, 9, 10]) == pytest.approx(2 / 252)
    assert rank_test([], [1.0]) == 1
    assert rank_test([1.0, 2.0, 3.0], [1.0, 2.0, 3.0]) > 0.9


def test_power_law_is_found() -> None:
    law = power_law([10, 100, 1000], [3 * n**1.5 for n in (10, 100, 1000)])
    assert (law.factor, law.exponent) == pytest.approx((3, 1.5))
    assert law.low <= law.exponent <= law.high
    assert law.at(400) == pytest.approx(3 * 400**1.5)


def test_ratios_of_two_runs_have_a_mean_over_cells() -> None:
    cells = [([1.0, 1.1, 1.2], [2.0, 2.2, 2.4]), ([5.0], [2.5])]
    estimate = geometric_mean_of_ratios(cells)
    assert estimate.value == pytest.approx(1)
    assert (estimate.least, estimate.most) == pytest.approx((0.5, 2))
    assert estimate.low < 1 < estimate.high and not estimate.excludes_one
    of_a_choice = geometric_mean_of_ratios(cells, redraw_cells=False)
    assert of_a_choice.value == estimate.value and estimate.low < of_a_choice.low < 1 < of_a_choice.high < estimate.high
    assert of_a_choice.low == pytest.approx((2 / 1.2 * 0.5) ** 0.5)


@pytest.mark.parametrize(
    "sample", [[[3.0, 1.0], [2.0, 7.0]], [[1.0, 4.0, 2.0], [9.0], [5.0, 6.0]], [[2.0, 2.0], [2.0]]]
)
def test_intervals_are_quantiles_of_a_bootstrap_of_sources_and_their_repetitions(sample: list[list[float]]) -> None:
    width, counts = max(map(len, sample)), np.array([len(of) for of in sample])
    values = np.array([[*of, *[np.nan] * (width - len(of))] for of in sample])

    def drawn(random: np.random.Generator) -> Any:
        chosen = random.integers(len(sample), size=(RESAMPLES, len(sample)))
        picks = (random.random((*chosen.shape, width)) * counts[chosen][..., None]).astype(int)
        there = np.arange(width) < counts[chosen][..., None]
        return np.where(there, values[chosen[..., None], picks], np.nan)

    def ends(draws: Any) -> list[float]:
        tail = (1 - CONFIDENCE) / 2
        return [float(end) for end in np.quantile(draws, [tail, 1 - tail])]

    found = median(sample)
    assert [found.low, found.high] == ends(np.median(np.nanmedian(drawn(np.random.default_rng(SEED)), axis=2), axis=1))
    for meshes in (1, 2):
        random = np.random.default_rng(SEED)
        means = [np.nanmean(np.log(drawn(random)), axis=2).mean(axis=1) for _ in range(meshes)]
        found = geometric_mean([sample] * meshes)
        assert [found.low, found.high] == pytest.approx(ends(np.exp(np.mean(means, axis=0))), rel=1e-14)


def test_mean_of_medians_resamples_the_values_and_not_the_meshes() -> None:
    estimate = geometric_mean_of_medians([[1.0] * 9, [4.0] * 9])
    assert (estimate.low, estimate.value, estimate.high) == pytest.approx((2, 2, 2))
    assert (estimate.least, estimate.most) == pytest.approx((1, 4))
    assert geometric_mean_of_medians([[1, 2, 3]]) == median_interval([1, 2, 3])
