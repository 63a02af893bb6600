// `template`: exact distances in few lines, as a starting point.
//
// The ideas are those of Mitchell, Mount, Papadimitriou 1987, "The discrete geodesic problem":
// - Unfolded into a plane, a shortest path is straight except at vertices where it may bend: saddle
//   vertices and boundary vertices. Such a vertex acts as a source, a pseudo-source.
// - A window (core/window.h) is an interval of an edge that straight lines from one (pseudo-)source
//   reach. The next face of these lines has two other edges, which get the window's children.
// - A line longer than another path to the same point is dropped.
// Here windows are processed first in, first out, and only paths over the ends of their edge may
// beat them: correct, short and slow.
#include <deque>
#include <optional>

#include "solvers/core/last_segments.h"
#include "solvers/core/registry.h"
#include "solvers/core/tolerance.h"
#include "solvers/core/window_bound.h"
#include "solvers/core/window_predicates.h"

namespace geodesic {
namespace {

class Unfolding final : public Solver {
 public:
  Unfolding(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), budget_(mesh) {}

 private:
  struct Waiting {
    Index half_edge;  ///< its face is entered next, and its frame is that of the window
    Index root;       ///< the root of the lines, as in LastSegment (core/recording.h)
    Index faces;      ///< number of faces crossed since the root
    Window window;
  };

  void run(const Start& start, std::span<double> distances) override {
    distances_ = distances;
    sources_.clear();
    windows_.clear();
    budget_.start();
    for (const auto& [v, distance, always_emits, last_segment] : start.vertices) {
      improve(v, distance, last_segment, always_emits);
    }
    for (const auto& [side, window, root] : start.windows) land(side, root, 0, window);
    while (!sources_.empty() || !windows_.empty()) {
      if (!sources_.empty()) {
        const InternalSource source = sources_.front();
        sources_.pop_front();
        if (!(distances_[source.at.vertex] < source.distance)) send_out(source);
      } else {
        const Waiting w = windows_.front();
        windows_.pop_front();
        budget_.spend(1);
        const bool is_too_far = least_distance(w.window) > start.query.limit;
        if (!is_too_far && !is_beaten(w)) cross_face(w);
      }
    }
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    if (recording.kind == RecordingKind::paths) {
      paths_.emplace(mesh(), start.query, recording.keeps_windows);
    }
    run(start, distances);
    if (paths_) paths_->finish(distances, recording);
    paths_.reset();
  }

  /// Updates v with a path of this length.
  /// @param sends_out makes v a source even if it is not a pseudo-source
  void improve(Index v, double distance, const LastSegment& last_segment, bool sends_out = false) {
    if (!(distance < distances_[v])) return;
    // If a path is shorter by rounding only, the recorded segment is kept.
    if (paths_ && distance < distances_[v] * (1 - kPathMargin)) paths_->arrived(v, last_segment);
    distances_[v] = distance;
    if (sends_out || mesh().is_pseudo_source(v)) sources_.push_back({InternalPoint(v), distance});
  }

  /// Follows the edges at a (pseudo-)source, and adds a window to the far edge of each face.
  void send_out(const InternalSource& source) {
    const Index v = source.at.vertex;
    for (const Index h : mesh().outgoing(v)) {
      const Index far = Mesh::next(h), into = Mesh::previous(h);
      const double out = mesh().half_edge(h).length, in = mesh().half_edge(into).length;
      improve(mesh().head(h), source.distance + out, {into, v, {in, 0}},
              is_next_to_apex(mesh().half_edge(into), out));
      improve(mesh().apex(h), source.distance + in, {h, v, {0, 0}},
              is_next_to_apex(mesh().half_edge(h), in));
      const HalfEdge& edge = mesh().half_edge(far);
      const Point2 from = apex_from_beyond(edge);
      land(far, v, 0, {0, edge.length, from.x, from.y, source.distance});
    }
  }

  /// Adds a window on the edge of h for the face beyond it, if there is one. The window is in the
  /// frame of the twin of h.
  void land(Index h, Index root, Index faces, const Window& w) {
    const HalfEdge& edge = mesh().half_edge(h);
    if (edge.twin == kNone || is_void(w, edge.length)) return;
    if (is_strip_too_long(mesh().face_count(), faces + 1)) return;
    windows_.push_back({edge.twin, root, faces, w});
  }

  /// Whether a path over an end of the edge is the shorter one for every point of the window.
  bool is_beaten(const Waiting& waiting) const {
    const HalfEdge& edge = mesh().half_edge(waiting.half_edge);
    const Index head = mesh().head(waiting.half_edge);
    return EndpointBounds(edge.length, distances_[edge.origin], distances_[head])
        .beat(waiting.window);
  }

  /// Unfolds a window over its face: to the apex, and on to the edges left and right of it.
  void cross_face(const Waiting& waiting) {
    const Index h = waiting.half_edge, root = waiting.root;
    const Window& w = waiting.window;
    if (paths_) paths_->crosses(h, w, root);
    const FaceFrame face = face_frame(mesh(), h);
    const Point2 apex = {face.apex_x, face.apex_y};
    const WindowSight sight(w, apex);
    if (sight.reaches()) {
      improve(mesh().apex(h), least_distance_to(w, apex.x, apex.y), {h, root, {w.x, w.y}});
    }
    for_each_child(h, face, w, sight, [&](Index side, const Window& child) {
      land(side, root, waiting.faces + 1, child);
    });
  }

  WindowBudget budget_;
  std::span<double> distances_;
  std::deque<InternalSource> sources_;  // sources that must still send out windows
  std::deque<Waiting> windows_;         // windows that must still cross a face
  std::optional<LastSegments> paths_;   // last segments of paths, while they are recorded
};

const RegisterSolver<Unfolding> registered{{
    .name = "template",
    .family = "template",
    .paper = "Mitchell, Mount, Papadimitriou 1987, The discrete geodesic problem",
    .abilities = {.surface_sources = true, .paths = true, .max_vertices = 5000},
}};

}  // namespace
}  // namespace geodesic
