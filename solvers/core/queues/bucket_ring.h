// Calendar queues: items sorted into buckets by floor(key / width), in a ring of buckets.
//
// Brown 1988, "Calendar queues: a fast O(1) priority queue implementation for the simulation event
// set problem" (CACM 31(10)). The keys of a wavefront lie close together, and new ones lie mostly
// ahead. A ring of buckets that starts at the wavefront therefore takes nearly all of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "solvers/core/mesh.h"
#include "solvers/core/pool.h"
#include "solvers/core/tolerance.h"

namespace geodesic {

/// The bucket width that Xu, Wang, Liu, Liu, He 2015 publish for FWP, in the mesh's unit of length;
/// 0 for a mesh without edges.
inline double published_bucket_width(const Mesh& mesh) {
  const double vertices = std::max(static_cast<double>(mesh.vertex_count()), 1.0);
  return mesh.mean_edge_length() / std::sqrt(vertices);
}

/// Numbers of buckets of equal width, from 0; they do not decrease as keys grow. Keys too large for
/// a number share the last bucket.
class BucketNumbers {
 public:
  /// @param width keys covered by one bucket; if 0, one bucket takes everything
  /// @throws std::invalid_argument if it is negative or not a number
  explicit BucketNumbers(double width)
      : per_width_(width > 0 ? std::min(1 / width, kGreatestFactor) : 0) {
    if (!(width >= 0)) throw std::invalid_argument("the width of a bucket is not 0 or positive");
  }

  /// @param key not negative
  std::int64_t of(double key) const {
    return static_cast<std::int64_t>(std::min(key * per_width_, kGreatestNumber));
  }

  /// The least key of this bucket and of all later ones, or a smaller value.
  double least_key(std::int64_t number) const {
    return per_width_ > 0 ? static_cast<double>(number) / per_width_ * (1 - kKeyRounding) : 0;
  }

 private:
  static constexpr double kGreatestFactor = 1e300;
  static constexpr double kGreatestNumber = 9e18;  // fits std::int64_t

  double per_width_;
};

/// An item in a bucket.
template <class Item>
struct BucketNode {
  Item item;
  Index next;  ///< the next node of the same bucket
};

/// A bucket whose items are taken all at once, the last one first. It is a single number.
struct Stack {
  Index first = kNone;

  bool empty() const { return first == kNone; }
  template <class Item>
  void push(Pool<BucketNode<Item>>& nodes, const Item& item) {
    first = nodes.add({item, first});
  }
};

/// A bucket in order of arrival.
struct Fifo {
  Index first = kNone, last = kNone;
  std::uint32_t count = 0;

  bool empty() const { return count == 0; }
  template <class Item>
  void push(Pool<BucketNode<Item>>& nodes, const Item& item) {
    const Index at = nodes.add({item, kNone});
    (count == 0 ? first : nodes[last].next) = at;
    last = at;
    ++count;
  }
  /// Appends all items of another bucket.
  template <class Item>
  void append(Pool<BucketNode<Item>>& nodes, const Fifo& other) {
    if (other.empty()) return;
    (count == 0 ? first : nodes[last].next) = other.first;
    last = other.last;
    count += other.count;
  }
  /// Takes the first item out, if there is one, without releasing its node.
  template <class Item>
  void drop_first(const Pool<BucketNode<Item>>& nodes) {
    if (count == 0) return;
    first = nodes[first].next;
    --count;
  }
};

/// Buckets of successive numbers, as many as the ring has places. The user decides which numbers
/// are in use: a place stands for one bucket if no two numbers in use are `size()` apart.
/// @tparam Bucket Stack or Fifo
/// @tparam Item small and trivially copyable
template <class Bucket, class Item>
class BucketRing {
 public:
  /// @param size a power of two
  explicit BucketRing(std::size_t size) : buckets_(size), mask_(size - 1) {}

  std::int64_t size() const { return static_cast<std::int64_t>(mask_) + 1; }
  /// True when no bucket holds an item.
  bool empty() const { return items_ == 0; }
  std::size_t items() const { return items_; }

  void clear() {
    std::fill(buckets_.begin(), buckets_.end(), Bucket{});
    nodes_.clear();
    items_ = 0;
  }

  const Bucket& bucket(std::int64_t number) const { return buckets_[place(number)]; }

  void push(std::int64_t number, const Item& item) {
    buckets_[place(number)].push(nodes_, item);
    ++items_;
  }

  /// The first bucket from `number` on that is not empty; there must be one.
  std::int64_t next_filled(std::int64_t number) const {
    while (bucket(number).empty()) ++number;
    return number;
  }

  /// Empties a bucket and calls visit(item) for its items.
  template <class Visit>
  void drain(std::int64_t number, Visit&& visit) {
    Bucket& bucket = buckets_[place(number)];
    for (Index at = bucket.first; at != kNone;) {
      const BucketNode<Item> node = nodes_.take(at);
      visit(node.item);
      at = node.next;
      --items_;
    }
    bucket = {};
  }

  /// Appends the items of a bucket to a list that shares its nodes with the ring.
  void move_behind(std::int64_t number, Fifo& list) {
    Bucket& bucket = buckets_[place(number)];
    list.append(nodes_, bucket);
    items_ -= bucket.count;
    bucket = {};
  }

  Pool<BucketNode<Item>>& nodes() { return nodes_; }
  const Pool<BucketNode<Item>>& nodes() const { return nodes_; }

 private:
  std::size_t place(std::int64_t number) const { return static_cast<std::size_t>(number) & mask_; }

  std::vector<Bucket> buckets_;
  std::size_t mask_;
  Pool<BucketNode<Item>> nodes_;
  std::size_t items_ = 0;
};

}  // namespace geodesic
