// The windows on all edges, and the queue of those that have not been propagated yet.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solvers/core/recording.h"
#include "solvers/core/tolerance.h"
#include "solvers/mmp/edge_lists.h"
#include "solvers/mmp/edge_window.h"
#include "solvers/mmp/overlay.h"

namespace geodesic::mmp {

/// An entry of the queue, kept out of the stored windows. Windows move within their list, so the
/// entry names one by a position instead of an address: where it is nearest, rounded. An entry
/// whose window has been deleted, or re-inserted elsewhere, is stale and names none; every window
/// that waits has an entry of its own.
struct QueueItem {
  Index id;  ///< edge, or vertex
  float at;  ///< position on the edge; negative for a pseudo-source vertex
};

/// @tparam Queue of QueueItem (core/queues)
template <class Queue, class Recorder>
class Wavefront {
 public:
  using Depth = typename Recorder::Depth;

  struct Taken {
    Window window;  ///< in the frame of the edge's own half-edge; y > 0: it enters the twin's face
    Depth depth;
  };

  Wavefront(Index half_edges, Queue queue) : lists_(half_edges), queue_(std::move(queue)) {}

  /// Forgets everything. @param recorder must outlive the solve
  void start(double limit, Recorder& recorder) {
    lists_.clear();
    queue_.clear();
    tally_ = {};
    // A window whose key exceeds the limit by rounding may reach a vertex that lies on it.
    limit_ = limit * (1 + kPathMargin);
    recorder_ = &recorder;
  }

  bool empty() const { return queue_.empty(); }
  QueueItem pop() {
    const auto timed = recorder_->enter(Phase::queue);
    return queue_.pop();
  }

  void push_vertex(Index v, double distance) {
    if (distance <= limit_) push(distance, {v, -1.0f});
  }

  /// The window that an entry names, which does not wait any longer; none when the entry is stale.
  std::optional<Taken> take(QueueItem item, double length) {
    const auto timed = recorder_->enter(Phase::queue);
    const std::span<W> list = lists_.windows(item.id);
    const std::size_t i = find(list, length, item.at);
    if (i == list.size()) return std::nullopt;
    list[i].set_waits(false);
    const Taken taken{list[i].geometry(end_of(list, i, length)), list[i].depth};
    tally(taken.window, Change::leaves);
    return taken;
  }

  /// Lays a window over those of its edge and queues the parts that it wins.
  /// @param w in the frame of the edge's own half-edge
  /// @param goes_on whether there is a face beyond
  void lay(Index edge, double length, const Window& w, Depth depth, bool goes_on) {
    const auto timed = recorder_->enter(Phase::trimming);
    if (lists_.windows(edge).empty()) {
      const W gap = W::gap(0);
      lists_.replace(edge, 0, 0, {&gap, 1});
    }
    const std::span<const W> list = lists_.windows(edge);
    if (!overlay(list, length, w, overlay_)) return;
    replacement_.clear();
    for (std::size_t k = 0; k < overlay_.pieces.size(); ++k) {
      const Piece<W>& piece = overlay_.pieces[k];
      if (piece.owner == nullptr) {
        replacement_.push_back({piece.begin, w.x, w.y, w.sigma, depth});
        accept(edge, replacement_.back(), overlay_.piece_end(k), goes_on);
      } else {
        replacement_.push_back(*piece.owner);
        replacement_.back().begin = piece.begin;
        if (piece.owner->waits()) keep_queued(edge, list, length, k);
      }
    }
    tally(list.subspan(overlay_.first, overlay_.last - overlay_.first), Change::leaves);
    tally(replacement_, Change::joins);
    recorder_->wavefront_size(tally_.windows);
    lists_.replace(edge, overlay_.first, overlay_.last, replacement_);
  }

  /// Hands the spread of the waiting windows' distances to the recorder.
  void sample() { recorder_->wavefront_sample(tally_.sum, tally_.squares, tally_.windows); }

  /// Windows on all edges.
  std::uint64_t windows_left() {
    std::uint64_t left = 0;
    for (Index edge = 0; edge < lists_.edge_bound(); ++edge) {
      for (const W& w : lists_.windows(edge)) left += w.is_gap() ? 0u : 1u;
    }
    return left;
  }

 private:
  using W = EdgeWindow<Depth>;

  /// The windows that wait, kept count of in recorded solves only.
  struct Tally {
    std::uint64_t windows = 0;
    double sum = 0, squares = 0;  // of their distances
  };
  enum class Change { joins, leaves };

  static float queue_position(const Window& w) { return static_cast<float>(nearest_position(w)); }

  /// Index in the list, or the list's size when the entry is stale.
  static std::size_t find(std::span<const W> list, double length, float at) {
    // Rounding is monotone: windows whose rounded ends enclose the position are neighbours.
    const auto begins_before = [&](const W& w) { return static_cast<float>(w.begin) <= at; };
    for (std::size_t i = window_at(list, begins_before) + 1; i-- > 0;) {
      const double end = end_of(list, i, length);
      if (static_cast<float>(end) < at) break;
      if (list[i].waits() && queue_position(list[i].geometry(end)) == at) return i;
    }
    return list.size();
  }

  void push(double key, QueueItem item) {
    const auto timed = recorder_->enter(Phase::queue);
    queue_.push(key, item);
  }

  /// Queues a part that the challenger won.
  void accept(Index edge, W& stored, double end, bool goes_on) {
    recorder_->valid(1);
    const Window part = stored.geometry(end);
    const double key = least_distance(part);
    if (!goes_on || key > limit_) return;
    stored.set_waits(true);
    push(key, {edge, queue_position(part)});
  }

  /// Re-inserts piece k, a part of a window that waits, when it has lost the point by which its
  /// entry names it, or when an earlier piece of the same window keeps that entry.
  void keep_queued(Index edge, std::span<const W> list, double length, std::size_t k) {
    const W* owner = overlay_.pieces[k].owner;
    const std::size_t i = static_cast<std::size_t>(owner - list.data());
    const Window whole = owner->geometry(end_of(list, i, length));
    const Window part = replacement_.back().geometry(overlay_.piece_end(k));
    const bool second = k >= 2 && overlay_.pieces[k - 2].owner == owner;
    if (!second && queue_position(part) == queue_position(whole)) return;
    recorder_->reinserted(1);
    push(least_distance(part), {edge, queue_position(part)});
  }

  void tally(const Window& w, Change change) {
    if constexpr (Recorder::kRecords) {
      const double distance = least_distance(w);
      const double sign = change == Change::joins ? 1 : -1;
      tally_.windows += change == Change::joins ? 1 : std::uint64_t(-1);
      tally_.sum += sign * distance;
      tally_.squares += sign * distance * distance;
    }
  }

  /// As above for the waiting ones of consecutive windows that end where the overlay does.
  void tally(std::span<const W> windows, Change change) {
    if constexpr (Recorder::kRecords) {
      for (std::size_t i = 0; i < windows.size(); ++i) {
        if (!windows[i].waits()) continue;
        tally(windows[i].geometry(end_of(windows, i, overlay_.end)), change);
      }
    }
  }

  EdgeLists<W> lists_;
  Queue queue_;
  double limit_ = kInfinity;
  Recorder* recorder_ = nullptr;
  Tally tally_;
  Overlay<W> overlay_;          // scratch of lay
  std::vector<W> replacement_;  // scratch of lay
};

}  // namespace geodesic::mmp
