// `flip-out`: Dijkstra's paths, made shorter by flipping edges until they are locally shortest.
//
// Sharp, Crane 2020, "You can find geodesic paths in triangle meshes by just flipping edges" (ACM
// Transactions on Graphics 39(6)). If the angle of a path of edges at a vertex is less than pi, the
// edges in it are flipped until the way around them is convex. That way is shorter, and the path
// takes it. The result is straight, but need not be the shortest path: it is one into which
// the path along edges can be deformed continuously. Distances are those along edges.
#include <algorithm>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "solvers/core/registry.h"
#include "solvers/core/tolerance.h"
#include "solvers/dijkstra/dijkstra.h"
#include "solvers/variants/flip_out/intrinsic_mesh.h"

namespace geodesic::flip_out {
namespace {

bool is_convex(double angle) { return angle < std::numbers::pi - kFlipStraight; }

/// A path of edges in a triangulation that it modifies.
class EdgePath {
 public:
  /// @param vertices the path: each vertex a neighbour of the previous one, without repetition
  EdgePath(IntrinsicMesh& mesh, const std::vector<InternalPoint>& vertices,
           std::vector<bool>& on_path)
      : mesh_(mesh), on_path_(on_path) {
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      edges_.push_back(mesh_.between(vertices[i].vertex, vertices[i + 1].vertex));
    }
    for (const InternalPoint& point : vertices) on_path_[point.vertex] = true;
  }

  ~EdgePath() {
    on_path_[mesh_.origin(edges_.front())] = false;
    for (const Index h : edges_) on_path_[mesh_.head(h)] = false;
  }
  EdgePath(const EdgePath&) = delete;
  EdgePath& operator=(const EdgePath&) = delete;

  /// Makes the path locally shortest, beginning at the sharpest bend (section 3.2).
  void shorten() {
    for (std::size_t i = 1; i < edges_.size(); ++i) enqueue(i);
    while (!bends_.empty()) {
      const Index v = bends_.top().second;
      bends_.pop();
      const auto out = std::ranges::find(edges_, v, [&](Index h) { return mesh_.origin(h); });
      if (out == edges_.end() || out == edges_.begin()) continue;
      const auto i = static_cast<std::size_t>(out - edges_.begin());
      if (const Wedge wedge = wedge_at(i); is_convex(wedge.angle)) go_around(i, wedge);
    }
  }

  const std::vector<Index>& edges() const { return edges_; }

 private:
  /// The angle of a path at a vertex, on one side.
  struct Wedge {
    Index right, left;  ///< half-edges of the vertex, counter-clockwise
    double angle;       ///< infinite if there is a boundary between them
  };
  using Bend = std::pair<double, Index>;  // angle and vertex

  double angle_between(Index right, Index left) const {
    double sum = 0;
    for (Index h = right; h != left; h = mesh_.left_of(h)) {
      if (!mesh_.has_face(h)) return kInfinity;
      sum += mesh_.angle(h);
      if (!is_convex(sum)) return kInfinity;
    }
    return sum;
  }

  /// Returns the wedge at the origin of edge i, on the side where the angle is less.
  Wedge wedge_at(std::size_t i) const {
    const Index back = mesh_.twin(edges_[i - 1]), out = edges_[i];
    const Wedge left{out, back, angle_between(out, back)};
    const Wedge right{back, out, angle_between(back, out)};
    return left.angle < right.angle ? left : right;
  }

  void enqueue(std::size_t i) {
    const Wedge wedge = wedge_at(i);
    if (is_convex(wedge.angle)) bends_.emplace(wedge.angle, mesh_.origin(edges_[i]));
  }

  /// Flips edges within a wedge until no angle of the way around it is convex (section 3.1).
  void flip_out(const Wedge& wedge) {
    for (Index h = mesh_.left_of(wedge.right); h != wedge.left;) {
      const Index before = mesh_.right_of(h), after = mesh_.left_of(h), twin = mesh_.twin(h);
      const bool flips =
          mesh_.has_two_faces(h) && is_convex(mesh_.angle(twin) + mesh_.angle(mesh_.next(h)));
      if (flips) mesh_.flip(h);
      h = !flips || before == wedge.right ? after : before;
    }
  }

  /// Leads the path around a wedge at the origin of edge i if that is shorter, which can only fail
  /// by rounding.
  void go_around(std::size_t i, const Wedge& wedge) {
    flip_out(wedge);
    std::vector<Index> around;
    double length = 0;
    for (Index h = wedge.right; h != wedge.left; h = mesh_.left_of(h)) {
      around.push_back(mesh_.next(h));
      length += mesh_.length(mesh_.next(h));
    }
    if (!(length < mesh_.length(edges_[i - 1]) + mesh_.length(edges_[i]))) return;
    if (wedge.right == edges_[i]) {
      std::ranges::reverse(around);
      for (Index& h : around) h = mesh_.twin(h);
    }
    on_path_[mesh_.origin(edges_[i])] = false;
    const auto at = edges_.begin() + static_cast<std::ptrdiff_t>(i);
    edges_.insert(edges_.erase(at - 1, at + 1), around.begin(), around.end());
    bool meets_itself = false;
    for (std::size_t k = 0; k + 1 < around.size(); ++k) {
      const Index v = mesh_.head(around[k]);
      meets_itself = meets_itself || on_path_[v];
      on_path_[v] = true;
    }
    if (meets_itself) drop_loops();
    const std::size_t first = meets_itself ? 1 : std::max<std::size_t>(i - 1, 1);
    const std::size_t last = meets_itself ? edges_.size() : i + around.size();
    for (std::size_t k = first; k < std::min(last, edges_.size()); ++k) enqueue(k);
  }

  /// Removes loops that lead from a vertex back to it.
  void drop_loops() {
    std::vector<Index> kept;
    for (const Index h : edges_) {
      kept.push_back(h);
      const Index v = mesh_.head(h);
      const auto loop = std::ranges::find(kept, v, [&](Index g) { return mesh_.origin(g); });
      for (auto g = loop; g != kept.end(); ++g) on_path_[mesh_.head(*g)] = false;
      kept.erase(loop, kept.end());
      on_path_[v] = true;
    }
    edges_ = std::move(kept);
  }

  IntrinsicMesh& mesh_;
  std::vector<bool>& on_path_;  // by vertex
  std::vector<Index> edges_;
  std::priority_queue<Bend, std::vector<Bend>, std::greater<>> bends_;
};

class FlipOut final : public Dijkstra {
 public:
  FlipOut(const Mesh& mesh, const Description& description)
      : Dijkstra(mesh, description), intrinsic_(mesh), on_path_(mesh.vertex_count()) {}

 private:
  std::vector<InternalPoint> trace_path(const InternalQuery& query,
                                        std::span<const double> distances, Index vertex) override {
    std::vector<InternalPoint> points = Dijkstra::trace_path(query, distances, vertex);
    if (points.size() < 3) return points;
    intrinsic_.reset();
    EdgePath path(intrinsic_, points, on_path_);
    path.shorten();
    points.resize(1);
    for (const Index h : path.edges()) intrinsic_.trace(h, points);
    return points;
  }

  IntrinsicMesh intrinsic_;
  std::vector<bool> on_path_;
};

const RegisterSolver<FlipOut> registered{{
    .name = "flip-out",
    .family = "edge flips",
    .paper =
        "Sharp, Crane 2020, You can find geodesic paths in triangle meshes by just flipping edges",
    .exactness = Exactness::upper_bound,
    .abilities = {.degenerate_faces = false, .traces = true},
    .remarks = "distances of paths along edges; its own paths are these, shortened until straight",
}};

}  // namespace
}  // namespace geodesic::flip_out
