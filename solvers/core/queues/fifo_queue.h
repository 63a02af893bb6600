// First in, first out: the order of plain Chen-Han.
#pragma once

#include <cstddef>
#include <deque>

namespace geodesic {

/// First in, first out, whatever the keys.
template <class Item>
class FifoQueue {
 public:
  bool empty() const { return items_.empty(); }
  std::size_t size() const { return items_.size(); }
  void clear() { items_.clear(); }
  void push(double /*key*/, Item item) { items_.push_back(item); }
  /// As in BucketQueue.
  const Item* upcoming() const { return items_.size() > 4 ? &items_[4] : nullptr; }
  Item pop() {
    const Item first = items_.front();
    items_.pop_front();
    return first;
  }

 private:
  std::deque<Item> items_;
};

}  // namespace geodesic
