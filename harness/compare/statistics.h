// What two samples of times can tell: medians, whether they differ, geometric means of ratios.
#pragma once

#include <utility>
#include <vector>

namespace geodesic::harness {

/// @param values at least one
double median(std::vector<double> values);

/// Two-sided p-value of the Mann-Whitney U test, exact without ties and not too small with them:
/// the probability of samples at least as different in rank when both come from one distribution.
/// Above 10,000 pairs U is taken as normal. 1 when a sample is empty.
double mann_whitney_p(const std::vector<double>& a, const std::vector<double>& b);

struct Interval {
  double value = 1;
  double low = 1;
  double high = 1;
};

/// The repetitions of one cell on both sides, all > 0.
using Pair = std::pair<std::vector<double>, std::vector<double>>;

/// Geometric mean over cells of median(new) / median(old), with its 95% percentile bootstrap
/// interval: cells are drawn anew, and repetitions within each drawn cell. Seeded: the same samples
/// always give the same interval.
/// @param cells (old, new), at least one
Interval geometric_mean_ratio(const std::vector<Pair>& cells);

/// So many values give a median a 95% interval: 2 / 2^6 = 0.03.
inline constexpr std::size_t kLeastForInterval = 6;

/// The median with its exact 95% interval, whatever the distribution: the innermost two values, as
/// far from either end, between which the median lies with that probability (the sign test turned
/// round). Fewer than kLeastForInterval values have no such two: the interval is then their range.
/// @param values at least one
Interval median_interval(std::vector<double> values);

/// Geometric mean over samples of their medians. Its 95% interval is of the values alone: they are
/// drawn anew within each sample (percentile bootstrap, seeded), the samples stay. Of one sample:
/// its median_interval.
/// @param samples at least one, none empty, all values > 0
Interval geometric_mean_of_medians(const std::vector<std::vector<double>>& samples);

}  // namespace geodesic::harness
