// Tickets: what the queue holds in place of windows and pseudo-sources.
//
// Windows move within their list and lose parts while they wait. A waiting window knows its ticket
// and keeps it up to date, so that no entry of the queue has to be looked for or replaced then: the
// entry of a window that is no more is recognised by its ticket alone, and one whose key has grown
// moves to its new place only when its turn by the old one comes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic::mmp {

struct Ticket {
  double begin;    ///< of the window, by which its list finds it; kVertex for a pseudo-source
  double nearest;  ///< position on the edge where the window is nearest, which decides its key
  Index id;        ///< edge or vertex; kNone when the window is no more
  Index index;     ///< of the window in its list when the ticket was written: near it still
  bool late;       ///< the nearest point was lost, the queue has an older and smaller key

  static constexpr double kVertex = -1;
  bool is_void() const { return id == kNone; }
  bool is_window() const { return id != kNone && begin >= 0; }

  /// Where the window lies about now, in its list of `windows`, at least one.
  std::size_t likely_index(std::size_t windows) const {
    return std::min<std::size_t>(index, windows - 1);
  }
};

/// A ticket lasts until its entry leaves the queue; its number is used again then.
class Tickets {
 public:
  void clear() {
    tickets_.clear();
    free_.clear();
  }

  Index issue(const Ticket& ticket) {
    if (free_.empty()) {
      tickets_.push_back(ticket);
      return static_cast<Index>(tickets_.size() - 1);
    }
    const Index number = free_.back();
    free_.pop_back();
    tickets_[number] = ticket;
    return number;
  }

  Ticket& operator[](Index number) { return tickets_[number]; }
  void take_back(Index number) { free_.push_back(number); }

 private:
  std::vector<Ticket> tickets_;
  std::vector<Index> free_;
};

}  // namespace geodesic::mmp
