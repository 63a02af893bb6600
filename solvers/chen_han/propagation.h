// Chen and Han's propagation of single windows; order and filter are policies.
//
// Chen and Han 1990, "Shortest paths on a polyhedron" (CH); Xin and Wang 2009, "Improving Chen and
// Han's algorithm on the discrete geodesic problem" (ICH); Xu, Wang, Liu, Liu, He 2015, "Fast
// wavefront propagation" (FWP-CH).
//
// Only waiting windows are stored. A window from the queue gives a distance to the apex of the face
// beyond its edge, if its lines reach it, and has one child or two (corners.h). Useless children
// are dropped before they are queued (filter.h). Pseudo-sources wait in the same queue: if their
// distance improves meanwhile, they send out windows only once. If the distance of a pseudo-source
// improves later, it sends out windows again, and its former windows are dropped; their sigma
// identifies them.
//
// A source on an edge or in a face is a root without a vertex. Before the loop it gives the corners
// of its face their distances, and its windows cross the first faces beyond. They skip the filter:
// its third test requires that a window entered the face that it leaves.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "solvers/chen_han/corners.h"
#include "solvers/chen_han/filter.h"
#include "solvers/chen_han/shadow.h"
#include "solvers/core/pool.h"
#include "solvers/core/prefetch.h"
#include "solvers/core/queues/concepts.h"
#include "solvers/core/recorders.h"
#include "solvers/core/solver.h"
#include "solvers/core/tolerance.h"
#include "solvers/core/window_bound.h"
#include "solvers/core/window_predicates.h"

namespace geodesic::chen_han {

/// A window that waits to be propagated across the face of `half_edge`. With an empty interval it
/// is the pseudo-source `root` itself, which waits to send out windows; its path then arrived at
/// the corner `half_edge` from the direction (x, y) (shadow.h).
template <class Depth>
struct StoredWindow : Window {
  Index half_edge;
  Index root;                         ///< as in LastSegment (core/recording.h)
  [[no_unique_address]] Depth depth;  ///< faces crossed since the pseudo-source

  bool is_pseudo_source() const { return !(end > begin); }
};

/// Strip lengths in windows. Solvers without a filter always store them, since nothing else ends a
/// solve on some meshes.
template <class Policy, class Recorder>
using DepthOf = std::conditional_t<Policy::Filter::kFilters, typename Recorder::Depth, StripDepth>;

/// The state of a solver's solves, reused by each.
/// @tparam Policy as in chen_han.h
/// @tparam Depth NoDepth or StripDepth; with StripDepth, windows with too long strips are dropped
template <class Policy, class Depth, class Recorder>
class Propagation {
  static_assert(WindowQueue<typename Policy::Queue>,
                "the policy's Queue lacks a member of WindowQueue (core/queues/concepts.h)");

 public:
  Propagation(const Mesh& mesh, typename Policy::Queue queue, Recorder recorder = {})
      : mesh_(mesh),
        recorder_(recorder),
        vertex_count_(mesh.vertex_count()),
        budget_(mesh),
        queue_(std::move(queue)),
        corners_(mesh.half_edge_count()),
        unreliable_(find_unreliable_vertices(mesh)) {}

  void run(const Start& start, std::span<double> distances) {
    const auto timed = recorder_.enter(Phase::propagation);
    begin(start, distances);
    std::span<const StartWindow> windows = start.windows;
    if constexpr (!kOneByOne) begin_across(windows);
    propagate_all();
    while (kOneByOne && !windows.empty()) {
      const Index root = windows.front().root;
      const auto next =
          std::ranges::find_if(windows, [&](const StartWindow& each) { return each.root != root; });
      corners_.clear();
      budget_.start();
      begin_across({windows.begin(), next});
      propagate_all();
      windows = {next, windows.end()};
    }
    if (distances_.size() > distances.size()) {
      std::copy_n(distances_.begin(), distances.size(), distances.begin());
    }
  }

 private:
  using Filter = typename Policy::Filter;
  using Stored = StoredWindow<Depth>;
  using LastSegment = LastSegmentOf<Recorder>;

  /// One angle, one split (corners.h) presupposes that a source parts the windows that pass it; a
  /// source that is not a vertex does not. Its windows therefore own no corner. Without a filter,
  /// only owners bound the work: such sources then start one after the other.
  static constexpr bool kOneByOne = !Filter::kFilters;

  void propagate_all() {
    while (!queue_.empty()) {
      if (stops_ && is_over()) [[unlikely]] {
        break;
      }
      const Stored w = pop();
      budget_.spend(1);
      prefetch_ahead();
      if (w.is_pseudo_source()) {
        if (!is_outdated(w)) emit(w.root, {w.half_edge, w.x, w.y});
      } else {
        --waiting_;
        if (!is_outdated(w) && !is_too_long(w)) propagate(w);
      }
      if (progress_.made_step()) sample();
    }
  }

  Stored pop() {
    const auto timed = recorder_.enter(Phase::queue);
    return pool_.take(queue_.pop());
  }

  void push(double key, const Stored& w) {
    const auto timed = recorder_.enter(Phase::queue);
    queue_.push(key, pool_.add(w));
  }

  void begin(const Start& start, std::span<double> distances) {
    distances_ = distances;
    if (!start.windows.empty()) make_room_for_roots(start.query);
    limit_ = start.query.limit;
    stops_ = start.query.stop_at_targets;
    stop_rule_ = StopRule(mesh_, start.query, distances_);
    budget_.start();
    pool_.clear();
    queue_.clear();
    if (stops_) keep_sorted(queue_);
    pipeline_.clear();
    corners_.clear();
    progress_.start(mesh_, start);
    for (const auto& [v, distance, always_emits, last] : start.vertices) {
      if (always_emits) {
        start_at(v, distance, last);
      } else {
        const Index h = last.half_edge;
        improve_apex(h, face_frame(mesh_, h), distance, last.from, last);
      }
    }
  }

  /// Makes v send windows in all directions.
  void start_at(Index v, double distance, LastSegment last_segment) {
    if (!(distance < distances_[v])) return;
    set_distance(v, distance);
    recorder_.arrived(v, last_segment);
    wait_to_emit(v, {});
  }

  /// Gives each root that is not a vertex an entry behind the distances of vertices, so that code
  /// need not distinguish the two.
  [[gnu::cold, gnu::noinline]] void make_room_for_roots(const InternalQuery& query) {
    with_roots_.assign(mesh_.vertex_count(), kInfinity);
    for (const InternalSource& source : query.sources) with_roots_.push_back(source.distance);
    distances_ = with_roots_;
  }

  [[gnu::cold, gnu::noinline]] void begin_across(std::span<const StartWindow> windows) {
    for (const auto& [side, window, root] : windows) {
      const HalfEdge& e = mesh_.half_edge(side);
      if (e.twin == kNone || !(e.length > 0)) continue;
      const Stored w{window, e.twin, root, {}};
      // As least_distance: one more call of it would prevent the inlining of the frequent ones.
      if (distance_at(w, nearest_position(w)) > limit_) continue;
      recorder_.created(1);
      recorder_.valid(1);
      budget_.spend(1);
      propagate(w);
    }
  }

  /// True when no more distances can change. A queue without a least key simply runs empty: nothing
  /// is pushed that is farther than the farthest target can be.
  [[gnu::noinline]] bool is_over() {
    if constexpr (requires { queue_.least_key(); }) return stop_rule_.is_over(queue_.least_key());
    limit_ = stop_rule_.farthest();
    return false;
  }

  /// Starts to load the data of upcoming windows: the window, then the face it enters, then
  /// distances.
  void prefetch_ahead() {
    pipeline_.advance(upcoming(queue_));
    if (pipeline_[0] != kNone) {
      const auto* w = reinterpret_cast<const char*>(&pool_[pipeline_[0]]);
      prefetch(w);
      prefetch(w + sizeof(Stored) - 1);
    }
    if (const Stored* w = upcoming_window(1)) {
      mesh_.prefetch_face(w->half_edge);
      corners_.prefetch(w->half_edge);
      prefetch(&distances_[w->root]);
    }
    if (const Stored* w = upcoming_window(2)) {
      prefetch(&distances_[mesh_.origin(w->half_edge)]);
      prefetch(&distances_[mesh_.head(w->half_edge)]);
      prefetch(&distances_[mesh_.apex(w->half_edge)]);
    }
  }

  /// The window at a stage of prefetch_ahead; null when there is none.
  const Stored* upcoming_window(std::size_t stage) const {
    const Index slot = pipeline_[stage];
    return slot == kNone || pool_[slot].is_pseudo_source() ? nullptr : &pool_[slot];
  }

  void set_distance(Index v, double distance) {
    progress_.improved(distances_[v]);
    distances_[v] = distance;
  }

  void improve(Index v, double distance, const Incoming& incoming, LastSegment last_segment) {
    if (!(distance < distances_[v])) return;
    set_distance(v, distance);
    recorder_.arrived(v, last_segment);
    if (mesh_.is_pseudo_source(v)) wait_to_emit(v, incoming);
  }

  /// Reaches the apex of h along an edge from a vertex that emits.
  void improve_neighbour(Index h, double distance, double edge, const Incoming& incoming,
                         LastSegment last_segment) {
    if (!(distance + edge < distances_[mesh_.apex(h)])) return;
    if (is_next_to_apex(mesh_.half_edge(h), edge)) {
      start_at(mesh_.apex(h), distance + edge, last_segment);
    } else {
      improve(mesh_.apex(h), distance + edge, incoming, last_segment);
    }
  }

  void wait_to_emit(Index v, const Incoming& incoming) {
    const double distance = distances_[v];
    if (distance > limit_) return;
    Stored w{};
    w.x = incoming.x;
    w.y = incoming.y;
    w.sigma = distance;
    w.half_edge = incoming.corner;
    w.root = v;
    push(distance, w);
  }

  /// True when the pseudo-source has come nearer since the window was created.
  bool is_outdated(const Stored& w) const { return w.sigma > distances_[w.root]; }

  /// Reaches the neighbours of v along the edges and sends windows into its shadow.
  void emit(Index v, const Incoming& incoming) {
    const double distance = distances_[v];
    for (const Index h : mesh_.outgoing(v)) {
      const Index opposite = Mesh::next(h), into = Mesh::previous(h);
      const HalfEdge& at_head = mesh_.half_edge(opposite);
      const double out = mesh_.half_edge(h).length, in = mesh_.half_edge(into).length;
      improve_neighbour(into, distance, out, {opposite, at_head.apex_x, at_head.apex_y},
                        {into, v, {in, 0}});
      improve_neighbour(h, distance, in, {into, in, 0}, {h, v, {0, 0}});
    }
    find_shadow(mesh_, v, unreliable_[v] ? Incoming{} : incoming, shadow_);
    for (const ShadowedEdge& edge : shadow_) {
      const Stored parent{{}, kNone, v, {}};
      const Point2 source = apex_from_beyond(mesh_.half_edge(edge.across));
      const Window child{edge.begin, edge.end, source.x, source.y, distance};
      offer(parent, edge.across, child, Entry::at_origin, source, v);
    }
  }

  void propagate(const Stored& w) {
    recorder_.propagated(1, w.depth.next());
    const Index h = w.half_edge;
    recorder_.crosses(h, w, w.root);
    const Index to_left = Mesh::previous(h), to_right = Mesh::next(h);
    const FaceFrame face = face_frame(mesh_, h);
    const WindowSight sight(w, {face.apex_x, face.apex_y});
    Sides to = sight.sides();
    if (to.left && to.right) {
      const double distance = distance_through(w, face.apex_x, face.apex_y);
      improve_apex(h, face, distance, {w.x, w.y}, {h, w.root, {w.x, w.y}});
      if (has_owner(h, w.root)) {
        const auto timed = recorder_.enter(Phase::trimming);
        to = corners_.claim(h, w, distance, apex_line_position(w, face),
                            kApexTolerance * face.length);
      }
    } else if (sight.reaches()) {
      const double bend = sight.left() ? w.end : w.begin;  // the apex lies beyond this end
      // Up to rounding, a way over a vertex right next to the apex is as short as the line beside
      // it, but arrives from elsewhere: the apex then emits in all directions.
      improve(mesh_.apex(h), distance_over(w, bend, face.apex_x, face.apex_y), {},
              {h, w.root, {w.x, w.y}});
    }
    if (to.left) {
      offer(w, to_left, face.left_child(w, sight.right()), Entry::at_origin,
            face.to_left(face.length, 0), mesh_.origin(to_right));
    }
    if (to.right) {
      offer(w, to_right, face.right_child(w, sight.left()), Entry::at_head, face.to_right(0, 0),
            mesh_.origin(h));
    }
  }

  /// False for a corner with unreliable claims, and for roots that are not vertices. Always true
  /// without a filter, since only claims then bound the work.
  bool has_owner(Index h, Index root) const {
    if constexpr (!Filter::kFilters) return true;
    return root < vertex_count_ && !(unreliable_[mesh_.origin(h)] | unreliable_[mesh_.head(h)] |
                                     unreliable_[mesh_.apex(h)]);
  }

  /// @param from a point of the path's last segment, in the frame of h
  void improve_apex(Index h, const FaceFrame& face, double distance, const Point2& from,
                    LastSegment last_segment) {
    const double dx = from.x - face.apex_x, dy = from.y - face.apex_y;
    // The half-edge that leaves the apex points against (left_x, left_y).
    improve(mesh_.apex(h), distance,
            {Mesh::previous(h), -dx * face.left_x - dy * face.left_y,
             dx * face.left_y - dy * face.left_x},
            last_segment);
  }

  /// Queues a child of `parent` that leaves a face through the half-edge `across`, unless it is
  /// useless. The child and `third` are in the frame of the twin of `across`.
  /// @param third, third_vertex the vertex of the face opposite to `across`
  void offer(const Stored& parent, Index across, const Window& child, Entry entry,
             const Point2& third, Index third_vertex) {
    const HalfEdge& e = mesh_.half_edge(across);
    if (e.twin == kNone || is_void(child, e.length)) return;
    recorder_.created(1);
    const Stored w{child, e.twin, parent.root, parent.depth.next()};
    if constexpr (Filter::kFilters) {
      const auto timed = recorder_.enter(Phase::trimming);
      if (Filter::is_useless(w, entry, passed_face(across, third, third_vertex))) return;
    }
    const double key = least_distance(w);
    if (key > limit_) return;
    push(key, w);
    recorder_.valid(1);
    recorder_.wavefront_size(++waiting_);
  }

  PassedFace passed_face(Index across, const Point2& third, Index third_vertex) const {
    const HalfEdge& e = mesh_.half_edge(across);
    return {.third_x = third.x,
            .third_y = third.y,
            .at_third = distances_[third_vertex],
            .ends = {e.length, distances_[mesh_.head(across)], distances_[e.origin]}};
  }

  bool is_too_long(const Stored& w) const {
    if constexpr (std::is_same_v<Depth, StripDepth>) {
      return is_strip_too_long(mesh_.face_count(), w.depth.faces + std::uint64_t{1});
    } else {
      return false;
    }
  }

  void sample() {
    recorder_.sample(progress_, [&](auto&& visit) {
      pool_.for_each([&](const Stored& w) {
        if (!w.is_pseudo_source()) visit(w.half_edge, w);
      });
    });
  }

  const Mesh& mesh_;
  [[no_unique_address]] Recorder recorder_;
  Index vertex_count_;
  WindowBudget budget_;
  typename Policy::Queue queue_;  // of slots in pool_
  Pool<Stored> pool_;
  Corners corners_;
  std::vector<std::uint8_t> unreliable_;  // result of find_unreliable_vertices
  std::vector<ShadowedEdge> shadow_;      // scratch memory
  std::span<double> distances_;           // by root
  std::vector<double> with_roots_;        // storage of distances_ if some roots are not vertices
  double limit_ = kInfinity;
  StopRule stop_rule_;
  bool stops_ = false;            // the query stops at targets
  PrefetchPipeline<3> pipeline_;  // slots in the stages of prefetch_ahead
  [[no_unique_address]] typename Recorder::Count waiting_{};  // windows in the queue
  [[no_unique_address]] typename Recorder::Progress progress_;
};

}  // namespace geodesic::chen_han
