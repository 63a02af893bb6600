#include "harness/verify/verify.h"

#include <algorithm>
#include <cmath>

#include "meshes/messages.h"

namespace geodesic::harness {
namespace {

// The vertex that breaks a rule by most.
struct Worst {
  Index vertex = kNone;
  double excess = 0;  // relative

  void consider(Index v, double relative) {
    if (relative > excess) *this = {v, relative};
  }
};

double relative_difference(double d, double reference) {
  if (d == reference) return 0;  // both infinite, both zero
  if (std::isinf(d) || std::isinf(reference)) return kInfinity;
  return std::abs(d - reference) / (reference > 0 ? reference : d);
}

std::string describe(const Worst& worst, double d, const std::string& rule, double other) {
  std::string text = "vertex " + std::to_string(worst.vertex) + " has distance " + significant(d) +
                     ", " + rule + " " + significant(other);
  if (std::isfinite(worst.excess)) text += ", relative error " + significant(worst.excess, 3);
  return text;
}

std::string check_numbers(std::span<const double> d) {
  for (Index v = 0; v < d.size(); ++v) {
    if (!(d[v] >= 0)) return "vertex " + std::to_string(v) + " has distance " + significant(d[v]);
  }
  return {};
}

std::string check_reference(Exactness exactness, std::span<const double> d,
                            const Distances& reference, double& max_relative_error) {
  Worst worst;
  for (Index v = 0; v < d.size(); ++v) {
    const double expected = reference.values[v];
    const double difference = relative_difference(d[v], expected);
    if (std::isfinite(difference)) max_relative_error = std::max(max_relative_error, difference);
    if (exactness == Exactness::upper_bound && d[v] > expected) continue;
    if (difference > kExactTolerance) worst.consider(v, difference);
  }
  if (worst.vertex == kNone) return {};
  return describe(worst, d[worst.vertex],
                  exactness == Exactness::exact ? reference.solver + " has" : "below the exact one",
                  reference.values[worst.vertex]);
}

std::string check_straight_line(const Mesh& mesh, std::span<const Index> sources,
                                std::span<const double> d) {
  Worst worst;
  const auto to_nearest_source = [&](Index v) {
    double nearest = kInfinity;
    for (const Index s : sources) {
      const Vec3& a = mesh.position(mesh.numbers().own_vertex(s));
      const Vec3& b = mesh.position(mesh.numbers().own_vertex(v));
      nearest = std::min(nearest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
    return nearest;
  };
  for (Index v = 0; v < d.size(); ++v) {
    const double line = to_nearest_source(v);
    if (d[v] < line * (1 - kExactTolerance)) worst.consider(v, relative_difference(d[v], line));
  }
  if (worst.vertex == kNone) return {};
  return describe(worst, d[worst.vertex], "less than the straight line",
                  to_nearest_source(worst.vertex));
}

std::string check_edge_graph(std::span<const double> d, const Distances& edge_graph) {
  Worst worst;
  for (Index v = 0; v < d.size(); ++v) {
    const double along_edges = edge_graph.values[v];
    if (d[v] > along_edges * (1 + kExactTolerance)) {
      worst.consider(v, relative_difference(d[v], along_edges));
    }
  }
  if (worst.vertex == kNone) return {};
  return describe(worst, d[worst.vertex], "more than along edges (" + edge_graph.solver + ")",
                  edge_graph.values[worst.vertex]);
}

std::string check_triangle_inequality(const Mesh& mesh, std::span<const double> d) {
  Worst worst;
  Index other = kNone;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Index u = mesh.numbers().given_vertex(mesh.origin(h)),
                v = mesh.numbers().given_vertex(mesh.head(h));
    if (d[u] == d[v]) continue;  // infinite, perhaps
    const Index farther = d[u] > d[v] ? u : v;
    const double excess = (std::abs(d[u] - d[v]) - mesh.half_edge(h).length) / std::max(d[u], d[v]);
    // An infinite distance beside a finite one: inf / inf.
    const double relative = std::isnan(excess) ? kInfinity : excess;
    if (relative > kExactTolerance && relative > worst.excess) {
      worst = {farther, relative};
      other = farther == u ? v : u;
    }
  }
  if (worst.vertex == kNone) return {};
  return describe(
      worst, d[worst.vertex],
      "farther from vertex " + std::to_string(other) + " than their edge is long, which has",
      d[other]);
}

}  // namespace

Verdict verify(const Mesh& mesh, std::span<const Index> sources, Exactness exactness,
               std::span<const double> distances, const Distances& reference,
               const std::optional<Distances>& edge_graph) {
  Verdict verdict;
  verdict.error = check_numbers(distances);
  if (verdict.error.empty()) {
    verdict.error = check_reference(exactness, distances, reference, verdict.max_relative_error);
  }
  if (verdict.error.empty()) verdict.error = check_straight_line(mesh, sources, distances);
  if (verdict.error.empty() && exactness == Exactness::exact && edge_graph) {
    verdict.error = check_edge_graph(distances, *edge_graph);
  }
  if (verdict.error.empty()) verdict.error = check_triangle_inequality(mesh, distances);
  return verdict;
}

}  // namespace geodesic::harness
