// The wavefront over the half-edges of a mesh: the order of vertices and of crossings.
// See edge_based.cpp for the algorithm.
//
// It contains no windows. A Crossing (list_crossing.h, merged_crossing.h) stores what waits on
// half-edges and propagates it across faces. A Crossing has
//
//   start(distances)            discards the last solve
//   emit(side, from, distance, root, wavefront)
//                               sends a window over the whole of a side out of its face, into all
//                               others; `from` in the frame of the side's twin, `root` as in
//                               LastSegment
//   emit_from_apex(wanted, side, wavefront)
//                               the same from the vertex opposite the side, if `wanted`
//   cross(h, wavefront)         propagates all that waits on h across the face of h
//   follow_edge(from, to)       a path along this edge is the shortest to `to` so far
//   finish()                    called once, when the propagation is over
//   rounding()                  of coordinates (core/window_predicates.h)
//   window_count(), for_each_window(h, visit)
//                               number of waiting windows; visit(const Window&) for each on h
//
// and calls `set_distance`, `improve` and `land` of the wavefront.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "solvers/core/queues/concepts.h"
#include "solvers/core/recorders.h"
#include "solvers/edge_based/entered_faces.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// @tparam Queue queue of vertices. Any order is correct; by distance, late arrivals are rare.
/// @tparam Recorder core/recorders.h; it changes no distance
template <class Crossing, class Queue, class Recorder>
class Wavefront {
  static_assert(VertexQueue<Queue>,
                "the queue lacks a member of VertexQueue (core/queues/concepts.h)");

 public:
  Wavefront(const Mesh& mesh, Queue queue, Crossing crossing, Recorder recorder)
      : mesh_(mesh),
        crossing_(std::move(crossing)),
        queue_(std::move(queue)),
        recorder_(std::move(recorder)),
        faces_(mesh.face_count()),
        always_emits_(mesh.vertex_count()) {}

  /// As Solver::run.
  void run(const Start& start, std::span<double> distances) {
    const auto timed = recorder_.enter(Phase::propagation);
    forget(distances);
    recorder_.window_bytes(sizeof(Window));
    progress_.start(mesh_, start);
    for (const StartVertex& each : start.vertices) begin_at(each);
    for (const StartWindow& each : start.windows) begin_across(each);
    StopRule stop_rule(mesh_, start.query, distances_);
    while (!queue_.empty() && !stop_rule.is_over(queue_.least_key())) {
      advance();
      if (progress_.made_step()) sample();
    }
    if (!queue_.empty()) finish_up_to(stop_rule.farthest());
    crossing_.finish();
  }

  // The steps of `run`, for a wavefront on a part of a mesh (parallel/regional_wavefront.h).

  /// Discards the last solve, however it ended.
  /// @param distances infinite; the wavefront fills them
  void forget(std::span<double> distances) {
    distances_ = distances;
    faces_.clear();
    always_emits_.assign(always_emits_.size(), false);
    queue_.clear();
    crossing_.start(distances);
  }

  /// Starts from a vertex. Out of line, like the next function, so that `set_distance` is inlined
  /// into the loop.
  [[gnu::cold, gnu::noinline]] void begin_at(const StartVertex& start) {
    const auto& [v, distance, always_emits, last] = start;
    if (always_emits) always_emits_[v] = true;
    if (!(distance < distances_[v])) return;
    set_distance(v, distance);
    recorder_.arrived(v, last);
  }

  /// Starts with a window.
  [[gnu::cold, gnu::noinline]] void begin_across(const StartWindow& start) {
    const auto& [side, w, root] = start;
    crossing_.emit(side, {w.x, w.y}, w.sigma, root, *this);
  }

  bool always_emits(Index v) const { return always_emits_[v]; }
  /// From now on v sends windows even if no path bends there.
  void set_always_emits(Index v) { always_emits_[v] = true; }

  Recorder& recorder() { return recorder_; }
  Crossing& crossing() { return crossing_; }

  bool is_empty() const { return queue_.empty(); }
  /// No waiting vertex has a smaller distance. One must wait.
  double first_key() { return queue_.first_key(); }

  /// Takes the next vertex, and all windows that then cross faces.
  void advance() {
    const Index v = pop();
    enter_faces_around(v);
    cross_entered_faces();
    follow_edges_from(v);
  }

  /// Takes the half-edges of entered faces on which windows wait.
  void cross_entered_faces() {
    faces_.cross_all([this](Index h) { cross(h); });
  }

  /// As EnteredFaces::take_landings.
  template <class Visit>
  void take_landings(Index first, const Visit& visit) {
    faces_.take_landings(first, visit);
  }

 private:
  Index pop() {
    const auto timed = recorder_.enter(Phase::queue);
    return queue_.pop();
  }

  void enter_faces_around(Index v) {
    {
      const auto timed = recorder_.enter(Phase::queue);
      for (const Index h : mesh_.outgoing(v)) faces_.enter(h / 3);
    }
    if (!may_bend_at(v)) return;
    for (const Index h : mesh_.outgoing(v)) emit_across(v, h);
  }

  bool may_bend_at(Index v) const { return always_emits_[v] || mesh_.is_pseudo_source(v); }

  /// Sends a window from v over the opposite edge of the face of h, unless a path along that edge
  /// already beats it: distances only decrease, so it is of no use later either.
  /// @param h a half-edge that leaves v
  void emit_across(Index v, Index h) {
    const Index opposite = Mesh::next(h), back = Mesh::previous(h);
    const EndpointBounds bounds(mesh_.half_edge(opposite).length, distances_[mesh_.head(h)],
                                distances_[mesh_.origin(back)]);
    const double at_origin = distances_[v] + mesh_.half_edge(h).length;
    const double at_head = distances_[v] + mesh_.half_edge(back).length;
    crossing_.emit_from_apex(!bounds.beat_whole(at_origin, at_head), opposite, *this);
  }

  void cross(Index h) {
    crossing_.cross(h, *this);
    recorder_.wavefront_size(crossing_.window_count());
  }

  /// Follows the edges of v: last, because windows that have arrived by then reach most of their
  /// ends by shorter paths.
  void follow_edges_from(Index v) {
    const bool emits = may_bend_at(v);
    mesh_.for_each_edge_at(v, [&](Index end, Index edge, Index facing) {
      const HalfEdge& apex_is_end = mesh_.half_edge(facing);
      const double at = apex_is_end.origin == v ? 0 : apex_is_end.length;
      follow_edge(v, end, mesh_.half_edge(edge).length, apex_is_end, emits, {facing, v, {at, 0}});
    });
  }

  /// Follows an edge from v to its other end.
  /// @param length of the edge
  /// @param apex_is_end a half-edge whose face has the edge, and whose apex is the other end
  /// @param emits whether v sends windows
  void follow_edge(Index v, Index end, double length, const HalfEdge& apex_is_end, bool emits,
                   const LastSegmentOf<Recorder>& last_segment) {
    const double distance = distances_[v] + length;
    if (!(distance < distances_[end])) return;
    if (bends_or_shortens(v, end, distance)) recorder_.arrived(end, last_segment);
    set_distance(end, distance);
    crossing_.follow_edge(v, end);
    if (emits && is_next_to_apex(apex_is_end, length)) always_emits_[end] = true;
  }

 public:
  // What a Crossing calls.

  /// Call when windows land on h; without effect if `has_landed` is false. They cross next if the
  /// face has been entered.
  void land(Index h, bool has_landed = true) {
    mesh_.prefetch_face(h);
    faces_.land(h, has_landed);
  }

  /// Records a straight line of this length to v.
  /// @param last_segment makes the LastSegment; called only if paths are recorded
  template <class MakeLastSegment>
  void improve(Index v, double distance, const MakeLastSegment& last_segment) {
    if (distance < distances_[v]) {
      if constexpr (Recorder::kRemembers) recorder_.arrived(v, last_segment());
      set_distance(v, distance);
    } else if constexpr (Recorder::kRemembers) {
      if (straightens_tie(v, distance)) recorder_.arrived(v, last_segment());
    }
  }

  /// Records a path to v that is shorter than all before.
  void set_distance(Index v, double distance) {
    const auto timed = recorder_.enter(Phase::queue);
    progress_.improved(distances_[v]);
    distances_[v] = distance;
    queue_.push_or_decrease(v, distance);
  }

 private:
  /// Ends a propagation that has come to `end`. The waiting vertices are farther, but waiting
  /// windows may be nearer, on long edges with farther ends. These are propagated until none is
  /// left; then no path shorter than `end` remains.
  ///
  /// All waiting windows are checked. A list waits if no vertex of the face beyond has been popped.
  /// It came through the face below, whose popped third vertex has reached both ends of the edge,
  /// or from a source in that face, which has done so: the ends are in the queue. A list is checked
  /// when an end is popped; windows that land later are checked when they land. None of this
  /// depends on the length of edges.
  /// @param end at least the greatest distance that the query needs
  [[gnu::cold, gnu::noinline]] void finish_up_to(double end) {
    // If a face has been entered, its windows wait in the FIFO. Other half-edges may enter the FIFO
    // twice; nothing waits on them the second time.
    const auto enqueue_nearer = [&](Index h) {
      if (faces_.has_entered(h)) return;
      bool nearer = false;
      crossing_.for_each_window(
          h, [&](const Window& w) { nearer = nearer || least_distance(w) <= end; });
      if (nearer) faces_.enqueue(h);
    };
    const auto enqueue_nearer_beyond = [&](Index h) {
      mesh_.for_each_sheet(h, [&](Index g) { enqueue_nearer(mesh_.twin(g)); });
    };
    while (!queue_.empty()) {
      const Index v = pop();
      if (distances_[v] <= end) {
        enter_faces_around(v);
        follow_edges_from(v);
      }
      for (const Index h : mesh_.outgoing(v)) {
        enqueue_nearer(h);
        enqueue_nearer(Mesh::previous(h));
        enqueue_nearer_beyond(Mesh::next(h));
      }
      faces_.cross_all([&](Index h) {
        cross(h);
        enqueue_nearer_beyond(Mesh::previous(h));
        enqueue_nearer_beyond(Mesh::next(h));
      });
    }
  }

  /// Whether a path along an edge is recorded. If no path bends at the edge's beginning, a straight
  /// line that is as short up to rounding arrives, and is kept.
  bool bends_or_shortens(Index from, Index end, double distance) const {
    return may_bend_at(from) || is_shorter(distance, distances_[end], crossing_.rounding());
  }

  /// Whether a later straight line that is as short up to rounding replaces a path that bends at a
  /// vertex where none does.
  bool straightens_tie(Index v, double distance) const {
    const Index root = recorder_.segments.last_segment(v).root;
    const bool bends = root < mesh_.vertex_count() && !may_bend_at(root);
    return bends && !is_shorter(distances_[v], distance, crossing_.rounding());
  }

  void sample() {
    recorder_.sample(progress_, [&](auto&& visit) {
      for (Index h = 0; h < mesh_.half_edge_count(); ++h) {
        crossing_.for_each_window(h, [&](const Window& w) { visit(h, w); });
      }
    });
  }

  const Mesh& mesh_;
  Crossing crossing_;
  Queue queue_;
  [[no_unique_address]] Recorder recorder_;
  [[no_unique_address]] typename Recorder::Progress progress_;
  std::span<double> distances_;
  EnteredFaces faces_;
  std::vector<bool> always_emits_;  // by vertex: true if it sends windows even where no path bends
};

}  // namespace geodesic::edge_based
