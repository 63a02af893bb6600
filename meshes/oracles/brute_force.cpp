#include "meshes/oracles/brute_force.h"

#include <algorithm>
#include <functional>
#include <queue>

namespace geodesic {
namespace {

// Neighbours and lengths, by external number of a vertex.
using Graph = std::vector<std::vector<std::pair<Index, Real>>>;

std::vector<Real> shortest_chains(const Graph& graph, std::span<const Source> sources) {
  std::vector<Real> reached(graph.size(), kInfinity);
  using Entry = std::pair<Real, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  const auto reach = [&](Index v, Real d) {
    if (d >= reached[v]) return;
    reached[v] = d;
    front.push({d, v});
  };
  for (const Source& source : sources) reach(source.at.vertex, source.distance);
  while (!front.empty()) {
    const auto [d, v] = front.top();
    front.pop();
    if (d > reached[v]) continue;
    for (const auto& [w, length] : graph[v]) reach(w, d + length);
  }
  return reached;
}

Graph edge_graph(const Mesh& mesh) {
  Graph graph(mesh.vertex_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Real length = straight_distance(mesh, mesh.origin(h), mesh.head(h));
    const Index a = mesh.numbers().external_vertex(mesh.origin(h));
    const Index b = mesh.numbers().external_vertex(mesh.head(h));
    graph[a].push_back({b, length});
    graph[b].push_back({a, length});
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {  // names of one vertex
    const Index name = mesh.numbers().external_vertex(mesh.numbers().internal_vertex(v));
    if (name == v) continue;
    graph[v].push_back({name, 0});
    graph[name].push_back({v, 0});
  }
  return graph;
}

}  // namespace

BruteForce::BruteForce(const Mesh& mesh) {
  const MeshNumbers& numbers = mesh.numbers();
  const Graph edges = edge_graph(mesh);
  lines_ = edges;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    Real reach = 0;
    for (const Real d : shortest_chains(edges, std::vector<Source>{{.at = v}})) {
      if (d < kInfinity) reach = std::max(reach, d);
    }
    view_from(mesh, numbers.internal_vertex(v), reach, [&](const Sight& sight) {
      lines_[v].push_back({numbers.external_vertex(sight.vertex), sight.length});
    });
  }
}

std::vector<double> BruteForce::distances(std::span<const Source> sources) const {
  std::vector<double> distances;
  for (const Real d : shortest_chains(lines_, sources)) distances.push_back(static_cast<double>(d));
  return distances;
}

}  // namespace geodesic
