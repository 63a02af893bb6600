#include "harness/compare/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>

namespace geodesic::harness {
namespace {

constexpr int kResamples = 2000;
constexpr double kConfidence = 0.95;
constexpr std::uint64_t kSeed = 20160101;

// How many arrangements of n and m values have U = 0, 1, ..., n m: the coefficients of the product
// of (1 - q^(n + i)) / (1 - q^i) over i = 1 ... m.
std::vector<double> arrangements_by_u(std::size_t n, std::size_t m) {
  std::vector<double> count(n * m + 1);
  count[0] = 1;
  for (std::size_t i = 1; i <= m; ++i) {
    for (std::size_t u = n * m; u >= n + i; --u) count[u] -= count[u - n - i];
    for (std::size_t u = i; u <= n * m; ++u) count[u] += count[u - i];
  }
  return count;
}

// How many pairs of a value of a and one of b have the greater in b; an equal pair is half a one.
double mann_whitney_u(const std::vector<double>& a, std::vector<double> b) {
  std::sort(b.begin(), b.end());
  double u = 0;
  for (const double x : a) {
    const auto [equal, above] = std::equal_range(b.begin(), b.end(), x);
    u += static_cast<double>(b.end() - above) + static_cast<double>(above - equal) / 2;
  }
  return u;
}

// The probability of U, at most `least`, by counting arrangements: exact without ties.
double counted_p(double least, std::size_t n, std::size_t m) {
  const std::vector<double> count = arrangements_by_u(n, m);
  const double all = std::accumulate(count.begin(), count.end(), 0.0);
  const auto last = static_cast<std::ptrdiff_t>(std::ceil(least));  // ties: towards "no difference"
  return 2 * std::accumulate(count.begin(), count.begin() + last + 1, 0.0) / all;
}

// The same by the normal distribution that U tends to; ties would narrow it, and are left out for
// the same reason.
double normal_p(double least, double n, double m) {
  const double deviation = std::sqrt(n * m * (n + m + 1) / 12);
  constexpr double kContinuity = 0.5;
  return std::erfc((n * m / 2 - least - kContinuity) / deviation / std::numbers::sqrt2);
}

class Resampler {
 public:
  std::size_t below(std::size_t size) { return random_() % size; }

  double median_of(const std::vector<double>& values) {
    std::vector<double> drawn(values.size());
    for (double& value : drawn) value = values[below(values.size())];
    return median(std::move(drawn));
  }

 private:
  std::mt19937_64 random_{kSeed};
};

// Geometric mean with its interval, both from sums of logarithms.
// @param draw the sum over a sample drawn anew
template <class Draw>
Interval bootstrap(double sum, std::size_t count, Draw draw) {
  const auto mean_of = [&](double logs) { return std::exp(logs / static_cast<double>(count)); };
  Resampler random;
  std::vector<double> means(kResamples);
  for (double& mean : means) mean = mean_of(draw(random));
  std::sort(means.begin(), means.end());
  constexpr double kTail = (1 - kConfidence) / 2;
  const auto at = [&](double quantile) {
    return means[static_cast<std::size_t>(std::lround(quantile * (kResamples - 1)))];
  };
  return {.value = mean_of(sum), .low = at(kTail), .high = at(1 - kTail)};
}

}  // namespace

double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[middle]
                                : std::midpoint(values[middle - 1], values[middle]);
}

double mann_whitney_p(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty() || b.empty()) return 1;
  const double u = mann_whitney_u(a, b);
  const double least = std::min(u, static_cast<double>(a.size() * b.size()) - u);
  // Counting takes a number for every pair, and more arrangements than a double holds.
  constexpr std::size_t kMostCounted = 10'000;
  const double p =
      std::max(a.size(), b.size()) <= kMostCounted / std::min(a.size(), b.size())
          ? counted_p(least, a.size(), b.size())
          : normal_p(least, static_cast<double>(a.size()), static_cast<double>(b.size()));
  return std::min(1.0, p);
}

Interval geometric_mean_ratio(const std::vector<Pair>& cells) {
  double sum = 0;
  for (const auto& [before, after] : cells)
    sum += std::log(median(after)) - std::log(median(before));
  return bootstrap(sum, cells.size(), [&](Resampler& random) {
    double drawn = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto& [before, after] = cells[random.below(cells.size())];
      drawn += std::log(random.median_of(after)) - std::log(random.median_of(before));
    }
    return drawn;
  });
}

Interval median_interval(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  // Probability that at most `outside` of n tosses of a coin are heads. In logarithms: thousands of
  // tosses have more outcomes than a double can count.
  double log_heads = -static_cast<double>(n) * std::log(2.0), tail = std::exp(log_heads);
  std::size_t outside = 0;
  for (std::size_t k = 1; 2 * k < n; ++k) {
    log_heads += std::log(static_cast<double>(n - k + 1) / static_cast<double>(k));
    tail += std::exp(log_heads);
    if (2 * tail > 1 - kConfidence) break;
    outside = k;
  }
  return {.value = median(values), .low = values[outside], .high = values[n - 1 - outside]};
}

Interval geometric_mean_of_medians(const std::vector<std::vector<double>>& samples) {
  if (samples.size() == 1) return median_interval(samples.front());
  double sum = 0;
  for (const auto& sample : samples) sum += std::log(median(sample));
  return bootstrap(sum, samples.size(), [&](Resampler& random) {
    double drawn = 0;
    for (const auto& sample : samples) drawn += std::log(random.median_of(sample));
    return drawn;
  });
}

}  // namespace geodesic::harness
