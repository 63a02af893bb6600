#include "solvers/dijkstra/dijkstra.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include "solvers/core/registry.h"

namespace geodesic {
namespace {

/// Width of buckets in mean edge lengths. Narrower ones are more to skip; with wider ones more
/// vertices are popped twice.
constexpr double kBucketWidth = 1;

}  // namespace

Dijkstra::Dijkstra(const Mesh& mesh, const Description& description)
    : Solver(mesh, description),
      front_(mesh.vertex_count(), kBucketWidth * mesh.mean_edge_length()) {}

void Dijkstra::run(const Start& start, std::span<double> distances) {
  const auto improve = [&](Index v, double d) {
    if (d < distances[v]) {
      distances[v] = d;
      front_.push_or_decrease(v, d);
    }
  };
  for (const StartVertex& each : start.vertices) improve(each.vertex, each.distance);
  StopRule stop_rule(mesh(), start.query, distances);
  while (!front_.empty() && !stop_rule.is_over(front_.least_key())) {
    const Index v = front_.pop();
    const double d = distances[v];
    mesh().prefetch_faces_around(front_.upcoming());
    mesh().for_each_edge_at(v, [&](Index u, Index edge, Index /*facing*/) {
      improve(u, d + mesh().half_edge(edge).length);
    });
  }
  front_.clear();
}

std::vector<InternalPoint> Dijkstra::trace_path(const InternalQuery& query,
                                                std::span<const double> distances, Index vertex) {
  const auto begins_at = [&](Index v) {
    return std::ranges::any_of(query.sources, [&](const InternalSource& source) {
      return source.at.vertex == v && source.distance == distances[v];
    });
  };
  // Edges without length form circles. Therefore all vertices as far as the last one are searched;
  // `after` maps each vertex to the next one towards the end.
  std::vector<Index> waiting = {vertex};
  std::unordered_map<Index, Index> after;
  Index v = vertex;
  while (!begins_at(v)) {
    if (waiting.empty()) throw std::invalid_argument("dijkstra: not the distances of this query");
    waiting.pop_back();
    Index nearer = kNone;
    mesh().for_each_edge_at(v, [&](Index u, Index edge, Index /*facing*/) {
      if (distances[u] + mesh().half_edge(edge).length != distances[v]) return;
      if (distances[u] < distances[v]) nearer = u;
      if (distances[u] == distances[v] && u != vertex && after.emplace(u, v).second) {
        waiting.push_back(u);
      }
    });
    if (nearer != kNone) {
      after[nearer] = v;
      waiting = {nearer};
    }
    if (!waiting.empty()) v = waiting.back();
  }
  std::vector<InternalPoint> points = {InternalPoint(v)};
  while (v != vertex) points.emplace_back(v = after.at(v));
  return points;
}

const RegisterSolver<Dijkstra> registered{{
    .name = "dijkstra",
    .family = "Dijkstra",
    .paper = "Dijkstra 1959, A note on two problems in connexion with graphs",
    .exactness = Exactness::upper_bound,
    .abilities = {.traces = true},
    .remarks = "paths along edges only",
}};

}  // namespace geodesic
