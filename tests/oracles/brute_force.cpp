#include "tests/oracles/brute_force.h"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace geodesic::oracles {
namespace {

using Real = long double;

struct Point {
  Real x, y;
};

// Twice the signed area of (0, a, b): positive when b lies to the left of the ray through a.
Real cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

Real distance(const Mesh& mesh, Index a, Index b) {
  Real sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real d = static_cast<Real>(mesh.position(a)[k]) - static_cast<Real>(mesh.position(b)[k]);
    sum += d * d;
  }
  return std::sqrt(sum);
}

// The apex of half-edge h's face when h is laid from p to q with the face on its left.
Point lay_out_apex(const Mesh& mesh, Index h, const Point& p, const Point& q) {
  const Real base = distance(mesh, mesh.origin(h), mesh.head(h));
  const Vec3& a = mesh.position(mesh.origin(h));
  const Vec3& b = mesh.position(mesh.head(h));
  const Vec3& c = mesh.position(mesh.apex(h));
  Real u[3], v[3];
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = static_cast<Real>(b[k]) - static_cast<Real>(a[k]);
    v[k] = static_cast<Real>(c[k]) - static_cast<Real>(a[k]);
  }
  const Real n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                     u[0] * v[1] - u[1] * v[0]};
  const Real along = (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) / base;
  const Real across = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / base;
  const Point e = {(q.x - p.x) / base, (q.y - p.y) / base};
  return {p.x + along * e.x - across * e.y, p.y + along * e.y + across * e.x};
}

// True when the rays through r and l enclose something, up to a half-plane: what a vertex in the
// middle of an edge (of a face without area) sees across it.
bool opens(const Point& r, const Point& l) {
  const Real turn = cross(r, l);
  return turn > 0 || (turn == 0 && r.x * l.x + r.y * l.y < 0);
}

using Graph = std::vector<std::vector<std::pair<Index, Real>>>;  // per vertex: neighbour, length

std::vector<Real> shortest_chains(const Graph& graph, Index source) {
  std::vector<Real> reached(graph.size(), kInfinity);
  using Entry = std::pair<Real, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  reached[source] = 0;
  front.push({0, source});
  while (!front.empty()) {
    const auto [d, v] = front.top();
    front.pop();
    if (d > reached[v]) continue;
    for (const auto& [w, length] : graph[v]) {
      if (d + length < reached[w]) {
        reached[w] = d + length;
        front.push({reached[w], w});
      }
    }
  }
  return reached;
}

Graph edge_graph(const Mesh& mesh) {
  Graph graph(mesh.vertex_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Real length = distance(mesh, mesh.origin(h), mesh.head(h));
    graph[mesh.origin(h)].push_back({mesh.head(h), length});
    graph[mesh.head(h)].push_back({mesh.origin(h), length});
  }
  return graph;
}

// Everything that is seen from one vertex, which lies at (0, 0), along straight lines.
class View {
 public:
  /// @param reach lines longer than this are of no interest
  View(const Mesh& mesh, Real reach, std::vector<std::pair<Index, Real>>& seen)
      : mesh_(mesh), reach_(reach), seen_(seen) {}

  void look_from(Index v) {
    for (const Index h : mesh_.outgoing(v)) {
      const Point right = {distance(mesh_, v, mesh_.head(h)), 0};
      if (right.x == 0) continue;  // a bend at the other end sees all that lies beyond
      const Point left = lay_out_apex(mesh_, h, {0, 0}, right);
      enter(mesh_.twin(Mesh::next(h)), left, right, left, right);
    }
  }

 private:
  // Enters the face of h, seen from below between the rays through `l` and `r`. The edge lies with
  // its origin at `left` and its head at `right` as its own face sees it from outside: h is the
  // twin, so it runs from left to right with its face above.
  void enter(Index h, const Point& left, const Point& right, const Point& l, const Point& r) {
    if (h == kNone || !opens(r, l) || nearest(left, right) > reach_) return;
    if (mesh_.half_edge(h).length == 0) return;
    const Point apex = lay_out_apex(mesh_, h, left, right);
    const bool right_of_l = cross(apex, l) > 0, left_of_r = cross(r, apex) > 0;
    if (right_of_l && left_of_r) {
      seen_.push_back({mesh_.apex(h), std::hypot(apex.x, apex.y)});
    }
    // The apex splits what is seen; a line through it exactly is continued by the bend there.
    const Index left_edge = mesh_.twin(Mesh::previous(h));
    const Index right_edge = mesh_.twin(Mesh::next(h));
    if (right_of_l) enter(left_edge, left, apex, l, left_of_r ? apex : r);
    if (left_of_r) enter(right_edge, apex, right, right_of_l ? apex : l, r);
  }

  static Real nearest(const Point& a, const Point& b) {
    const Point d = {b.x - a.x, b.y - a.y};
    const Real square = d.x * d.x + d.y * d.y;
    Real t = square > 0 ? -(a.x * d.x + a.y * d.y) / square : 0;
    t = std::min(Real{1}, std::max(Real{0}, t));
    return std::hypot(a.x + t * d.x, a.y + t * d.y);
  }

  const Mesh& mesh_;
  Real reach_;
  std::vector<std::pair<Index, Real>>& seen_;
};

}  // namespace

std::vector<double> brute_force_distances(const Mesh& mesh, Index source) {
  const Graph edges = edge_graph(mesh);
  Graph lines = edges;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    Real reach = 0;
    for (const Real d : shortest_chains(edges, v)) {
      if (d < kInfinity) reach = std::max(reach, d);
    }
    View(mesh, reach, lines[v]).look_from(v);
  }
  std::vector<double> distances;
  for (const Real d : shortest_chains(lines, source)) distances.push_back(static_cast<double>(d));
  return distances;
}

}  // namespace geodesic::oracles
