"""Estimates with their spread: medians, and geometric means of paired ratios.

A sample is a list of groups, one a source vertex, each holding its repetitions. Intervals are 95%
percentile bootstrap intervals that resample sources, and repetitions inside each resampled source,
so that many repetitions of few sources do not look like many sources. Seeded: the same sample
always gives the same interval.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Sample = Sequence[Sequence[float]]
Array = NDArray[np.float64]

RESAMPLES = 2000
CONFIDENCE = 0.95
SEED = 20160101


@dataclass(frozen=True)
class Estimate:
    value: float
    low: float
    high: float
    least: float
    most: float
    """low, high: the 95% interval; least, most: the range of what was measured."""


def median(sample: Sample) -> Estimate:
    """The median over sources of each source's median over repetitions."""
    values, draws = _padded(sample), _resample(_padded(sample))

    def reduce(array: Array) -> Array:
        return np.asarray(np.median(np.nanmedian(array, axis=-1), axis=-1))

    return _estimate(float(reduce(values)), reduce(draws), values)


def geometric_mean(samples: Sequence[Sample]) -> Estimate:
    """The geometric mean over samples (one a mesh) of their geometric means, all values > 0.

    Meshes are a choice and not a random sample: they are not resampled. The range is that of the
    meshes' own means when there are several, else that of the values.
    """
    logs = [np.log(_padded(sample)) for sample in samples]

    def reduce(array: Array) -> Array:
        return np.asarray(np.mean(np.nanmean(array, axis=-1), axis=-1))

    means = np.array([float(reduce(array)) for array in logs])
    draws = np.mean([reduce(_resample(array)) for array in logs], axis=0)
    spread = np.exp(means if len(means) > 1 else logs[0])
    return _estimate(float(np.exp(np.mean(means))), np.exp(draws), spread)


def _estimate(value: float, draws: Array, values: Array) -> Estimate:
    tail = (1 - CONFIDENCE) / 2
    low, high = (float(x) for x in np.quantile(draws, [tail, 1 - tail]))
    return Estimate(value, low, high, float(np.nanmin(values)), float(np.nanmax(values)))


def _padded(sample: Sample) -> Array:
    """Shape (sources, most repetitions of a source), NaN where a source has fewer."""
    if not sample or not all(sample):
        raise ValueError("a sample needs at least one source, and each source a repetition")
    values = np.full((len(sample), max(map(len, sample))), np.nan)
    for row, repetitions in zip(values, sample, strict=True):
        row[: len(repetitions)] = repetitions
    return values


def _resample(values: Array) -> Array:
    """Shape (RESAMPLES, sources, repetitions), padded as `values` is."""
    random = np.random.default_rng(SEED)
    sources, repetitions = values.shape
    chosen = random.integers(sources, size=(RESAMPLES, sources))
    counts = np.sum(~np.isnan(values), axis=1)[chosen][..., None]
    picks = (random.random((RESAMPLES, sources, repetitions)) * counts).astype(np.intp)
    drawn = values[chosen[..., None], picks]
    return np.where(np.arange(repetitions) < counts, drawn, np.nan)
