// The windows on all edges, and the queue of those that are not propagated yet.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solvers/core/pool.h"
#include "solvers/core/prefetch.h"
#include "solvers/core/queues/concepts.h"
#include "solvers/core/recorders.h"
#include "solvers/core/tolerance.h"
#include "solvers/mmp/edge_lists.h"
#include "solvers/mmp/edge_window.h"
#include "solvers/mmp/overlay.h"

namespace geodesic::mmp {

/// @tparam Queue queue of event numbers
template <class Queue, class Recorder>
class Wavefront {
  static_assert(WindowQueueByKey<Queue>,
                "the policy's Queue lacks a member of WindowQueueByKey (core/queues/concepts.h)");

 public:
  using Depth = typename Recorder::Depth;

  /// A pseudo-source or window from the queue.
  struct Taken {
    Index vertex = kNone;  ///< a pseudo-source; kNone for a window
    Index edge = kNone;    ///< the list of the window, which is in the frame of that half-edge
    Window window = {};    ///< y > 0: it enters the twin's face
    Index source = kNone;
    Depth depth = {};
  };

  /// @param recorder must outlive this
  Wavefront(Index half_edges, Queue queue, Recorder& recorder)
      : lists_(half_edges), queue_(std::move(queue)), recorder_(recorder) {}

  /// Clears all state.
  void start(double limit) {
    lists_.clear();
    open_lists_.clear();
    windows_released_ = {};
    queue_.clear();
    events_.clear();
    pipeline_.clear();
    sigmas_.clear();
    waiting_ = {};
    // A window whose key exceeds the limit by rounding may reach a vertex that lies on it.
    limit_ = limit * (1 + kPathMargin);
  }

  bool empty() const { return queue_.empty(); }

  /// As the queue's functions, until the next start.
  void keep_sorted() { geodesic::keep_sorted(queue_); }
  double least_key() const { return queue_.least_key(); }

  void push_vertex(Index v, double distance) {
    if (distance > limit_) return;
    push(distance, events_.add({Event::kVertex, 0, v, 0, false}));
  }

  /// Adds a pseudo-source, for its windows. @return its number
  Index add_source(double sigma) {
    sigmas_.push_back(sigma);
    return static_cast<Index>(sigmas_.size() - 1);
  }

  /// Takes the next pseudo-source or window, which then no longer waits. Returns nothing if it has
  /// been cancelled or is queued again. The wavefront must not be empty.
  std::optional<Taken> take(const Mesh& mesh) {
    const auto timed = recorder_.enter(Phase::queue);
    const Index number = queue_.pop();
    prefetch_ahead(mesh);
    const Event event = events_[number];
    if (!event.is_window()) {
      events_.release(number);
      if (event.is_cancelled()) return std::nullopt;
      return Taken{.vertex = event.id};
    }
    const double length = mesh.half_edge(event.id).length;
    const std::span<W> list = lists_.windows(event.id);
    const std::size_t i = find(list, event);
    W& w = list[i];
    const Window window = w.geometry(end_of(list, i, length), sigmas_[w.source]);
    if (event.outdated && postpone(number, window)) return std::nullopt;
    events_.release(number);
    w.event = kNone;
    if constexpr (Recorder::kRecords) --waiting_;
    return Taken{.edge = event.id, .window = window, .source = w.source, .depth = w.depth};
  }

  /// Inserts a window among those of its list and queues the parts that it wins.
  /// @param edge the half-edge that names the list; w is in its frame
  /// @param source number of the source of w
  /// @param goes_on whether there is a face beyond the edge
  void insert(Index edge, double length, const Window& w, Index source, Depth depth, bool goes_on) {
    const auto timed = recorder_.enter(Phase::trimming);
    if (lists_.windows(edge).empty()) {
      if (lists_.is_closed(edge)) return;
      const W gap = W::gap(0);
      lists_.replace(edge, 0, 0, {&gap, 1});
      open_lists_.add(edge);
    }
    const std::span<const W> list = lists_.windows(edge);
    const W challenger{w.begin, w.x, w.y, source, kNoEventYet, depth};
    if (!overlay(list, length, challenger, w.end, std::span<const double>(sigmas_), overlay_)) {
      return;
    }
    const std::span<const W> replaced =
        list.subspan(overlay_.first, overlay_.last - overlay_.first);
    if constexpr (Recorder::kRecords) waiting_ -= count_waiting(replaced);
    // Cancelled until one of the pieces takes the event over.
    for (const W& old : replaced) {
      if (old.waits()) events_[old.event].id = kNone;
    }
    const std::span<W> pieces = overlay_.pieces();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      W& piece = pieces[k];
      if (!piece.waits()) continue;
      const double end = overlay_.piece_end(k);
      const auto index = static_cast<Index>(overlay_.first + k);
      if (piece.event == kNoEventYet) {
        accept(edge, index, piece, end, w.sigma, goes_on);
      } else {
        keep_queued(edge, index, piece, end);
      }
    }
    if constexpr (Recorder::kRecords) {
      waiting_ += count_waiting(pieces);
      recorder_.wavefront_size(waiting_);
    }
    lists_.replace(edge, overlay_.first, overlay_.last, pieces);
  }

  /// From time to time closes the lists that the wavefront has passed, and frees their memory. All
  /// paths found from now on are at least as long as the least key in the queue. Every point of an
  /// edge is at least as near as the paths along the edge from its ends. If those are shorter, no
  /// later window carries a shortest path, and the list would reject it.
  /// @param distances of vertices: lengths of existing paths
  void release_passed(const Mesh& mesh, std::span<const double> distances) {
    if (!open_lists_.is_due()) return;
    const double to_come = queue_.least_key() * (1 - kPassedMargin);
    open_lists_.look_through([&](Index edge) {
      const double length = mesh.half_edge(edge).length;
      const double at_origin = distances[mesh.origin(edge)], at_head = distances[mesh.head(edge)];
      const double farthest =
          std::min(0.5 * (at_origin + at_head + length), std::min(at_origin, at_head) + length);
      if (!(farthest < to_come)) return false;
      const std::span<const W> list = lists_.windows(edge);
      if (!std::all_of(list.begin(), list.end(), is_propagated)) return false;
      if constexpr (Recorder::kRecords) windows_released_ += list.size();
      lists_.close(edge);
      return true;
    });
  }

  /// Passes the waiting windows to the recorder.
  void sample(const Mesh& mesh, const Progress& progress) {
    recorder_.sample(progress, [&](auto&& visit) {
      for (Index edge = 0; edge < lists_.edge_bound(); ++edge) {
        const std::span<const W> list = lists_.windows(edge);
        for (std::size_t i = 0; i < list.size(); ++i) {
          if (!list[i].waits()) continue;
          const double end = end_of(list, i, mesh.half_edge(edge).length);
          visit(edge, list[i].geometry(end, sigmas_[list[i].source]));
        }
      }
    });
  }

  /// Copies the windows of a list.
  void copy_windows(Index edge, double length, std::vector<Window>& windows) const {
    windows.clear();
    const std::span<const W> list = lists_.windows(edge);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].is_gap()) continue;
      windows.push_back(list[i].geometry(end_of(list, i, length), sigmas_[list[i].source]));
    }
  }

  /// Number of windows on all edges, including closed lists. For recorded solves only.
  std::uint64_t windows_left() const {
    std::uint64_t left = windows_released_;
    for (Index edge = 0; edge < lists_.edge_bound(); ++edge) {
      for (const W& w : lists_.windows(edge)) left += w.is_gap() ? 0u : 1u;
    }
    return left;
  }

 private:
  using W = EdgeWindow<Depth>;

  /// Starts to load what the next takes will read, in stages. The addresses for each stage are in
  /// the data of the stage before: event, list, window and faces, its sigma and the lists into
  /// which its children are inserted.
  void prefetch_ahead(const Mesh& mesh) {
    pipeline_.advance(upcoming(queue_));
    if (pipeline_[0] != kNone) events_.prefetch(pipeline_[0]);
    if (const Event* event = upcoming_event(1)) {
      mesh.prefetch_face(event->id);
      lists_.prefetch_list(event->id);
    }
    if (const Event* event = upcoming_event(2)) {
      prefetch(likely_window(*event));
      mesh.prefetch_face(mesh.twin(event->id));
    }
    if (const Event* event = upcoming_event(3)) {
      if (const W* w = likely_window(*event)) {
        prefetch(sigmas_.data() + w->source);
        for_each_target(mesh, event->id, *w, [&](Index edge) { lists_.prefetch_list(edge); });
      }
    }
    if (const Event* event = upcoming_event(4)) {
      if (const W* w = likely_window(*event)) {
        for_each_target(mesh, event->id, *w, [&](Index edge) { lists_.prefetch_windows(edge); });
      }
    }
  }

  /// The event of a window at a stage of prefetch_ahead; null when there is none.
  const Event* upcoming_event(std::size_t stage) {
    const Index number = pipeline_[stage];
    return number == kNone || !events_[number].is_window() ? nullptr : &events_[number];
  }

  /// The window of an event or, since lists change, one near it; null when the list has meanwhile
  /// been closed.
  const W* likely_window(const Event& event) const {
    const std::span<const W> list = lists_.windows(event.id);
    return list.empty() ? nullptr : &list[event.likely_index(list.size())];
  }

  /// Calls visit(edge) for the two edges into which the children of a window, given with its list,
  /// will be inserted.
  template <class Visit>
  void for_each_target(const Mesh& mesh, Index edge, const W& w, Visit&& visit) {
    const Index into = w.y < 0 ? edge : mesh.twin(edge);
    if (into == kNone) return;
    for (const Index h : {Mesh::next(into), Mesh::previous(into)}) {
      visit(list_of(h, mesh.twin(h)));
    }
  }

  /// Index of the window of an event in its list.
  static std::size_t find(std::span<const W> list, const Event& event) {
    std::size_t i = event.likely_index(list.size());
    while (list[i].begin > event.begin) --i;
    while (list[i].begin < event.begin) ++i;
    return i;
  }

  /// Queues a window again if its key has grown, unless it is due by the new key too.
  bool postpone(Index number, const Window& window) {
    const double key = least_distance(window);
    if (queue_.is_due(key)) return false;
    events_[number].outdated = false;
    queue_.push(key, number);
    return true;
  }

  void push(double key, Index event) {
    const auto timed = recorder_.enter(Phase::queue);
    queue_.push(key, event);
  }

  /// Queues a part that the challenger has won.
  void accept(Index edge, Index index, W& piece, double end, double sigma, bool goes_on) {
    recorder_.valid(1);
    piece.event = kNone;
    const Window part = piece.geometry(end, sigma);
    const double key = least_distance(part);
    if (!goes_on || key > limit_) return;
    piece.event = events_.add({piece.begin, nearest_position(part), edge, index, false});
    push(key, piece.event);
  }

  /// The first piece of a waiting window keeps its event; other pieces are queued separately. A
  /// piece with another nearest point counts as re-inserted now, though its entry stays.
  void keep_queued(Index edge, Index index, W& piece, double end) {
    const Window part = piece.geometry(end, sigmas_[piece.source]);
    const double nearest = nearest_position(part);
    Event& event = events_[piece.event];
    if (!event.is_cancelled()) {
      recorder_.reinserted(1);
      piece.event = events_.add({piece.begin, nearest, edge, index, false});
      push(least_distance(part), piece.event);
      return;
    }
    const bool moved = nearest != event.nearest;
    if (moved) recorder_.reinserted(1);
    event = {piece.begin, nearest, edge, index, event.outdated || moved};
  }

  static std::uint64_t count_waiting(std::span<const W> windows) {
    return static_cast<std::uint64_t>(
        std::count_if(windows.begin(), windows.end(), [](const W& w) { return w.waits(); }));
  }

  // Also false for slivers left by rounding.
  static bool is_propagated(const W& w) { return !w.waits() && !w.is_gap(); }

  EdgeLists<W> lists_;
  OpenLists open_lists_;
  Queue queue_;
  Pool<Event> events_;
  PrefetchPipeline<5> pipeline_;  // events in the stages of prefetch_ahead
  std::vector<double> sigmas_;    // by number of source
  double limit_ = kInfinity;
  Recorder& recorder_;
  [[no_unique_address]] typename Recorder::Count waiting_{};           // windows that wait
  [[no_unique_address]] typename Recorder::Count windows_released_{};  // of closed lists
  Overlay<W> overlay_;                                                 // scratch memory of insert
};

}  // namespace geodesic::mmp
