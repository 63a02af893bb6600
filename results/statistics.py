"""Statistics: estimates with intervals, tests, fits, and the decision rule.

**Samples.** A sample is a list of groups, one per source vertex, each with its repetitions. Intervals
of samples are 95% percentile bootstrap intervals. They resample sources, and repetitions inside each
resampled source, so that many repetitions of few sources do not look like many sources. They are
seeded: the same sample always gives the same interval.

**Paired measurements and their decision rule.** Two sides, "base" and "head", are timed alternately
in pairs (base head, head base, ...). The rule judges the ratio head/base of each pair, so that a
drift of the machine cancels out. The interval of the median ratio is exact for any distribution: it
reaches from the k-th smallest to the k-th largest ratio, with k from the binomial distribution
(`median_interval`). With a margin m >= 1, `decide` returns one of four decisions:

    slower      the lower end is above m
    faster      the upper end is below 1/m
    same        the upper end is below m: not slower by the margin, and perhaps faster by less
    undecided   otherwise, or too few pairs for an interval

So a median above the margin, or an interval that contains the margin, is never called the same. At
99%, a program that is compared with itself is called slower with a probability of at most 0.5%. With
m = 1 the rule decides which of two solvers is faster.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence, Sized
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Sample = Sequence[Sequence[float]]
Array = NDArray[np.float64]
Places = NDArray[np.int64]

RESAMPLES = 2000
CONFIDENCE = 0.95
DECISION_CONFIDENCE = 0.99
SEED = 20160101


@dataclass(frozen=True)
class Estimate:
    value: float
    low: float
    high: float
    least: float
    most: float
    """low and high are the interval; least and most are the range of the measurements."""

    @property
    def excludes_one(self) -> bool:
        """Whether the interval of a ratio shows a difference."""
        return self.low > 1 or self.high < 1


class Decision(StrEnum):
    """The result of a paired measurement of head against base; see the module's docstring."""

    SLOWER = "slower"
    FASTER = "faster"
    SAME = "same"
    UNDECIDED = "undecided"


@dataclass(frozen=True)
class Judgement:
    decision: Decision
    ratio: Estimate
    """The median of head/base with the judged interval."""


def median(sample: Sample) -> Estimate:
    """Returns the median over sources of each source's median over repetitions.

    @raises ValueError for an empty sample or source"""
    values = _padded(sample)

    def reduce(array: Array) -> Array:
        return _medians(_medians(array))

    return _estimate(float(reduce(values)), reduce(_resample(values)), values)


def geometric_mean(samples: Sequence[Sample]) -> Estimate:
    """Returns the geometric mean over samples (one per mesh) of their geometric means, all values > 0.

    Meshes are not resampled, because they are a choice and not a random sample. The range is that of
    the meshes' means if there are several, else that of the values.

    @raises ValueError for an empty sample or source"""
    logs = [np.log(_padded(sample)) for sample in samples]

    def reduce(array: Array) -> Array:
        inner = np.nanmean if np.isnan(array).any() else np.mean
        return np.asarray(np.mean(inner(array, axis=-1), axis=-1))

    means = np.array([float(reduce(array)) for array in logs])
    if len(logs) == 1:
        draws = reduce(_resample(logs[0]))
    else:
        random = np.random.default_rng(SEED)  # one for all: meshes are drawn independently
        draws = np.mean([reduce(_redraw(one, _chosen(one, random), random)) for one in logs], axis=0)
    spread = np.exp(means if len(means) > 1 else logs[0])
    return _estimate(float(np.exp(np.mean(means))), np.exp(draws), spread)


def geometric_mean_of_ratios(
    cells: Sequence[tuple[Sequence[float], Sequence[float]]], *, redraw_cells: bool = True
) -> Estimate:
    """Returns the geometric mean over cells of median(after) / median(before).

    For two sides that were not interleaved. The interval resamples cells, and the repetitions of each
    side inside each resampled cell. The range is that of the cells' ratios.

    @param cells (before, after): the repetitions of each side, all > 0; at least one cell
    @param redraw_cells False if the cells are a choice, as meshes are: only repetitions are resampled"""
    before = np.log(_padded([each[0] for each in cells]))
    after = np.log(_padded([each[1] for each in cells]))
    random = np.random.default_rng(SEED)
    every = np.tile(np.arange(len(cells)), (RESAMPLES, 1))
    chosen = random.integers(len(cells), size=every.shape) if redraw_cells else every

    def ratio(above: Array, below: Array) -> Array:
        return np.asarray(np.nanmedian(above, axis=-1) - np.nanmedian(below, axis=-1))

    draws = ratio(_redraw(after, chosen, random), _redraw(before, chosen, random)).mean(axis=-1)
    ratios = ratio(after, before)
    return _estimate(float(np.exp(ratios.mean())), np.exp(draws), np.exp(ratios))


def geometric_mean_of_medians(samples: Sequence[Sequence[float]]) -> Estimate:
    """Returns the geometric mean over samples (one per mesh) of their medians, all values > 0.

    For one sample this is its `median_interval`. For several samples, the interval resamples the values
    of each sample, not the samples, and the range is that of the medians."""
    if len(samples) == 1:
        return median_interval(samples[0])
    logs = np.log(_padded(samples))
    random = np.random.default_rng(SEED)
    drawn = _redraw(logs, np.tile(np.arange(len(samples)), (RESAMPLES, 1)), random)
    medians = np.nanmedian(logs, axis=-1)
    draws = np.exp(np.nanmedian(drawn, axis=-1).mean(axis=-1))
    return _estimate(float(np.exp(medians.mean())), draws, np.exp(medians))


def least_for_interval(confidence: float = CONFIDENCE) -> int:
    """Returns the least number of values for an interval of the median: 6 at 95%, 8 at 99%."""
    return math.ceil(round(1 - math.log2(1 - confidence), 9))


def median_interval(values: Sequence[float], confidence: float = CONFIDENCE) -> Estimate:
    """Returns the median with its exact interval for any distribution: the innermost two values, equally
    far from both ends, between which the median lies with that probability (15 values at 99%: the 3rd
    smallest and the 3rd largest). Fewer than `least_for_interval` values have their range.

    @raises ValueError for no values"""
    if not values:
        raise ValueError("a median needs at least one value")
    ordered = sorted(values)
    n = len(ordered)
    tails = itertools.accumulate(math.comb(n, i) for i in range(n // 2))  # out of 2^n, on either side
    k = max(sum(tail / 2 ** (n - 1) <= 1 - confidence for tail in tails) - 1, 0)
    return Estimate(
        float(np.median(ordered)), ordered[k], ordered[-1 - k], ordered[0], ordered[-1]
    )


def decide(
    ratios: Sequence[float], margin: float, confidence: float = DECISION_CONFIDENCE
) -> Judgement:
    """Applies the decision rule of the module's docstring.

    @param ratios head/base of each pair, at least one
    @param margin at least 1"""
    ratio = median_interval(ratios, confidence)
    if len(ratios) < least_for_interval(confidence):
        decision = Decision.UNDECIDED
    elif ratio.low > margin:
        decision = Decision.SLOWER
    elif ratio.high < 1 / margin:
        decision = Decision.FASTER
    else:
        decision = Decision.SAME if ratio.high < margin else Decision.UNDECIDED
    return Judgement(decision, ratio)


def rank_test(a: Sequence[float], b: Sequence[float]) -> float:
    """Returns the two-sided p-value of the Mann-Whitney U test: the probability of samples at least as
    different in rank if both come from one distribution. 1 if a sample is empty."""
    from scipy.stats import mannwhitneyu  # here: SciPy takes longer to start than most commands

    if not a or not b:
        return 1.0
    return float(mannwhitneyu(a, b, alternative="two-sided").pvalue)


@dataclass(frozen=True)
class PowerLaw:
    """y = factor x^exponent, with the 95% interval of the exponent (Student's t)."""

    factor: float
    exponent: float
    low: float
    high: float

    def at(self, x: float) -> float:
        return float(self.factor * x**self.exponent)


def power_law(x: Sequence[float], y: Sequence[float]) -> PowerLaw:
    """Fits log y to log x by least squares.

    @param x at least three values, all > 0 and not all the same
    @param y as many values, all > 0"""
    from scipy import stats

    fit = stats.linregress(np.log(x), np.log(y))
    half = float(stats.t.ppf(0.5 + CONFIDENCE / 2, len(x) - 2)) * float(fit.stderr)
    slope = float(fit.slope)
    return PowerLaw(math.exp(fit.intercept), slope, slope - half, slope + half)


def _estimate(value: float, draws: Array, values: Array) -> Estimate:
    tail = (1 - CONFIDENCE) / 2
    low, high = (_quantile(np.sort(draws), share) for share in (tail, 1 - tail))
    return Estimate(value, low, high, float(np.nanmin(values)), float(np.nanmax(values)))


def _quantile(ordered: Array, share: float) -> float:
    """Returns `np.quantile` to the last bit, in a fifth of the time."""
    place = share * (len(ordered) - 1)
    below, above = (float(x) for x in ordered[[int(place), min(int(place) + 1, len(ordered) - 1)]])
    part = place - int(place)
    return below + (above - below) * part if part < 0.5 else above - (above - below) * (1 - part)


def _medians(values: Array) -> Array:
    """Returns the medians over the last axis, without padding. NumPy's are slow on short axes."""
    if np.isnan(values).any():
        return np.asarray(np.nanmedian(values, axis=-1))
    ordered, count = np.sort(values, axis=-1), values.shape[-1]
    return np.asarray((ordered[..., (count - 1) // 2] + ordered[..., count // 2]) / 2)


def _padded(sample: Sample) -> Array:
    """Returns an array of shape (sources, largest number of repetitions), padded with NaN."""
    if not sample or not all(sample):
        raise ValueError("a sample needs at least one source, and each source a repetition")
    values = np.full((len(sample), max(map(len, sample))), np.nan)
    for row, repetitions in zip(values, sample, strict=True):
        row[: len(repetitions)] = repetitions
    return values


def _resample(values: Array) -> Array:
    """Returns an array of shape (RESAMPLES, sources, repetitions), padded like `values`; only the values
    themselves if all are equal, as counters are."""
    if np.nanmin(values) == np.nanmax(values):
        return values[None]
    return np.append(values, np.nan)[_places(tuple(_counts(values).tolist()), values.shape[1])]


def _redraw(values: Array, chosen: Places, random: np.random.Generator) -> Array:
    """Resamples the repetitions of the chosen sources. SciPy's bootstrap has only one level."""
    return np.append(values, np.nan)[_drawn(_counts(values), values.shape[1], chosen, random)]


@lru_cache(maxsize=32)
def _places(counts: tuple[int, ...], width: int) -> Places:
    """Returns the places of `_drawn` for a new generator: the same for all samples of this shape."""
    random = np.random.default_rng(SEED)
    return _drawn(np.array(counts), width, _chosen(counts, random), random)


def _drawn(counts: Places, width: int, chosen: Places, random: np.random.Generator) -> Places:
    """Returns places in the flattened sample, and -1 for padding.

    @param counts of the repetitions of each source
    @param width of the sample"""
    own = np.asarray(width) if (counts == width).all() else counts[chosen][..., None]
    picks = (random.random((*chosen.shape, width)) * own).astype(np.intp)
    return np.where(np.arange(width) < own, width * chosen[..., None] + picks, -1)


def _chosen(sources: Sized, random: np.random.Generator) -> Places:
    return random.integers(len(sources), size=(RESAMPLES, len(sources)))


def _counts(values: Array) -> Places:
    return np.asarray(np.sum(~np.isnan(values), axis=1))
