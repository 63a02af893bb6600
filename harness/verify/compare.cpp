#include "harness/verify/compare.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "meshes/messages.h"

namespace geodesic::conformance {
namespace {

std::string sources_of(const Query& query) {
  constexpr std::size_t kShown = 4;
  std::string text = query.sources.size() == 1 ? " from vertex " : " from vertices ";
  for (std::size_t i = 0; i < std::min(query.sources.size(), kShown); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(query.sources[i].vertex);
  }
  return query.sources.size() > kShown ? text + ", ..." : text;
}

std::string direction(double got, double want) {
  if (std::isnan(got)) return "not a number";
  if (std::isinf(got)) return "not reached";
  if (std::isinf(want)) return "reached";
  return got > want ? "too long" : "too short";
}

Failure wrong_distances(const Query& query, std::span<const double> got, const std::string& what) {
  return {.what = what, .query = query, .got = {got.begin(), got.end()}};
}

using Error = std::function<double(double got, double want)>;

Finding compare(const Query& query, std::span<const double> got, std::span<const double> want,
                const Error& error, double allowed) {
  if (got.size() != want.size()) {
    return wrong_distances(
        query, got,
        std::to_string(got.size()) + " distances instead of " + std::to_string(want.size()));
  }
  std::size_t wrong = 0, first = 0;
  double largest = 0;
  for (std::size_t v = 0; v < got.size(); ++v) {
    const double e = error(got[v], want[v]);
    if (e <= allowed) continue;
    if (wrong++ == 0 || want[v] < want[first]) first = v;
    largest = std::max(largest, e);
  }
  if (wrong == 0) return {};
  Failure failure = wrong_distances(
      query, got,
      std::to_string(wrong) + " of " + std::to_string(got.size()) + " distances are wrong" +
          sources_of(query) + ", first at vertex " + std::to_string(first) + ": " +
          significant(got[first]) + " instead of " + significant(want[first]) +
          " (relative error " + significant(error(got[first], want[first]), 3) +
          (wrong > 1 ? ", largest " + significant(largest, 3) : "") + ")");
  failure.kind = direction(got[first], want[first]);
  failure.vertex = static_cast<Index>(first);
  return failure;
}

}  // namespace

double relative_error(double got, double want, double least) {
  if (got == want) return 0;
  const double unit = std::max(want, least);
  const bool comparable = std::isfinite(got) && std::isfinite(want) && unit > 0;
  return comparable ? (got - want) / unit : kInfinity;
}

Finding agree(const Query& query, std::span<const double> got, std::span<const double> want,
              const Tolerance& tolerance) {
  const auto error = [&](double g, double w) {
    return std::abs(relative_error(g, w, tolerance.least));
  };
  return compare(query, got, want, error, tolerance.relative);
}

Finding bound_from_above(const Query& query, std::span<const double> got,
                         std::span<const double> want, const Tolerance& tolerance) {
  const auto error = [&](double g, double w) {
    const double e = relative_error(g, w, tolerance.least);
    return std::isinf(e) ? e : -e;
  };
  return compare(query, got, want, error, tolerance.relative);
}

Finding identical(const Query& query, std::span<const double> got, std::span<const double> want) {
  const auto error = [](double g, double w) {
    if (std::memcmp(&g, &w, sizeof g) == 0) return 0.0;
    return std::max(std::abs(relative_error(g, w)), std::numeric_limits<double>::min());
  };
  Finding finding = compare(query, got, want, error, 0);
  if (finding) finding->kind = "other bits";
  return finding;
}

Finding satisfies_edges(const Mesh& mesh, const Query& query, std::span<const double> distances,
                        const Tolerance& tolerance) {
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const double a = distances[mesh.origin(h)], b = distances[mesh.head(h)];
    const double length = mesh.half_edge(h).length;
    if (a == b ||
        std::abs(a - b) <= length + tolerance.relative * std::max({a, b, tolerance.least}))
      continue;
    Failure failure = wrong_distances(
        query, distances,
        "edge " + std::to_string(mesh.origin(h)) + " - " + std::to_string(mesh.head(h)) +
            " of length " + significant(length) + " joins the distances " + significant(a) +
            " and " + significant(b) + sources_of(query));
    failure.kind = "farther than along an edge";
    failure.vertex = a > b ? mesh.origin(h) : mesh.head(h);
    return failure;
  }
  return {};
}

}  // namespace geodesic::conformance
