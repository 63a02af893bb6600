#include "harness/verify/distance_check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "meshes/messages.h"

namespace geodesic::harness {
namespace {

std::string name_of(const SurfacePoint& point) {
  if (point.is_vertex()) return "vertex " + std::to_string(point.vertex);
  return "a point in face " + std::to_string(point.face);
}

std::string sources_of(const Query& query) {
  constexpr std::size_t kShown = 4;
  std::string text = " from ";
  for (std::size_t i = 0; i < std::min(query.sources.size(), kShown); ++i) {
    text += (i > 0 ? ", " : "") + name_of(query.sources[i].at);
  }
  return query.sources.size() > kShown ? text + ", ..." : text;
}

std::string direction(double got, double expected) {
  if (std::isnan(got)) return "not a number";
  if (std::isinf(got)) return "not reached";
  if (std::isinf(expected)) return "reached";
  return got > expected ? "too long" : "too short";
}

// Relative error by which a distance breaks the relation; 0 or less when the relation holds.
double excess(double got, double expected, Relation relation, double least) {
  const double error = relative_error(got, expected, least);
  if (std::isnan(error)) return kInfinity;
  switch (relation) {
    case Relation::equal:
      return std::abs(error);
    case Relation::same_bits:
      if (std::bit_cast<std::uint64_t>(got) == std::bit_cast<std::uint64_t>(expected)) return 0;
      return std::max(std::abs(error), std::numeric_limits<double>::min());
    case Relation::upper_bound:
      return std::isinf(error) ? kInfinity : -error;
    case Relation::at_least:
      return -error;
    case Relation::at_most:
      return error;
    case Relation::same_reach:
      return std::isinf(error) ? kInfinity : 0;
    case Relation::same_infinity:
      return std::isinf(got) != std::isinf(expected) ? kInfinity : 0;
  }
  return kInfinity;
}

Violation violation(const Query& query, std::span<const double> got, const std::string& what) {
  return {.what = what, .query = query, .got = {got.begin(), got.end()}};
}

template <class PositionOf>
std::vector<double> lines_to(Index vertices, const Query& query, const PositionOf& position) {
  std::vector<double> lines(vertices, kInfinity);
  for (const Source& source : query.sources) {
    const Vec3& a = position(source.at.vertex);
    for (Index v = 0; v < vertices; ++v) {
      const Vec3& b = position(v);
      const double line = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
      lines[v] = std::min(lines[v], source.distance + line);
    }
  }
  return lines;
}

}  // namespace

Finding in(const std::string& circumstances, Finding finding) {
  if (!finding) return finding;
  finding->what = circumstances + ": " + finding->what;
  if (!finding->kind.empty()) finding->kind = circumstances + ", " + finding->kind;
  return finding;
}

double relative_error(double got, double expected, double least) {
  if (got == expected) return 0;
  if (std::isinf(got) || std::isinf(expected)) return got - expected;
  return (got - expected) / std::max(expected, least);
}

Finding check_distances(const Query& query, std::span<const double> got,
                        std::span<const double> expected, Relation relation,
                        const Tolerance& tolerance) {
  const std::string counts = std::to_string(got.size()) + " distances";
  if (got.size() != expected.size()) {
    return violation(query, got, counts + " instead of " + std::to_string(expected.size()));
  }
  const double allowed = relation == Relation::same_bits ? 0 : tolerance.relative;
  const auto error = [&](std::size_t v) {
    return excess(got[v], expected[v], relation, tolerance.least);
  };
  std::size_t wrong = 0, first = 0, infinite = 0;  // or undefined
  double largest = 0;
  for (std::size_t v = 0; v < got.size(); ++v) {
    const double e = error(v);
    if (e <= allowed) continue;
    if (wrong++ == 0 || expected[v] < expected[first]) first = v;
    if (std::isfinite(e)) {
      largest = std::max(largest, e);
    } else {
      ++infinite;
    }
  }
  if (wrong == 0) return {};
  std::vector<std::string> sizes;
  if (std::isfinite(error(first))) {
    sizes.push_back("relative error " + significant(error(first), 3));
  }
  if (wrong > 1 && infinite < wrong) sizes.push_back("largest " + significant(largest, 3));
  if (infinite > 0) sizes.push_back("infinite or undefined: " + std::to_string(infinite));
  Violation found =
      violation(query, got,
                std::to_string(wrong) + " of " + counts +
                    (wrong == 1 ? " is wrong" : " are wrong") + sources_of(query) +
                    ", first at vertex " + std::to_string(first) + ": " + significant(got[first]) +
                    " instead of " + significant(expected[first]) + " (" + join(sizes, ", ") + ")");
  found.kind =
      relation == Relation::same_bits ? "other bits" : direction(got[first], expected[first]);
  found.vertex = static_cast<Index>(first);
  return found;
}

Promise Promise::of(const Description& solver) {
  const bool bounded = solver.exactness == Exactness::bounded;
  return {solver.exactness, bounded ? solver.error_bound(solver) : 0};
}

Finding check_promise(const Promise& promise, const Query& query, std::span<const double> got,
                      std::span<const double> expected, Tolerance tolerance) {
  tolerance.relative += promise.bound;
  Relation relation = Relation::equal;
  if (promise.exactness == Exactness::upper_bound) relation = Relation::upper_bound;
  if (promise.exactness == Exactness::unbounded) {
    relation = query.sources.size() > 1 ? Relation::same_infinity : Relation::same_reach;
  }
  if (promise.exactness == Exactness::exact || query.limit == kInfinity) {
    return check_distances(query, got, expected, relation, tolerance);
  }
  // If only one of the two distances lies beyond the limit, it counts as the limit.
  std::vector<double> theirs(got.begin(), got.end()), right(expected.begin(), expected.end());
  for (std::size_t v = 0; v < std::min(theirs.size(), right.size()); ++v) {
    if (std::isinf(theirs[v]) == std::isinf(right[v])) continue;
    (std::isinf(theirs[v]) ? theirs : right)[v] = query.limit;
  }
  return check_distances(query, theirs, right, relation, tolerance);
}

Finding check_edges(const Mesh& mesh, const Query& query, std::span<const double> distances,
                    const Tolerance& tolerance) {
  double worst = tolerance.relative;
  Index at = kNone;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const double a = distances[mesh.numbers().external_vertex(mesh.origin(h))];
    const double b = distances[mesh.numbers().external_vertex(mesh.head(h))];
    if (a == b) continue;  // both may be infinite
    double excess =
        (std::abs(a - b) - mesh.half_edge(h).length) / std::max({a, b, tolerance.least});
    if (std::isnan(excess)) excess = kInfinity;  // one is infinite or not a number
    if (excess <= worst) continue;
    worst = excess;
    at = h;
  }
  if (at == kNone) return {};
  Index far = mesh.numbers().external_vertex(mesh.origin(at)),
        near = mesh.numbers().external_vertex(mesh.head(at));
  if (distances[far] < distances[near]) std::swap(far, near);
  Violation found =
      violation(query, distances,
                "vertex " + std::to_string(far) + " has distance " + significant(distances[far]) +
                    sources_of(query) + ", but its neighbour " + std::to_string(near) + " has " +
                    significant(distances[near]) + " and their edge has length " +
                    significant(mesh.half_edge(at).length));
  found.kind = "farther than along an edge";
  found.vertex = far;
  return found;
}

std::vector<double> straight_lines(const Mesh& mesh, const Query& query) {
  return lines_to(mesh.vertex_count(), query, [&](Index v) -> const Vec3& {
    return mesh.position(mesh.numbers().internal_vertex(v));
  });
}

std::vector<double> straight_lines(const TriangleSoup& soup, const Query& query) {
  return lines_to(static_cast<Index>(soup.positions.size()), query,
                  [&](Index v) -> const Vec3& { return soup.positions[v]; });
}

RelativeErrors relative_errors(std::span<const double> got, std::span<const double> expected) {
  RelativeErrors errors;
  std::vector<double> sizes;
  for (std::size_t v = 0; v < got.size(); ++v) {
    const double size = std::abs(relative_error(got[v], expected[v]));
    if (std::isnan(got[v]) || std::isinf(got[v]) != std::isinf(expected[v])) {
      ++errors.unreachable_mismatches;
    } else if (std::isfinite(size) && std::isfinite(expected[v])) {
      sizes.push_back(size);
    }
  }
  if (sizes.empty()) return errors;
  errors.max = *std::ranges::max_element(sizes);
  if (errors.max == 0) return errors;
  const auto count = static_cast<double>(sizes.size());
  double sum = 0, squares = 0;  // scaled: some codes write the largest double for infinity
  for (const double size : sizes) {
    sum += size / errors.max;
    squares += size / errors.max * (size / errors.max);
  }
  errors.mean = errors.max * (sum / count);
  errors.rms = errors.max * std::sqrt(squares / count);
  const auto p99 = sizes.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.99 * count)) - 1;
  std::ranges::nth_element(sizes, p99);
  errors.p99 = *p99;
  return errors;
}

Verdict verify_distances(const Mesh& mesh, const Query& query, const Promise& promise,
                         std::span<const double> distances, const NamedDistances& reference,
                         const std::optional<NamedDistances>& edge_graph) {
  const Exactness exactness = promise.exactness;
  const Tolerance tolerance{.relative = kExactTolerance + promise.bound};
  Verdict verdict{.errors = relative_errors(distances, reference.values)};
  Finding finding = in("compared with " + reference.by,
                       check_promise(promise, query, distances, reference.values));
  if (!finding && exactness != Exactness::unbounded) {
    finding = in("less than the straight line",
                 check_distances(query, distances, straight_lines(mesh, query), Relation::at_least,
                                 tolerance));
  }
  const bool at_most_edges = exactness == Exactness::exact || exactness == Exactness::bounded;
  if (!finding && at_most_edges && edge_graph) {
    finding =
        in("more than along edges (" + edge_graph->by + ")",
           check_distances(query, distances, edge_graph->values, Relation::at_most, tolerance));
  }
  if (!finding && exactness == Exactness::exact) finding = check_edges(mesh, query, distances);
  if (finding) verdict.error = finding->what;
  return verdict;
}

}  // namespace geodesic::harness
