// `steiner`: shortest paths in a graph of points on the edges, never too short.
//
// Lanthier, Maheshwari, Sack 1997, "Approximating weighted shortest paths on polyhedral surfaces":
// every edge gets `points` equidistant Steiner points. Two nodes (vertices or Steiner points) are
// joined by a straight line if they lie on different edges of one face; neighbours on one edge are
// joined by the part between them. Paths of this graph are paths of the surface: Dijkstra's
// algorithm on it gives upper bounds. Without Steiner points it is `dijkstra`.
#include <stdexcept>

#include "solvers/core/queues/vertex_heap.h"
#include "solvers/core/registry.h"
#include "solvers/core/window.h"

namespace geodesic::steiner {
namespace {

/// Numbers of nodes: first the vertices, then the points of each edge. The smaller half-edge of an
/// edge names it, and its points are numbered from the origin of that half-edge.
class Nodes {
 public:
  /// @param points number of points on every edge
  /// @throws std::invalid_argument if there are more nodes than an Index can number
  Nodes(const Mesh& mesh, Index points)
      : points_(points), vertices_(mesh.vertex_count()), first_(mesh.half_edge_count()) {
    if (points > 0 && mesh.edge_count() > (kNone - vertices_) / points) {
      throw std::invalid_argument("steiner: " + std::to_string(points) + " points on each of " +
                                  std::to_string(mesh.edge_count()) +
                                  " edges are too many to be numbered; ask for fewer");
    }
    half_edges_.reserve(mesh.edge_count());
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      const Index twin = mesh.twin(h);
      if (twin < h) {
        first_[h] = first_[twin];
      } else {
        first_[h] = vertices_ + static_cast<Index>(half_edges_.size()) * points;
        half_edges_.push_back(h);
      }
    }
  }

  Index count() const { return vertices_ + static_cast<Index>(half_edges_.size()) * points_; }
  Index points() const { return points_; }
  bool is_vertex(Index node) const { return node < vertices_; }

  /// The half-edge that names the edge of a Steiner point.
  Index half_edge(Index point) const { return half_edges_[(point - vertices_) / points_]; }
  /// Number of steps of its edge from the origin of that half-edge to a Steiner point.
  Index step(Index point) const { return (point - vertices_) % points_ + 1; }

  /// @param step from 1 to points(), counted from the origin of h
  Index on(const Mesh& mesh, Index h, Index step) const {
    return first_[h] + (mesh.twin(h) < h ? points_ - step : step - 1);
  }
  /// The part of an edge that a number of its steps covers.
  double share(Index steps) const { return steps / static_cast<double>(points_ + 1); }

 private:
  Index points_, vertices_;
  std::vector<Index> first_;       // per half-edge, the number of its edge's first point
  std::vector<Index> half_edges_;  // per edge, the half-edge that names it
};

double distance(Point2 a, Point2 b) {
  const double dx = a.x - b.x, dy = a.y - b.y;
  return std::sqrt(dx * dx + dy * dy);
}

class Steiner final : public Solver {
 public:
  Steiner(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        nodes_(mesh, description.integer("points")),
        front_(nodes_.count()),
        distances_(nodes_.count()) {}

 private:
  void run(const Start& start, std::span<double> distances) override {
    std::ranges::fill(distances_, kInfinity);
    front_.clear();
    for (const StartVertex& each : start.vertices) improve(each.vertex, each.distance);
    while (!front_.empty() && front_.least_key() <= start.query.limit) {
      const Index node = front_.pop();
      if (nodes_.is_vertex(node)) {
        leave_vertex(node);
      } else {
        leave_point(node);
      }
    }
    std::copy_n(distances_.begin(), distances.size(), distances.begin());
  }

  void improve(Index node, double d) {
    if (!(d < distances_[node])) return;
    distances_[node] = d;
    front_.push_or_decrease(node, d);
  }

  void leave_vertex(Index v) {
    const double d = distances_[v], step = nodes_.share(1);
    for (const Index h : mesh().outgoing(v)) {
      // Both edges of the corner, because a boundary edge leaves v in one face only.
      const Index into = Mesh::previous(h);
      const double length = mesh().half_edge(h).length, length_into = mesh().half_edge(into).length;
      improve(mesh().head(h), d + length);
      improve(mesh().origin(into), d + length_into);
      if (nodes_.points() == 0) continue;
      improve(nodes_.on(mesh(), h, 1), d + length * step);
      improve(nodes_.on(mesh(), into, nodes_.points()), d + length_into * step);
      reach_next_edge(h, {0, 0}, d);
    }
  }

  void leave_point(Index point) {
    const Index named = nodes_.half_edge(point), step = nodes_.step(point);
    for (const Index h : {named, mesh().twin(named)}) {
      if (h == kNone) continue;
      const Index from_origin = h == named ? step : nodes_.points() + 1 - step;
      const HalfEdge& e = mesh().half_edge(h);
      const double d = distances_[point], t = e.length * nodes_.share(from_origin);
      // The neighbour on the edge towards the head; the twin reaches the other one.
      improve(
          from_origin == nodes_.points() ? mesh().head(h) : nodes_.on(mesh(), h, from_origin + 1),
          d + e.length * nodes_.share(1));
      if (mesh().twin(h) == kNone) {
        improve(from_origin == 1 ? e.origin : nodes_.on(mesh(), h, from_origin - 1),
                d + e.length * nodes_.share(1));
      }
      improve(mesh().apex(h), d + distance({e.apex_x, e.apex_y}, {t, 0}));
      reach_next_edge(h, {t, 0}, d);
      reach_previous_edge(h, {t, 0}, d);
    }
  }

  /// Reaches the points of the edge from the head of h to the apex.
  /// @param from in the frame of h
  void reach_next_edge(Index h, Point2 from, double d) {
    const HalfEdge& e = mesh().half_edge(h);
    reach_points(Mesh::next(h), {e.length, 0}, {e.apex_x, e.apex_y}, from, d);
  }
  /// Reaches the points of the edge from the apex to the origin of h.
  void reach_previous_edge(Index h, Point2 from, double d) {
    const HalfEdge& e = mesh().half_edge(h);
    reach_points(Mesh::previous(h), {e.apex_x, e.apex_y}, {0, 0}, from, d);
  }
  void reach_points(Index edge, Point2 begin, Point2 end, Point2 from, double d) {
    for (Index step = 1; step <= nodes_.points(); ++step) {
      const double share = nodes_.share(step);
      const Point2 to{begin.x + (end.x - begin.x) * share, begin.y + (end.y - begin.y) * share};
      improve(nodes_.on(mesh(), edge, step), d + distance(from, to));
    }
  }

  Nodes nodes_;
  VertexHeap front_;
  std::vector<double> distances_;  // of all nodes
};

const RegisterSolver<Steiner> registered{{
    .name = "steiner",
    .family = "Dijkstra",
    .paper = "Lanthier, Maheshwari, Sack 1997, Approximating weighted shortest paths on "
             "polyhedral surfaces",
    .exactness = Exactness::upper_bound,
    .remarks = "paths straight between points on edges",
    .parameters = {integer_parameter("points", 3, 0, 100, "Steiner points on every edge")},
}};

}  // namespace
}  // namespace geodesic::steiner
