// What two samples of times can tell: medians, whether they differ, geometric means of ratios.
#pragma once

#include <utility>
#include <vector>

namespace geodesic::harness {

/// @param values at least one
double median(std::vector<double> values);

/// Two-sided p-value of the Mann-Whitney U test, exact without ties and not too small with them:
/// the probability of samples at least as different in rank when both come from one distribution.
/// 1 when a sample is empty.
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

}  // namespace geodesic::harness
