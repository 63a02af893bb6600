// Requirements of propagation on a queue. Any class with these members will do: propagation calls
// no others.
#pragma once

#include <concepts>

#include "solvers/core/geometry.h"

namespace geodesic {

/// A queue of windows, by number, for Chen-Han. It may also have
///
///     const Index* upcoming();
///
/// which returns an item that is popped soon but not next, for prefetching, or null;
///
///     void keep_sorted();
///
/// for the function keep_sorted below; and
///
///     double least_key();
///
/// as in WindowQueueByKey, by which a solve that stops at targets ends early.
template <class Queue>
concept WindowQueue = requires(Queue queue, const Queue& constant, double key, Index window) {
  { constant.empty() } -> std::convertible_to<bool>;
  queue.clear();
  queue.push(key, window);                        // key: the window's least distance
  { queue.pop() } -> std::convertible_to<Index>;  // in any order; best with least keys first
};

/// The same for MMP, which changes keys and discards edges that the wavefront has passed.
template <class Queue>
concept WindowQueueByKey = WindowQueue<Queue> && requires(const Queue& queue, double key) {
  { queue.is_due(key) } -> std::convertible_to<bool>;    // a window of this key may be next
  { queue.least_key() } -> std::convertible_to<double>;  // no smaller key waits or will be pushed
};

/// A queue of vertices, each in it at most once, for edge-based propagation.
template <class Queue>
concept VertexQueue = requires(Queue queue, const Queue& constant, double key, Index vertex) {
  { constant.empty() } -> std::convertible_to<bool>;
  { constant.least_key() } -> std::convertible_to<double>;  // no waiting vertex has a smaller key
  { queue.first_key() } -> std::convertible_to<double>;     // the same, nearer to the least key
  queue.clear();
  queue.push_or_decrease(vertex, key);            // no effect if its key is smaller already
  { queue.pop() } -> std::convertible_to<Index>;  // in any order; best with least keys first
};

/// If the queue's order is only roughly that of keys, makes it as exact as the queue can, until the
/// queue is cleared: early items are wasted when a solve ends early.
template <WindowQueue Queue>
void keep_sorted(Queue& queue) {
  if constexpr (requires { queue.keep_sorted(); }) queue.keep_sorted();
}

/// @return the item that the queue announces, kNone when there is none
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
