// MMP: continuous Dijkstra over windows; the order of propagation is a policy.
//
// Mitchell, Mount, Papadimitriou 1987, "The discrete geodesic problem"; Surazhsky et al. 2005,
// "Fast exact and approximate geodesics on meshes"; Liu 2013, "Exact geodesic metric in 2-manifold
// triangle meshes using edge-based data structures" (one list an edge, for both sides).
//
// The queue holds windows and pseudo-sources. A window from the queue is unfolded across the face
// that it enters. Its children are inserted among the windows of the two edges on which they land
// (overlay.h), and the parts that they win are queued. A pseudo-source sends windows into all its
// faces. A waiting window that loses its nearest point gets a new key: it is re-inserted
// (edge_window.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "solvers/core/solver.h"
#include "solvers/core/window_bound.h"
#include "solvers/core/window_predicates.h"
#include "solvers/mmp/wavefront.h"

namespace geodesic::mmp {

/// The windows that stay in memory until the end of a solve.
enum class Keep : std::uint8_t { all, wavefront };

/// The state of one solve, reusable. @tparam Policy as in mmp.h
template <class Policy, class Recorder>
class Propagation {
 public:
  explicit Propagation(const Mesh& mesh, Recorder recorder = {})
      : mesh_(mesh),
        recorder_(recorder),
        budget_(mesh),
        wavefront_(mesh.half_edge_count(), Policy::make_queue(mesh), recorder_),
        rounding_(coordinate_rounding(mesh)) {}
  Propagation(const Propagation&) = delete;
  Propagation& operator=(const Propagation&) = delete;

  /// @param keep whether to keep windows that the wavefront has passed
  void run(const InternalQuery& query, std::span<double> distances, Keep keep = Keep::wavefront) {
    const auto timed = recorder_.enter(Phase::propagation);
    start(query, distances);
    while (!wavefront_.empty()) {
      if (stops_ && is_over()) [[unlikely]] {
        break;
      }
      budget_.spend(1);
      if (keep == Keep::wavefront) wavefront_.release_passed(mesh_, distances_);
      if (const auto taken = wavefront_.take(mesh_)) {
        if (taken->vertex != kNone) {
          emit(taken->vertex);
        } else {
          propagate(*taken);
        }
      }
      if constexpr (Recorder::kRecords) {
        if (progress_.made_step()) wavefront_.sample(mesh_, progress_);
      }
    }
    if constexpr (Recorder::kRecords) recorder_.recording.window_limit = wavefront_.windows_left();
  }

  /// The windows of the last solve on an edge (FinalWindows). It must have kept all windows.
  void copy_windows(Index half_edge, std::vector<Window>& windows) const {
    const Index edge = list_of(half_edge, mesh_.twin(half_edge));
    wavefront_.copy_windows(edge, mesh_.half_edge(edge).length, windows);
  }

 private:
  using Depth = typename Recorder::Depth;
  using Front = Wavefront<typename Policy::Queue, Recorder>;
  using Taken = typename Front::Taken;
  using LastSegment = LastSegmentOf<Recorder>;
  /// Data that a window's children inherit, besides the geometry.
  struct WindowOrigin {
    Index source;  ///< number of the pseudo-source
    Depth depth;
  };

  void start(const InternalQuery& query, std::span<double> distances) {
    distances_ = distances;
    emitted_.assign(distances.size(), kInfinity);
    wavefront_.start(query.limit);
    budget_.start();
    if constexpr (Recorder::kRecords) progress_.start(mesh_, source_vertices(mesh_, query));
    stops_ = query.stop_at_targets;
    if (stops_) wavefront_.keep_sorted();
    stop_rule_ = StopRule(mesh_, query, distances_);
    roots_.clear();
    Index beyond_vertices = mesh_.vertex_count();
    for (const InternalSource& source : query.sources) {
      const Index root = beyond_vertices++;
      if (source.at.is_vertex()) {
        start_at(source.at.vertex, source.distance, {kNone, source.at.vertex, {0, 0}});
      } else {
        spread(source, root);
      }
    }
  }

  /// Makes v send out windows, whether it is a pseudo-source or not.
  void start_at(Index v, double distance, LastSegment last_segment) {
    if (!(distance < distances_[v])) return;
    set_distance(v, distance);
    if constexpr (Recorder::kRemembers) recorder_.arrived(v, last_segment);
    wavefront_.push_vertex(v, distance);
  }

  /// Starts from a source that is not a vertex. Its windows wait on the sides of its face or faces,
  /// and lie along its edge if it is on one.
  [[gnu::cold, gnu::noinline]] void spread(const InternalSource& source, Index root) {
    const double d = source.distance;
    const Index number = add_source(d, root);
    const auto reach_corner = [&](Index h, const Point2& from, double rest, bool is_next)
        __attribute__((cold)) {
      if (is_next) {
        start_at(mesh_.apex(h), d + rest, {h, root, from});
      } else {
        reach(mesh_.apex(h), d + rest, {h, root, from});
      }
    };
    const auto cross_side = [&](Index h, const Point2& from) __attribute__((cold)) {
      const double length = mesh_.half_edge(h).length;
      const WindowOrigin beyond{number, Depth{}.next()};
      const Window across = turned({0, length, from.x, from.y, d}, length);
      land(h, across, beyond);
      cross_at_once(h, across, beyond);
      row_ = 0;
    };
    spread_from(mesh_, source.at, reach_corner, cross_side);
    const Index under = edge_under(source.at);
    if (under == kNone) return;
    const double length = mesh_.half_edge(under).length;
    land(under, {0, length, in_frame(mesh_, source.at, under).x, 0, d}, {number, {}});
  }

  /// True when no more distances can change.
  [[gnu::noinline]] bool is_over() { return stop_rule_.is_over(wavefront_.least_key()); }

  /// @param root as in LastSegment (core/recording.h)
  Index add_source(double sigma, Index root) {
    if constexpr (Recorder::kRemembers) roots_.push_back(root);
    return wavefront_.add_source(sigma);
  }

  /// Root of a window's source; kNone unless the recorder stores roots.
  Index root_of(const WindowOrigin& origin) const {
    if constexpr (Recorder::kRemembers) return roots_[origin.source];
    return kNone;
  }

  void set_distance(Index v, double distance) {
    if constexpr (Recorder::kRecords) progress_.reach(distances_[v]);
    distances_[v] = distance;
  }

  void reach(Index v, double distance, LastSegment last_segment) {
    if (!(distance < distances_[v])) return;
    set_distance(v, distance);
    if constexpr (Recorder::kRemembers) recorder_.arrived(v, last_segment);
    if (mesh_.is_pseudo_source(v) && has_news(v)) wavefront_.push_vertex(v, distance);
  }

  /// Reaches the apex of h along an edge from a vertex that emits.
  void reach_neighbour(Index h, double distance, double edge, LastSegment last_segment) {
    if (!(distance + edge < distances_[mesh_.apex(h)])) return;
    if (is_next_to_apex(mesh_.half_edge(h), edge)) {
      start_at(mesh_.apex(h), distance + edge, last_segment);
    } else {
      reach(mesh_.apex(h), distance + edge, last_segment);
    }
  }

  /// False when v has already sent out windows of its distance, up to rounding.
  bool has_news(Index v) const { return distances_[v] < emitted_[v] * (1 - kPathMargin); }

  /// Sends windows from v to the opposite edges of its faces and along its own edges.
  void emit(Index v) {
    if (!has_news(v)) return;
    const double d = distances_[v];
    emitted_[v] = d;
    const Index source = add_source(d, v);
    const WindowOrigin along{source, {}}, beyond{source, Depth{}.next()};
    for (const Index h : mesh_.outgoing(v)) {
      const Index opposite = Mesh::next(h), into = Mesh::previous(h);
      const double out = mesh_.half_edge(h).length, in = mesh_.half_edge(into).length;
      reach_neighbour(into, d, out, {into, v, {in, 0}});
      reach_neighbour(h, d, in, {h, v, {0, 0}});
      land(h, {0, out, 0, 0, d}, along);
      // The edge has no half-edge that leaves v.
      if (mesh_.twin(into) == kNone) land(into, {0, in, in, 0, d}, along);
      const HalfEdge& e = mesh_.half_edge(opposite);
      const double height = std::max(e.apex_y, kTouchingHeight * e.length);
      const Window across{0, e.length, e.apex_x, height, d};
      const EndpointBounds bounds(e.length, distances_[e.origin], distances_[mesh_.head(opposite)]);
      if (!bounds.beat_whole(d + out, d + in)) land(opposite, across, beyond);
      cross_at_once(opposite, across, beyond);
      row_ = 0;
    }
  }

  /// If a pseudo-source lies on an edge (the apex of a face with almost no area), all its lines
  /// pass the edge in one point. Other windows may own the edge on both sides of that point and
  /// still not see the surface beyond. The window then loses, but its children must be kept. They
  /// may reach another such edge. Out of line, so that cross_face is compiled as without it.
  /// @param w in the frame of h, whose face it leaves
  [[gnu::cold, gnu::noinline]] void cross_at_once(Index h, const Window& w,
                                                  const WindowOrigin& origin) {
    const HalfEdge& e = mesh_.half_edge(h);
    const bool on_edge = w.y > 0 && w.y <= kFlatFace * e.length && w.begin < w.x && w.x < w.end;
    if (!on_edge || e.twin == kNone || row_ == kMostInRow) return;
    ++row_;
    const WindowOrigin beyond{origin.source, origin.depth.next()};
    mesh_.for_each_sheet(h, [&](Index g) {
      budget_.spend(1);
      recorder_.propagated(1, beyond.depth);
      cross_face(mesh_.twin(g), turned(w, e.length), beyond);
    });
  }

  void propagate(const Taken& taken) {
    const WindowOrigin origin{taken.source, taken.depth.next()};
    recorder_.propagated(1, origin.depth);
    const bool enters_twin = !(taken.window.y < 0);
    const Index h = enters_twin ? mesh_.twin(taken.edge) : taken.edge;
    const double length = mesh_.half_edge(h).length;
    Window w = enters_twin ? turned(taken.window, length) : taken.window;
    if (-w.y < kNextToEdge * rounding_) [[unlikely]] {
      widen(w, length);
    }
    cross_face(h, w, origin);
  }

  /// Windows end where others begin. If rounding turns the lines at such an end, the lines of both
  /// windows diverge on the way. Each window is therefore extended beyond its end by the rounding.
  /// Its source is so near that such a line is shorter than one that bends at the end by less than
  /// that.
  [[gnu::cold, gnu::noinline]] void widen(Window& w, double length) const {
    if (is_turned_by_rounding(w, w.begin, rounding_)) w.begin = std::max(w.begin - rounding_, 0.0);
    if (is_turned_by_rounding(w, w.end, rounding_)) w.end = std::min(w.end + rounding_, length);
  }

  /// @param w in the frame of h, whose face it enters; y < 0
  void cross_face(Index h, const Window& w, const WindowOrigin& origin) {
    if constexpr (Recorder::kRemembers) recorder_.crossing(h, w, root_of(origin));
    const FaceFrame face = face_frame(mesh_, h);
    const WindowSight sight(w, {face.apex_x, face.apex_y});
    if (sight.reaches()) {
      reach(mesh_.apex(h), least_distance_to(w, face.apex_x, face.apex_y),
            {h, root_of(origin), {w.x, w.y}});
    }
    if (sight.left()) {
      const double end = sight.right() ? face.left : face.on_left(w, w.end);
      land_child(Mesh::previous(h), {face.on_left(w, w.begin), end}, face.to_left(w.x, w.y),
                 face.left, w.sigma, origin);
    }
    if (sight.right()) {
      const double begin = sight.left() ? 0.0 : face.on_right(w, w.begin);
      land_child(Mesh::next(h), {begin, face.on_right(w, w.end)}, face.to_right(w.x, w.y),
                 face.right, w.sigma, origin);
    }
  }

  struct Interval {
    double begin, end;
  };

  /// Inserts a child that leaves its face through h, given in the frame of h's twin.
  void land_child(Index h, Interval on, const Point2& source, double length, double sigma,
                  const WindowOrigin& origin) {
    // Rounding must not move the source across the edge.
    const Window child =
        turned({on.begin, on.end, source.x, std::min(source.y, 0.0), sigma}, length);
    land(h, child, origin);
    if (row_ > 0) [[unlikely]] {
      cross_at_once(h, child, origin);
    }
  }

  /// @param w in the frame of h, whose face it leaves; y >= 0
  void land(Index h, const Window& w, const WindowOrigin& origin) {
    const double length = mesh_.half_edge(h).length;
    if (is_void(w, length)) return;
    insert(h, length, w, origin);
    if (mesh_.crosses_non_manifold_edges()) [[unlikely]] {
      insert_on_other_sheets(h, length, w, origin);
    }
  }

  [[gnu::cold, gnu::noinline]] void insert_on_other_sheets(Index h, double length, const Window& w,
                                                           const WindowOrigin& origin) {
    if (!(w.y > 0)) return;
    mesh_.for_each_sheet(h, [&](Index g) {
      if (g != h) insert(g, length, w, origin);
    });
  }

  /// @param w in the frame of h, or of any half-edge of the edge in the same direction
  void insert(Index h, double length, const Window& w, const WindowOrigin& origin) {
    const Index twin = mesh_.twin(h);
    const bool goes_on = twin != kNone && w.y > 0;
    if (list_of(h, twin) == h) {
      wavefront_.insert(h, length, w, origin.source, origin.depth, goes_on);
    } else {
      wavefront_.insert(twin, length, turned(w, length), origin.source, origin.depth, goes_on);
    }
  }

  /// Converts a window from the frame of a half-edge to the frame of its twin.
  static Window turned(const Window& w, double length) {
    return {length - w.end, length - w.begin, length - w.x, -w.y, w.sigma};
  }

  // Rows of faces without area are short, except on meshes that lie on a line.
  static constexpr int kMostInRow = 32;

  const Mesh& mesh_;
  Recorder recorder_;
  WindowBudget budget_;
  Front wavefront_;
  double rounding_;  // of coordinates
  std::span<double> distances_;
  std::vector<double> emitted_;  // distance of the windows that each vertex sent out last
  int row_ = 0;                  // faces that the current window has crossed at once
  StopRule stop_rule_;
  bool stops_ = false;        // the query stops at targets
  std::vector<Index> roots_;  // by number of source; empty in timed solves
  [[no_unique_address]] typename Recorder::Progress progress_;
};

}  // namespace geodesic::mmp
