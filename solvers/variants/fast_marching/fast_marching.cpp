// `fast-marching`: the eikonal equation on the mesh, vertex by vertex.
//
// Kimmel, Sethian 1998, "Computing geodesic paths on manifolds" (PNAS 95). Vertices are accepted in
// the order of their distances. If a planar wave that passed two corners of a face at their times
// reaches the third one through the face, it determines the time there; otherwise the time is that
// along an edge. Obtuse corners are split (unfolded.h). No bound of the error is known: waves are
// round, and have an edge where they meet.
#include "solvers/core/queues/vertex_heap.h"
#include "solvers/core/registry.h"
#include "solvers/variants/fast_marching/unfolded.h"

namespace geodesic::fast_marching {
namespace {

/// A point and the time at which the wave passed it; infinite if it has not.
struct Passed {
  Point2 at;
  double time;  ///< the distance from the source
};

/// Time at which the wave from one point reaches the corner.
double arrival_time(Point2 corner, const Passed& point) {
  const double dx = point.at.x - corner.x, dy = point.at.y - corner.y;
  return point.time + std::sqrt(dx * dx + dy * dy);
}

/// Time at which the wave from two points reaches it: the quadratic equation of section 4.1. With a
/// the earlier point, u the time between the two, and t the time from a to the corner, the wave's
/// direction lies within the corner if it is upwind of both.
double arrival_time(Point2 corner, Passed a, Passed b) {
  if (b.time < a.time) std::swap(a, b);
  const double along_an_edge = std::min(arrival_time(corner, a), arrival_time(corner, b));
  const double ax = a.at.x - corner.x, ay = a.at.y - corner.y;
  const double bx = b.at.x - corner.x, by = b.at.y - corner.y;
  const double product = ax * bx + ay * by, a2 = ax * ax + ay * ay, b2 = bx * bx + by * by;
  const double apart2 = (ax - bx) * (ax - bx) + (ay - by) * (ay - by);
  const double u = b.time - a.time;
  if (!(u * u < apart2) || product < 0) return along_an_edge;
  const double area = std::abs(ax * by - ay * bx);
  const double t = (u * (a2 - product) + area * std::sqrt(apart2 - u * u)) / apart2;
  const bool upwind = u < t && product * t < a2 * (t - u) && product * (t - u) < b2 * t;
  return upwind ? a.time + t : along_an_edge;
}

class FastMarching final : public Solver {
 public:
  FastMarching(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        splitters_(mesh),
        front_(mesh.vertex_count()),
        accepted_(mesh.vertex_count()) {}

 private:
  void run(const Start& start, std::span<double> distances) override {
    distances_ = distances;
    std::ranges::fill(accepted_, std::uint8_t{0});
    front_.clear();
    for (const StartVertex& each : start.vertices) improve(each.vertex, each.distance);
    while (!front_.empty() && front_.least_key() <= start.query.limit) {
      const Index v = front_.pop();
      accepted_[v] = 1;
      for (const Index h : mesh().outgoing(v)) {
        update_corner(h);
        update_corner(Mesh::previous(h));
      }
      for (const Splitter& splitter : splitters_.by_vertex(v)) update_corner(splitter.opposite);
    }
  }

  void improve(Index v, double distance) {
    if (!(distance < distances_[v])) return;
    distances_[v] = distance;
    front_.push_or_decrease(v, distance);
  }

  Passed passed(Index v, Point2 at) const {
    return {at, accepted_[v] != 0 ? distances_[v] : kInfinity};
  }

  /// Updates the corner at the apex of h from its accepted neighbours.
  void update_corner(Index h) {
    const Index v = mesh().apex(h);
    if (accepted_[v] != 0) return;
    const HalfEdge& e = mesh().half_edge(h);
    const Point2 corner{e.apex_x, e.apex_y};
    const Passed origin = passed(e.origin, {0, 0}), head = passed(mesh().head(h), {e.length, 0});
    if (const Splitter* splitter = splitters_.of_corner(h)) {
      const Passed middle = passed(splitter->vertex, splitter->at);
      improve(v,
              std::min(arrival_time(corner, origin, middle), arrival_time(corner, middle, head)));
    } else {
      improve(v, arrival_time(corner, origin, head));
    }
  }

  Splitters splitters_;
  VertexHeap front_;
  std::vector<std::uint8_t> accepted_;
  std::span<double> distances_;
};

const RegisterSolver<FastMarching> registered{{
    .name = "fast-marching",
    .family = "fast marching",
    .paper = "Kimmel, Sethian 1998, Computing geodesic paths on manifolds",
    .exactness = Exactness::unbounded,
    .remarks = "obtuse corners are split by unfolding",
}};

}  // namespace
}  // namespace geodesic::fast_marching
