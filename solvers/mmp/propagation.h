// MMP: continuous Dijkstra over windows; the order of propagation is a policy.
//
// Mitchell, Mount, Papadimitriou 1987, "The discrete geodesic problem"; Surazhsky et al. 2005,
// "Fast exact and approximate geodesics on meshes"; Liu 2013, "Exact geodesic metric in 2-manifold
// triangle meshes using edge-based data structures" (one list an edge, for both sides).
//
// The queue holds windows and pseudo-sources. A window from the queue is unfolded across the face
// that it enters. Its children are inserted among the windows of the two edges on which they land
// (windows_of_edges.h), and the parts that they win are queued. A pseudo-source sends windows into
// all its faces.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "solvers/core/solver.h"
#include "solvers/core/window_bound.h"
#include "solvers/core/window_predicates.h"
#include "solvers/mmp/windows_of_edges.h"

namespace geodesic::mmp {

/// The windows that a solve leaves in memory.
enum class Keep : std::uint8_t {
  wavefront,    ///< lists that the wavefront has passed are freed
  all,          ///< none is freed
  for_readers,  ///< all, and windows along edges
};

/// The state of one solve, reusable. @tparam Policy as in mmp.h
template <class Policy, class Recorder>
class Propagation {
 public:
  Propagation(const Mesh& mesh, typename Policy::Queue queue, Recorder recorder = {})
      : mesh_(mesh),
        recorder_(recorder),
        budget_(mesh),
        edges_(mesh.half_edge_count(), std::move(queue), recorder_),
        rounding_(coordinate_rounding(mesh)) {}
  Propagation(const Propagation&) = delete;
  Propagation& operator=(const Propagation&) = delete;

  /// @param keep whether to keep windows that the wavefront has passed
  void run(const Start& start, std::span<double> distances, Keep keep = Keep::wavefront) {
    const auto timed = recorder_.enter(Phase::propagation);
    keep_ = keep;
    begin(start, distances);
    while (!edges_.empty()) {
      if (stops_ && is_over()) [[unlikely]] {
        break;
      }
      budget_.spend(1);
      if (keep == Keep::wavefront) edges_.release_passed(mesh_, distances_);
      const W w = edges_.take(mesh_);
      if (w.state == State::waits) {
        propagate(w);
      } else if (w.state == State::vertex) {
        emit(w.into);
      }
      if (progress_.made_step()) edges_.sample(progress_);
    }
    if constexpr (Recorder::kRecords) recorder_.recording.window_limit = edges_.windows_left();
  }

  /// The windows of the last solve on an edge (FinalWindows). It must have kept all windows.
  void copy_windows(Index half_edge, std::vector<Window>& windows) const {
    edges_.copy_windows(list_of(half_edge, mesh_.twin(half_edge)), windows);
  }

 private:
  using Edges = WindowsOfEdges<typename Policy::Queue, Recorder>;
  using W = typename Edges::W;
  using Origin = typename Edges::Origin;
  using Root = typename Origin::Root;
  using LastSegment = LastSegmentOf<Recorder>;

  void begin(const Start& start, std::span<double> distances) {
    distances_ = distances;
    emitted_.assign(distances.size(), kInfinity);
    edges_.start(start.query.limit);
    budget_.start();
    progress_.start(mesh_, start);
    stops_ = start.query.stop_at_targets;
    if (stops_) edges_.keep_sorted();
    stop_rule_ = StopRule(mesh_, start.query, distances_);
    for (const auto& [v, distance, always_emits, last] : start.vertices) {
      improve(v, distance, always_emits, last);
    }
    for (const StartWindow& each : start.windows) begin_across(each);
    if (keep_ == Keep::for_readers) begin_along_edges(start.query);
  }

  /// Gives v the distance of a path, if that is shorter.
  /// @param always_emits makes v send out windows even if it is no pseudo-source
  void improve(Index v, double distance, bool always_emits, LastSegment last_segment) {
    if (!(distance < distances_[v])) return;
    set_distance(v, distance);
    recorder_.arrived(v, last_segment);
    if (always_emits || (mesh_.is_pseudo_source(v) && has_news(v))) {
      edges_.push_vertex(v, distance);
    }
  }

  [[gnu::cold, gnu::noinline]] void begin_across(const StartWindow& start) {
    const double length = mesh_.half_edge(start.side).length;
    const Origin beyond = Origin{Root(start.root), {}}.next();
    const Window leaving = turned(start.window, length);
    land(start.side, leaving, false, beyond);
    cross_at_once(start.side, leaving, beyond);
    row_ = 0;
  }

  /// Adds the windows along the edges on which sources lie (emit_along_edges).
  void begin_along_edges(const InternalQuery& query) {
    for (Index i = 0; i < query.sources.size(); ++i) {
      const InternalSource& source = query.sources[i];
      const Index under = source.at.is_vertex() ? kNone : edge_under(source.at);
      if (under == kNone) continue;
      const double at = in_frame(mesh_, source.at, under).x;
      land(under, {0, mesh_.half_edge(under).length, at, 0, source.distance}, false,
           {Root(mesh_.vertex_count() + i), {}});
    }
  }

  /// True when no more distances can change.
  [[gnu::noinline]] bool is_over() { return stop_rule_.is_over(edges_.least_key()); }

  void set_distance(Index v, double distance) {
    progress_.improved(distances_[v]);
    distances_[v] = distance;
  }

  /// Reaches the apex of h along an edge from a vertex that emits.
  void improve_neighbour(Index h, double distance, double edge, LastSegment last_segment) {
    if (!(distance + edge < distances_[mesh_.apex(h)])) return;
    improve(mesh_.apex(h), distance + edge, is_next_to_apex(mesh_.half_edge(h), edge),
            last_segment);
  }

  /// False when v has already sent out windows of its distance, up to rounding.
  bool has_news(Index v) const { return distances_[v] < emitted_[v] * (1 - kPathMargin); }

  /// Sends windows from v to the opposite edges of its faces, and follows its own edges.
  void emit(Index v) {
    if (!has_news(v)) return;
    const double d = distances_[v];
    emitted_[v] = d;
    const Origin along{Root(v), {}}, beyond = along.next();
    if (keep_ == Keep::for_readers) emit_along_edges(v, along);
    for (const Index h : mesh_.outgoing(v)) {
      const Index opposite = Mesh::next(h), into = Mesh::previous(h);
      const double out = mesh_.half_edge(h).length, in = mesh_.half_edge(into).length;
      improve_neighbour(into, d, out, {into, v, {in, 0}});
      improve_neighbour(h, d, in, {h, v, {0, 0}});
      const HalfEdge& e = mesh_.half_edge(opposite);
      const double height = std::max(e.apex_y, kTouchingHeight * e.length);
      const Window across{0, e.length, e.apex_x, height, d};
      const EndpointBounds bounds(e.length, distances_[e.origin], distances_[mesh_.head(opposite)]);
      if (!bounds.beat_whole(d + out, d + in)) land(opposite, across, false, beyond);
      cross_at_once(opposite, across, beyond);
      row_ = 0;
    }
  }

  /// A window along its own edge is of use only to those who read all windows in the end: it enters
  /// no face, and what it takes from others is soon taken by other windows too.
  [[gnu::cold, gnu::noinline]] void emit_along_edges(Index v, const Origin& along) {
    mesh_.for_each_edge_at(v, [&](Index /*end*/, Index edge, Index /*facing*/) {
      const double length = mesh_.half_edge(edge).length;
      land(edge, {0, length, mesh_.origin(edge) == v ? 0 : length, 0, distances_[v]}, false, along);
    });
  }

  /// If a pseudo-source lies on an edge (the apex of a face with almost no area), all its lines
  /// pass the edge in one point. Other windows may own the edge on both sides of that point and
  /// still not see the surface beyond. The window then loses, but its children must be kept. They
  /// may reach another such edge. Out of line, so that cross_face is compiled as without it.
  /// @param w in the frame of h, whose face it leaves
  [[gnu::cold, gnu::noinline]] void cross_at_once(Index h, const Window& w, const Origin& origin) {
    const HalfEdge& e = mesh_.half_edge(h);
    const bool on_edge = w.y > 0 && w.y <= kFlatFace * e.length && w.begin < w.x && w.x < w.end;
    if (!on_edge || e.twin == kNone || row_ == kMostInRow) return;
    ++row_;
    const Origin beyond = origin.next();
    mesh_.for_each_sheet(h, [&](Index g) {
      budget_.spend(1);
      recorder_.propagated(1, beyond.depth);
      cross_face(mesh_.twin(g), turned(w, e.length), beyond);
    });
  }

  void propagate(const W& w) {
    const Origin origin = w.origin.next();
    recorder_.propagated(1, origin.depth);
    const double length = mesh_.half_edge(w.into).length;
    Window entering = mirrored_if(w.y > 0, w, length);
    entering.y = -std::abs(w.y);
    if (-entering.y < kNextToEdge * rounding_) [[unlikely]] {
      widen(entering, length);
    }
    cross_face(w.into, entering, origin);
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
  void cross_face(Index h, const Window& w, const Origin& origin) {
    recorder_.crosses(h, w, origin.root);
    const HalfEdge& e = mesh_.half_edge(h);
    const WindowSight sight(w, {e.apex_x, e.apex_y});
    const bool left = sight.left(), right = sight.right();
    if (sight.reaches()) [[unlikely]] {
      improve(mesh_.apex(h), least_distance_to(w, e.apex_x, e.apex_y), false,
              {h, origin.root, {w.x, w.y}});
    }
    if (left && right) [[unlikely]] {
      land_child(h, false, w, true, origin);
      land_child(h, true, w, true, origin);
    } else if (left || right) {
      land_child(h, right, w, false, origin);
    }
  }

  /// Inserts a child on the left edge of a face, from the origin of h to the apex, or on the right
  /// one, from the head of h: the same, mirrored. Which one is hard to predict: no branch decides.
  /// @param w in the frame of h, whose face it enters
  /// @param to_apex the child ends at the apex
  void land_child(Index h, bool right, const Window& w, bool to_apex, const Origin& origin) {
    const Index corner = right ? Mesh::next(h) : h, before = Mesh::previous(corner);
    const Index side = right ? corner : before;
    const double length = mesh_.half_edge(side).length, to_corner = mesh_.half_edge(before).length;
    // The direction of the child's edge from the corner. An edge of length zero takes no window.
    const double cosine = mesh_.half_edge(corner).apex_x / to_corner;
    const double sine = mesh_.half_edge(corner).apex_y / to_corner;
    const Window seen = mirrored_if(right, w, mesh_.half_edge(h).length);
    const double height = -w.y;
    // The lines through both ends meet the child's edge, counted from the corner.
    const Ends t{seen.begin, seen.end};
    const Ends denominator = height * cosine - (t - seen.x) * sine, limit{length, length};
    Ends on = height * t / denominator;
    on = on > 0 ? on : Ends{};
    on = on < limit ? on : limit;
    on = denominator > 0 ? on : limit;
    if (to_apex) on[1] = length;
    // Rounding must not move the source across the edge.
    const Window child{on[0], on[1], seen.x * cosine - height * sine,
                       std::max(height * cosine + seen.x * sine, 0.0), w.sigma};
    land(side, child, !right, origin);
    if (row_ > 0) [[unlikely]] {
      cross_at_once(side, mirrored_if(!right, child, length), origin);
    }
  }

  /// @param w in the frame of h, whose face it leaves, or `mirrored`; y >= 0
  void land(Index h, const Window& w, bool mirrored, const Origin& origin) {
    const double length = mesh_.half_edge(h).length;
    if (is_void(w, length)) return;
    insert(h, length, w, mirrored, origin);
    if (mesh_.crosses_non_manifold_edges()) [[unlikely]] {
      insert_on_other_sheets(h, length, w, mirrored, origin);
    }
  }

  [[gnu::cold, gnu::noinline]] void insert_on_other_sheets(Index h, double length, const Window& w,
                                                           bool mirrored, const Origin& origin) {
    if (!(w.y > 0)) return;
    mesh_.for_each_sheet(h, [&](Index g) {
      if (g != h) insert(g, length, w, mirrored, origin);
    });
  }

  /// @param w as for `land`, in the frame of any half-edge of the edge in the direction of h
  void insert(Index h, double length, const Window& w, bool mirrored, const Origin& origin) {
    const Index twin = mesh_.twin(h), list = list_of(h, twin);
    const bool turns = list != h;
    W listed{mirrored_if(turns != mirrored, w, length), w.y > 0 ? twin : kNone, State::waits,
             origin};
    listed.y *= kSign[turns];
    edges_.insert(list, length, listed);
  }

  /// Converts a window from the frame of a half-edge to the frame of its twin.
  static Window turned(const Window& w, double length) {
    return {length - w.end, length - w.begin, length - w.x, -w.y, w.sigma};
  }

  /// A window with its edge in the other direction, if that is asked for. Without a branch, which
  /// would be mispredicted in half of all cases.
  static Window mirrored_if(bool asked, const Window& w, double length) {
    const double sign = kSign[asked], from = kShare[asked] * length;
    const double one = from + sign * w.begin, other = from + sign * w.end;
    return {std::min(one, other), std::max(one, other), from + sign * w.x, w.y, w.sigma};
  }

  static constexpr double kSign[] = {1, -1}, kShare[] = {0, 1};  // as it is, mirrored

  // Rows of faces without area are short, except on meshes that lie on a line.
  static constexpr int kMostInRow = 32;

  const Mesh& mesh_;
  [[no_unique_address]] Recorder recorder_;
  WindowBudget budget_;
  Edges edges_;
  double rounding_;  // of coordinates
  std::span<double> distances_;
  std::vector<double> emitted_;  // distance of the windows that each vertex sent out last
  int row_ = 0;                  // faces that the current window has crossed at once
  StopRule stop_rule_;
  Keep keep_ = Keep::wavefront;
  bool stops_ = false;  // the query stops at targets
  [[no_unique_address]] typename Recorder::Progress progress_;
};

}  // namespace geodesic::mmp
