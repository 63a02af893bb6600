// The windows on all edges, and the queue of those that are not propagated yet.
//
// A new window is laid over those of its edge: each part goes to the window that is shorter there
// (MMP's trimming: Surazhsky et al. 2005, section 3.3). Parts narrower than kWindowWidth of the
// edge are never made: they stay with the window from which they would be cut.
//
// The queue holds numbers of windows only, and is never searched. A waiting window that loses
// everything stays in the pool as a dead one until its turn comes. When its key grows, it is queued
// by the new key when its turn by the old one comes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
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
#include "solvers/mmp/intersect.h"

namespace geodesic::mmp {

/// @tparam Queue queue of numbers of windows
template <class Queue, class Recorder>
class WindowsOfEdges {
  static_assert(WindowQueueByKey<Queue>,
                "the policy's Queue lacks a member of WindowQueueByKey (core/queues/concepts.h)");

 public:
  using Origin = WindowOrigin<Recorder>;
  using W = EdgeWindow<Origin>;

  /// @param recorder must outlive this
  WindowsOfEdges(Index half_edges, Queue queue, Recorder& recorder)
      : lists_(half_edges), queue_(std::move(queue)), recorder_(recorder) {
    start(kInfinity);
  }

  /// Clears all state.
  void start(double limit) {
    lists_.clear();
    open_lists_.clear();
    windows_released_ = {};
    queue_.clear();
    windows_.clear();
    windows_.add({{0, 0, 0, 1, kGapSigma}, kNone, State::gap, {}});
    pipeline_.clear();
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
    push(distance, windows_.add({{}, v, State::vertex, {}}));
  }

  /// Takes the next window or pseudo-source. One that waits is to be propagated now; one in
  /// another state, a vertex excepted, has been dealt with. The queue must not be empty.
  W take(const Mesh& mesh) {
    const auto timed = recorder_.enter(Phase::queue);
    const Index number = queue_.pop();
    prefetch_ahead(mesh);
    W w = windows_[number];
    if (w.state == State::outdated) {
      const double key = least_distance(w);
      if (!queue_.is_due(key)) {
        windows_[number].state = State::waits;
        queue_.push(key, number);
        return w;
      }
      w.state = State::waits;
    }
    if (w.state == State::waits) {
      windows_[number].state = State::done;
      --waiting_;
    } else {
      windows_.release(number);
    }
    return w;
  }

  /// Lays a window over those of its list and queues the parts that it wins. Which pieces there are
  /// is hard to predict, so most of this has no branches.
  /// @param edge the half-edge that names the list; w is in its frame and waits
  [[gnu::noinline]] void insert(Index edge, double length, const W& w) {
    const auto timed = recorder_.enter(Phase::trimming);
    if (lists_[edge].empty()) [[unlikely]] {
      if (lists_.is_closed(edge)) return;
      lists_.open(edge, length, kGap);
      open_lists_.add(edge);
    }
    const std::span<const ListedWindow> list = lists_[edge];
    const double narrowest = kWindowWidth * length;
    std::size_t first = place_of(list, w.begin + narrowest), k = first;
    if (pieces_.size() < kMostPieces * list.size() + 1) [[unlikely]] {
      pieces_.resize(2 * kMostPieces * list.size() + 1);
    }
    ListedWindow* const pieces = pieces_.data();  // in place of windows [first, k)
    std::size_t count = 0, parts = 0;             // of the pieces, of those that are the newcomer's
    std::size_t part = 0;                         // the newcomer's last one
    bool goes_on = false;                         // the last piece is the newcomer's
    double from = list[k].begin;
    from = w.begin - from < narrowest ? from : w.begin;
    // Beyond `again` the newcomer is laid over the list once more.
    double stop = w.end - narrowest, again = w.end;
    do {
      const ListedWindow old = list[k];
      const double old_end = end_of(list, k), to = old_end < w.end + narrowest ? old_end : w.end;
      const Division division = divide(w, windows_[old.number], from, to, narrowest);
      if (!division.challenger_first && division.cuts == 0) {
        pieces[count] = old;
        count += count > 0 ? 1 : 0;
        first += count > 0 ? 0 : 1;
        goes_on = false;
      } else {
        const bool leads = division.challenger_first;
        double begin = from, end = to;  // of the newcomer's part
        if (division.cuts > 0) {
          begin = leads ? from : division.at[0];
          end = leads ? division.at[0] : to;
          if (division.cuts == 2) [[unlikely]] {
            (leads ? again : end) = division.at[1];
            stop = leads ? end : stop;
          }
        }
        const bool before = begin > old.begin, behind = end < old_end;  // parts that are left
        const Index rest = (before & behind) ? split(old.number, end) : old.number;
        if (before | behind) {
          trim(old.number, before, before ? begin : end);
        } else {
          drop(old.number);
        }
        pieces[count] = old;
        count += before;
        goes_on = goes_on & !before;
        pieces[count] = {begin, kNone};
        part = goes_on ? part : count;
        count += !goes_on;
        parts += !goes_on;
        pieces[count] = {end, rest};
        count += behind;
        goes_on = !behind;
      }
      from = to;
      ++k;
    } while (k < list.size() && list[k].begin < stop);
    if (parts == 0) return;
    pieces[count].begin = end_of(list, k - 1);
    pieces[part].number = accept(w, pieces[part].begin, pieces[part + 1].begin);
    for (std::size_t j = 0; parts > 1; ++j) {
      if (pieces[j].number != kNone) continue;
      pieces[j].number = accept(w, pieces[j].begin, pieces[j + 1].begin);
      --parts;
    }
    recorder_.wavefront_size(waiting_);
    lists_.replace(edge, first, k, {pieces, count});
    if (again < w.end) [[unlikely]] {
      W rest = w;
      rest.begin = again;
      insert(edge, length, rest);
    }
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
      const std::span<const ListedWindow> list = lists_[edge];
      // The gap is not done: it may be a sliver left by rounding.
      const auto is_done = [&](const ListedWindow& w) {
        return windows_[w.number].state == State::done;
      };
      if (!std::ranges::all_of(list, is_done)) return false;
      for (const ListedWindow& w : list) windows_.release(w.number);
      windows_released_ += list.size();
      lists_.close(edge);
      return true;
    });
  }

  /// Passes the waiting windows to the recorder, edge by edge.
  void sample(const typename Recorder::Progress& progress) {
    recorder_.sample(progress, [&](auto&& visit) {
      for (Index edge = 0; edge < lists_.edge_bound(); ++edge) {
        for (const ListedWindow& listed : lists_[edge]) {
          const W& w = windows_[listed.number];
          if (w.is_queued()) visit(edge, w);
        }
      }
    });
  }

  /// Copies the windows of a list.
  void copy_windows(Index edge, std::vector<Window>& windows) const {
    windows.clear();
    for (const ListedWindow& w : lists_[edge]) {
      if (w.number != kGap) windows.push_back(windows_[w.number]);
    }
  }

  /// Number of windows on all edges, including closed lists. For recorded solves only.
  std::uint64_t windows_left() const {
    std::uint64_t left = windows_released_;
    for (Index edge = 0; edge < lists_.edge_bound(); ++edge) {
      for (const ListedWindow& w : lists_[edge]) left += w.number != kGap ? 1u : 0u;
    }
    return left;
  }

 private:
  static constexpr Index kGap = 0;  // the number added first
  static constexpr double kGapSigma = 1e300;
  // Of one window: the part before the newcomer, the newcomer's, and the part behind.
  static constexpr std::size_t kMostPieces = 3;

  /// Starts to load what the next takes will read, in stages. The addresses for each stage are in
  /// the data of the stage before: window, faces, the lists into which its children are inserted,
  /// their ends, the windows there.
  void prefetch_ahead(const Mesh& mesh) {
    pipeline_.advance(upcoming(queue_));
    if (pipeline_[0] != kNone) windows_.prefetch(pipeline_[0]);
    if (const W* w = upcoming_window(1)) mesh.prefetch_face(w->into);
    for_each_target(mesh, 2, [&](Index edge) { lists_.prefetch_list(edge); });
    for_each_target(mesh, 3, [&](Index edge) { lists_.prefetch_ends(edge); });
    for_each_target(mesh, 4, [&](Index edge) {
      const std::span<const ListedWindow> list = lists_[edge];
      if (list.empty()) return;
      for (const std::size_t k : {std::size_t{0}, list.size() - 1}) {
        windows_.prefetch(list[k].number);
      }
    });
  }

  /// The window at a stage of prefetch_ahead; null when there is none.
  const W* upcoming_window(std::size_t stage) const {
    const Index number = pipeline_[stage];
    return number == kNone || !windows_[number].is_queued() ? nullptr : &windows_[number];
  }

  /// Calls visit(edge) for the lists on the other two edges of the face which the window at a stage
  /// enters.
  template <class Visit>
  void for_each_target(const Mesh& mesh, std::size_t stage, Visit&& visit) const {
    const W* w = upcoming_window(stage);
    if (w == nullptr) return;
    for (const Index h : {Mesh::next(w->into), Mesh::previous(w->into)}) {
      visit(list_of(h, mesh.twin(h)));
    }
  }

  void push(double key, Index number) {
    const auto timed = recorder_.enter(Phase::queue);
    queue_.push(key, number);
  }

  /// Adds a part that the newcomer has won, and queues it. @return its number
  Index accept(const W& newcomer, double begin, double end) {
    recorder_.valid(1);
    const Window part{begin, end, newcomer.x, newcomer.y, newcomer.sigma};
    const double key = least_distance(part);
    const bool is_queued = newcomer.into != kNone && !(key > limit_);
    const Index number = windows_.add(
        {part, newcomer.into, is_queued ? State::waits : State::done, newcomer.origin});
    if (is_queued) {
      ++waiting_;
      push(key, number);
    }
    return number;
  }

  /// A window keeps the part before `cut`, or behind it. If it waits and thereby loses its nearest
  /// point, it counts as re-inserted now, though it is queued again later.
  void trim(Index number, bool before, double cut) {
    W& w = windows_[number];
    const double nearest = nearest_position(w);
    const bool moves = w.is_queued() & (before ? nearest > cut : nearest < cut);
    (before ? w.end : w.begin) = cut;
    w.state = moves ? State::outdated : w.state;
    recorder_.reinserted(moves);
  }

  /// The part of a window from `begin` on becomes a window of its own, queued if the window waits.
  /// @return its number
  Index split(Index number, double begin) {
    if (number == kGap) return kGap;
    W part = windows_[number];
    part.begin = begin;
    if (!part.is_queued()) return windows_.add(part);
    part.state = State::waits;
    const Index added = windows_.add(part);
    ++waiting_;
    recorder_.reinserted(1);
    push(least_distance(part), added);
    return added;
  }

  /// A window has lost everything.
  void drop(Index number) {
    W& w = windows_[number];
    if (w.state == State::done) {
      windows_.release(number);
    } else if (w.is_queued()) {
      w.state = State::dead;
      --waiting_;
    }
  }

  EdgeLists lists_;
  OpenLists open_lists_;
  Queue queue_;
  Pool<W> windows_;
  PrefetchPipeline<5> pipeline_;  // windows in the stages of prefetch_ahead
  double limit_ = kInfinity;
  Recorder& recorder_;
  [[no_unique_address]] typename Recorder::Count waiting_{};           // windows that wait
  [[no_unique_address]] typename Recorder::Count windows_released_{};  // of closed lists
  std::vector<ListedWindow> pieces_;                                   // scratch memory of insert
};

}  // namespace geodesic::mmp
