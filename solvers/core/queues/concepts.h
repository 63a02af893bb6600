// What propagation needs of a queue. Any class with these members will do.
#pragma once

#include <concepts>

#include "solvers/core/geometry.h"

namespace geodesic {

/// Of windows, by number: for Chen-Han. A queue may also have
///
///     const Index* upcoming();
///
/// an item that is popped soon but not next, for its data to be prefetched, or null; and
///
///     void keep_sorted();
///
/// what keep_sorted below asks for.
template <class Queue>
concept WindowQueue = requires(Queue queue, const Queue& constant, double key, Index window) {
  { constant.empty() } -> std::convertible_to<bool>;
  queue.clear();
  queue.push(key, window);                        // key: its least distance
  { queue.pop() } -> std::convertible_to<Index>;  // in any order; best with least keys first
};

/// The same for MMP, which changes keys and forgets what the wavefront has passed.
template <class Queue>
concept WindowQueueByKey = WindowQueue<Queue> && requires(const Queue& queue, double key) {
  { queue.is_due(key) } -> std::convertible_to<bool>;    // a window of this key may go first
  { queue.least_key() } -> std::convertible_to<double>;  // no smaller key waits, or will be pushed
};

/// Of vertices, each in it at most once: for edge-based propagation.
template <class Queue>
concept VertexQueue = requires(Queue queue, const Queue& constant, double key, Index vertex) {
  { constant.empty() } -> std::convertible_to<bool>;
  {
    constant.least_key()
    } -> std::convertible_to<double>;  // no vertex that waits has a smaller one
  queue.clear();
  queue.push_or_decrease(vertex, key);            // nothing happens when its key is smaller already
  { queue.pop() } -> std::convertible_to<Index>;  // in any order; best with least keys first
};

/// Asks a queue whose order is a rough one for that of keys, as nearly as it can, until it is
/// cleared: what goes before its turn is lost when a solve ends early.
template <WindowQueue Queue>
void keep_sorted(Queue& queue) {
  if constexpr (requires { queue.keep_sorted(); }) queue.keep_sorted();
}

/// @return what the queue announces, kNone when it announces nothing
template <WindowQueue Queue>
Index upcoming(Queue& queue) {
  if constexpr (requires { queue.upcoming(); }) {
    const Index* item = queue.upcoming();
    return item != nullptr ? *item : kNone;
  } else {
    return kNone;
  }
}

}  // namespace geodesic
