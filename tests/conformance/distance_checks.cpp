#include "tests/conformance/distance_checks.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iomanip>

namespace geodesic::conformance {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

// Relative to what is wanted; a distance that should be 0 or infinite must be exactly that.
double relative_excess(double got, double want) {
  if (got == want) return 0;
  const bool comparable = std::isfinite(got) && std::isfinite(want) && want > 0;
  return comparable ? (got - want) / want : kInfinity;
}

AssertionResult compare(const std::vector<double>& got, const std::vector<double>& want,
                        const std::function<double(double, double)>& error, double allowed) {
  if (got.size() != want.size()) {
    return AssertionFailure() << got.size() << " distances instead of " << want.size();
  }
  std::size_t wrong = 0, worst = 0;
  double worst_error = allowed;
  for (std::size_t v = 0; v < got.size(); ++v) {
    const double e = error(got[v], want[v]);
    if (e <= allowed) continue;
    ++wrong;
    if (e > worst_error) {
      worst_error = e;
      worst = v;
    }
  }
  if (wrong == 0) return AssertionSuccess();
  return AssertionFailure() << wrong << " of " << got.size() << " distances are wrong, worst at "
                            << "vertex " << worst << ": " << std::setprecision(17) << got[worst]
                            << " instead of " << want[worst] << " (relative error "
                            << std::setprecision(3) << worst_error << ")";
}

}  // namespace

AssertionResult agree(const std::vector<double>& got, const std::vector<double>& want) {
  const auto error = [](double g, double w) { return std::abs(relative_excess(g, w)); };
  return compare(got, want, error, kExact);
}

AssertionResult bound_from_above(const std::vector<double>& got, const std::vector<double>& want) {
  const auto error = [](double g, double w) { return -relative_excess(g, w); };
  return compare(got, want, error, kExact);
}

AssertionResult identical(const std::vector<double>& got, const std::vector<double>& want) {
  const auto error = [](double g, double w) {
    if (std::memcmp(&g, &w, sizeof g) == 0) return 0.0;
    return std::max(std::abs(relative_excess(g, w)), std::numeric_limits<double>::min());
  };
  return compare(got, want, error, 0);
}

AssertionResult satisfies_edges(const Mesh& mesh, const std::vector<double>& distances) {
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const double a = distances[mesh.origin(h)], b = distances[mesh.head(h)];
    const double length = mesh.half_edge(h).length;
    if (a == b || std::abs(a - b) <= length + kExact * std::max(a, b)) continue;
    return AssertionFailure() << std::setprecision(17) << "edge " << mesh.origin(h) << " - "
                              << mesh.head(h) << " of length " << length << " joins the distances "
                              << a << " and " << b;
  }
  return AssertionSuccess();
}

}  // namespace geodesic::conformance
