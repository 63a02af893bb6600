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
#include "solvers/core/upcoming.h"
#include "solvers/mmp/edge_lists.h"
#include "solvers/mmp/edge_window.h"
#include "solvers/mmp/overlay.h"
#include "solvers/mmp/reached_edges.h"
#include "solvers/mmp/tickets.h"

namespace geodesic::mmp {

/// @tparam Queue of numbers of tickets (core/queues)
/// @tparam Layout as in list_layout.h
template <class Queue, class Layout, class Recorder>
class Wavefront {
 public:
  using Depth = typename Recorder::Depth;

  /// What the queue gives back.
  struct Taken {
    Index vertex = kNone;  ///< a pseudo-source, or none:
    Index edge = kNone;    ///< the list of a window, in the frame of that half-edge
    Window window = {};    ///< y > 0: it enters the twin's face
    Index source = kNone;
    Depth depth = {};
  };

  /// @param recorder must outlive this
  Wavefront(Index half_edges, Queue queue, Recorder& recorder)
      : lists_(half_edges), queue_(std::move(queue)), recorder_(recorder) {}

  /// Forgets everything.
  void start(double limit) {
    lists_.clear();
    reached_.clear();
    windows_released_ = {};
    queue_.clear();
    tickets_.clear();
    upcoming_.clear();
    sigmas_.clear();
    waiting_ = {};
    // A window whose key exceeds the limit by rounding may reach a vertex that lies on it.
    limit_ = limit * (1 + kPathMargin);
  }

  bool empty() const { return queue_.empty(); }

  void push_vertex(Index v, double distance) {
    if (distance > limit_) return;
    push(distance, tickets_.issue({Ticket::kVertex, 0, v, 0, false}));
  }

  /// Makes room for the windows of a pseudo-source. @return its number
  Index add_source(double sigma) {
    sigmas_.push_back(sigma);
    return static_cast<Index>(sigmas_.size() - 1);
  }

  /// The next pseudo-source or window, which does not wait any longer; none when what waited is no
  /// more, or is queued again. The wavefront must not be empty.
  std::optional<Taken> take(const Mesh& mesh) {
    const auto timed = recorder_.enter(Phase::queue);
    const Index number = queue_.pop();
    fetch_ahead(mesh);
    const Ticket ticket = tickets_[number];
    if (!ticket.is_window()) {
      tickets_.take_back(number);
      if (ticket.is_void()) return std::nullopt;
      return Taken{.vertex = ticket.id};
    }
    const double length = mesh.half_edge(ticket.id).length;
    const std::span<W> list = lists_.windows(ticket.id);
    const std::size_t i = find(list, ticket);
    W& w = list[i];
    const Window window = w.geometry(end_of(list, i, length), sigmas_[w.source]);
    if (ticket.late && postpone(number, window)) return std::nullopt;
    tickets_.take_back(number);
    w.ticket = kNone;
    if constexpr (Recorder::kRecords) --waiting_;
    return Taken{.edge = ticket.id, .window = window, .source = w.source, .depth = w.depth};
  }

  /// Lays a window over those of its list and queues the parts that it wins.
  /// @param edge the half-edge that the list goes by, in whose frame w is
  /// @param source the number of its source
  /// @param goes_on whether there is a face beyond
  void lay(Index edge, double length, const Window& w, Index source, Depth depth, bool goes_on) {
    const auto timed = recorder_.enter(Phase::trimming);
    if (lists_.windows(edge).empty()) {
      if (lists_.is_closed(edge)) return;
      const W gap = W::gap(0);
      lists_.replace(edge, 0, 0, {&gap, 1});
      reached_.add(edge);
    }
    const std::span<const W> list = lists_.windows(edge);
    const W challenger{w.begin, w.x, w.y, source, kNoTicketYet, depth};
    if (!overlay(list, length, challenger, w.end, std::span<const double>(sigmas_), overlay_))
      return;
    const std::span<const W> replaced =
        list.subspan(overlay_.first, overlay_.last - overlay_.first);
    if constexpr (Recorder::kRecords) waiting_ -= count_waiting(replaced);
    // Void until one of the pieces claims it.
    for (const W& old : replaced) {
      if (old.waits()) tickets_[old.ticket].id = kNone;
    }
    const std::span<W> pieces = overlay_.pieces();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      W& piece = pieces[k];
      if (!piece.waits()) continue;
      const double end = overlay_.piece_end(k);
      const auto index = static_cast<Index>(overlay_.first + k);
      if (piece.ticket == kNoTicketYet) {
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

  /// Now and then, closes the lists that the wavefront has passed, and frees their memory. What is
  /// still to come is at least as long as the least key that waits, and every point of an edge is
  /// at least as near as the ways along the edge from its ends: where those are shorter, no window
  /// to come carries a shortest path, and the list would reject it.
  /// @param distances of vertices, lengths of paths that exist
  void release_passed(const Mesh& mesh, std::span<const double> distances) {
    if (!reached_.is_due()) return;
    const double to_come = queue_.least_key() * (1 - kPassedMargin);
    reached_.look_through([&](Index edge) {
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

  /// Hands the windows that wait to the recorder.
  void sample(const Mesh& mesh, const Sweep& sweep) {
    recorder_.sample(sweep, [&](auto&& visit) {
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

  /// The windows of a list.
  void copy_windows(Index edge, double length, std::vector<Window>& windows) const {
    windows.clear();
    const std::span<const W> list = lists_.windows(edge);
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].is_gap()) continue;
      windows.push_back(list[i].geometry(end_of(list, i, length), sigmas_[list[i].source]));
    }
  }

  /// Windows on all edges, with those of lists that were closed. Only of recorded solves.
  std::uint64_t windows_left() const {
    std::uint64_t left = windows_released_;
    for (Index edge = 0; edge < lists_.edge_bound(); ++edge) {
      for (const W& w : lists_.windows(edge)) left += w.is_gap() ? 0u : 1u;
    }
    return left;
  }

 private:
  using W = EdgeWindow<Depth>;

  /// Has the memory fetched that the next takes will read, each address of which lies behind the
  /// one before: ticket, list, window and faces, its sigma and the lists that its children are laid
  /// over.
  void fetch_ahead(const Mesh& mesh) {
    const Index* told = queue_.upcoming();
    upcoming_.advance(told ? *told : kNone);
    if (upcoming_[0] != kNone) prefetch(&tickets_[upcoming_[0]]);
    if (const Ticket* ticket = upcoming_ticket(1)) {
      mesh.fetch_face(ticket->id);
      lists_.fetch(ticket->id);
    }
    if (const Ticket* ticket = upcoming_ticket(2)) {
      prefetch(likely_window(*ticket));
      mesh.fetch_face(mesh.twin(ticket->id));
    }
    if (const Ticket* ticket = upcoming_ticket(3)) {
      if (const W* w = likely_window(*ticket)) {
        prefetch(sigmas_.data() + w->source);
        for_each_target(mesh, ticket->id, *w, [&](Index edge) { lists_.fetch(edge); });
      }
    }
    if (const Ticket* ticket = upcoming_ticket(4)) {
      if (const W* w = likely_window(*ticket)) {
        for_each_target(mesh, ticket->id, *w, [&](Index edge) { lists_.fetch_windows(edge); });
      }
    }
  }

  /// The ticket of a window at a stage of fetch_ahead; null when there is none.
  const Ticket* upcoming_ticket(std::size_t stage) {
    const Index number = upcoming_[stage];
    return number == kNone || !tickets_[number].is_window() ? nullptr : &tickets_[number];
  }

  /// The window that holds a ticket or, as its list changes, one near it; null when the list has
  /// been closed, which fetch_ahead may come too late to know.
  const W* likely_window(const Ticket& ticket) const {
    const std::span<const W> list = lists_.windows(ticket.id);
    return list.empty() ? nullptr : &list[ticket.likely_index(list.size())];
  }

  /// Calls visit(edge) for the two edges that the children of a window, given by its list, will be
  /// laid over.
  template <class Visit>
  void for_each_target(const Mesh& mesh, Index edge, const W& w, Visit&& visit) {
    const Index into = w.y < 0 ? edge : mesh.twin(edge);
    if (into == kNone) return;
    for (const Index h : {Mesh::next(into), Mesh::previous(into)}) {
      visit(Layout::list(h, mesh.twin(h)));
    }
  }

  /// Index in its list of the window that holds a ticket.
  static std::size_t find(std::span<const W> list, const Ticket& ticket) {
    std::size_t i = ticket.likely_index(list.size());
    while (list[i].begin > ticket.begin) --i;
    while (list[i].begin < ticket.begin) ++i;
    return i;
  }

  /// Queues a window that is late with its present key, unless it is its turn by that too.
  bool postpone(Index number, const Window& window) {
    const double key = least_distance(window);
    if (queue_.is_due(key)) return false;
    tickets_[number].late = false;
    queue_.push(key, number);
    return true;
  }

  void push(double key, Index ticket) {
    const auto timed = recorder_.enter(Phase::queue);
    queue_.push(key, ticket);
  }

  /// Queues a part that the challenger won.
  void accept(Index edge, Index index, W& piece, double end, double sigma, bool goes_on) {
    recorder_.valid(1);
    piece.ticket = kNone;
    const Window part = piece.geometry(end, sigma);
    const double key = least_distance(part);
    if (!goes_on || key > limit_) return;
    piece.ticket = tickets_.issue({piece.begin, nearest_position(part), edge, index, false});
    push(key, piece.ticket);
  }

  /// The first piece of a window that waits keeps its ticket, others are queued by themselves. A
  /// piece with another nearest point counts as re-inserted here, though its entry stays for now.
  void keep_queued(Index edge, Index index, W& piece, double end) {
    const Window part = piece.geometry(end, sigmas_[piece.source]);
    const double nearest = nearest_position(part);
    Ticket& ticket = tickets_[piece.ticket];
    if (!ticket.is_void()) {
      recorder_.reinserted(1);
      piece.ticket = tickets_.issue({piece.begin, nearest, edge, index, false});
      push(least_distance(part), piece.ticket);
      return;
    }
    const bool moved = nearest != ticket.nearest;
    if (moved) recorder_.reinserted(1);
    ticket = {piece.begin, nearest, edge, index, ticket.late || moved};
  }

  static std::uint64_t count_waiting(std::span<const W> windows) {
    return static_cast<std::uint64_t>(
        std::count_if(windows.begin(), windows.end(), [](const W& w) { return w.waits(); }));
  }

  // False of slivers too that rounding leaves behind.
  static bool is_propagated(const W& w) { return !w.waits() && !w.is_gap(); }

  EdgeLists<W> lists_;
  ReachedEdges reached_;
  Queue queue_;
  Tickets tickets_;
  Upcoming<5> upcoming_;        // tickets on the way through fetch_ahead
  std::vector<double> sigmas_;  // by number of source
  double limit_ = kInfinity;
  Recorder& recorder_;
  [[no_unique_address]] typename Recorder::Count waiting_{};           // windows that wait
  [[no_unique_address]] typename Recorder::Count windows_released_{};  // of closed lists
  Overlay<W> overlay_;                                                 // scratch of lay
};

}  // namespace geodesic::mmp
