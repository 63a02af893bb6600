// The lists that the wavefront may have left behind.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic::mmp {

/// The lists that hold windows, to be looked through whenever their number has grown by a quarter
/// since the last time: at most five looks a list, however many stay.
class ReachedEdges {
 public:
  void clear() {
    lists_.clear();
    due_ = kFirst;
  }

  /// @param list the half-edge that it goes by (list_layout.h), once a list
  void add(Index list) { lists_.push_back(list); }

  bool is_due() const { return lists_.size() >= due_; }

  /// Calls is_done(list) for all, and forgets those for which it holds.
  template <class IsDone>
  void look_through(IsDone&& is_done) {
    std::erase_if(lists_, is_done);
    due_ = std::max(lists_.size() + lists_.size() / 4, kFirst);
  }

 private:
  static constexpr std::size_t kFirst = 1024;

  std::vector<Index> lists_;
  std::size_t due_ = kFirst;
};

}  // namespace geodesic::mmp
