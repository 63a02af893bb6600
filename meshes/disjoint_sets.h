// Sets that are joined two at a time (Galler and Fischer 1964), with path halving.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t elements) : parent_(elements) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /// The least element of the set.
  Index find(Index element) {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];
      element = parent_[element];
    }
    return element;
  }

  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace geodesic
