// `template`: exact distances in few lines, to start from.
//
// Mitchell, Mount, Papadimitriou 1987, "The discrete geodesic problem", has the ideas:
// - Unfolded into a plane, a shortest path is straight, but for vertices where it may bend: saddle
//   vertices and boundaries. Such a vertex is a source again, a pseudo-source.
// - A window (core/window.h) is an interval of an edge that straight lines from one (pseudo-)source
//   reach. The face that they enter next has two other edges: the window's children lie there.
// - A line that another path beats need not go on.
// Here windows wait first in, first out, and only the ends of their own edge may beat them: right,
// short and slow.
#include <algorithm>
#include <deque>

#include "solvers/core/registry.h"
#include "solvers/core/tolerance.h"
#include "solvers/core/window.h"
#include "solvers/core/window_bound.h"

namespace geodesic {
namespace {

class Unfolding final : public Solver {
 public:
  Unfolding(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), budget_(mesh) {}

 private:
  struct Waiting {
    Index half_edge;  ///< the one whose face the lines enter, and in whose frame the window is
    Window window;
  };

  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    distances_ = distances;
    sources_.clear();
    windows_.clear();
    budget_.start();
    for (const Source& source : query.sources) {
      distances_[source.at.vertex] = std::min(distances_[source.at.vertex], source.distance);
      sources_.push_back(source);
    }
    while (!sources_.empty() || !windows_.empty()) {
      if (!sources_.empty()) {
        const Source source = sources_.front();
        sources_.pop_front();
        if (!(distances_[source.at.vertex] < source.distance)) send_out(source);
      } else {
        const auto [half_edge, window] = windows_.front();
        windows_.pop_front();
        budget_.spend(1);
        const bool is_too_far = least_distance(window) > query.limit;
        if (!is_too_far && !is_beaten(half_edge, window)) cross_face(half_edge, window);
      }
    }
  }

  /// There is a path of this length to v.
  /// `sends_out`: wherever v lies.
  void reach(Index v, double distance, bool sends_out = false) {
    if (!(distance < distances_[v])) return;
    distances_[v] = distance;
    if (sends_out || mesh().is_pseudo_source(v)) sources_.push_back({v, distance});
  }

  /// Follows the edges at a (pseudo-)source, and sends a window over the far edge of each face.
  void send_out(const Source& source) {
    for (const Index h : mesh().outgoing(source.at.vertex)) {
      const Index far = Mesh::next(h), into = Mesh::previous(h);
      for (const auto& [far_from, along] : {std::pair{into, h}, std::pair{h, into}}) {
        const double length = mesh().half_edge(along).length;
        reach(mesh().apex(far_from), source.distance + length,
              is_next_to_apex(mesh().half_edge(far_from), length));
      }
      const HalfEdge& edge = mesh().half_edge(far);
      land(far, 0, edge.length, apex_from_beyond(edge), source.distance);
    }
  }

  /// Puts a window on the edge of h, for the face beyond it, if there is one. All is in the frame
  /// of the twin of h.
  void land(Index h, double begin, double end, const Point2& source, double sigma) {
    const HalfEdge& edge = mesh().half_edge(h);
    if (edge.twin == kNone || !(end - begin > kWindowWidth * edge.length)) return;
    // Rounding must not move the source across the edge.
    windows_.push_back({edge.twin, {begin, end, source.x, std::min(source.y, 0.0), sigma}});
  }

  /// True when the path over an end of the edge is the shorter one for every point of the window.
  /// It is when it is for the window's farther end: the ways there pass all its points.
  bool is_beaten(Index h, const Window& w) const {
    const HalfEdge& edge = mesh().half_edge(h);
    const double over_origin = distances_[edge.origin] + w.end;
    const double over_head = distances_[mesh().head(h)] + (edge.length - w.begin);
    return over_origin < distance_at(w, w.end) * (1 - kPathMargin) ||
           over_head < distance_at(w, w.begin) * (1 - kPathMargin);
  }

  /// Unfolds a window over the face of h: to the apex, and on to the edges left and right of it.
  void cross_face(Index h, const Window& w) {
    const FaceFrame face = face_frame(mesh(), h);
    reach(mesh().apex(h), least_distance_to(w, face.apex_x, face.apex_y));
    const bool any_left = apex_side(w, w.begin, face) > 0;
    const bool any_right = apex_side(w, w.end, face) < 0;
    if (any_left) {
      const double end = any_right ? face.left : face.on_left(w, w.end);
      land(Mesh::previous(h), face.on_left(w, w.begin), end, face.to_left(w.x, w.y), w.sigma);
    }
    if (any_right) {
      const double begin = any_left ? 0 : face.on_right(w, w.begin);
      land(Mesh::next(h), begin, face.on_right(w, w.end), face.to_right(w.x, w.y), w.sigma);
    }
  }

  WindowBudget budget_;
  std::span<double> distances_;
  std::deque<Source> sources_;   // that have not sent out windows of their distance yet
  std::deque<Waiting> windows_;  // that have not crossed a face yet
};

const RegisterSolver<Unfolding> registered{{
    .name = "template",
    .family = "template",
    .paper = "Mitchell, Mount, Papadimitriou 1987, The discrete geodesic problem",
    .data_structure = "FIFO queue",
    .time_complexity = "not known",
    .space_complexity = "not known",
    .propagation = "window",
    .abilities = {.max_vertices = 5000},
}};

}  // namespace
}  // namespace geodesic
