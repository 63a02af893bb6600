// What waits on the sides of faces in the approximate solver: few windows on an edge, which are
// joined (merge.h) when they cross next.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "solvers/core/pool.h"
#include "solvers/core/recorders.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/merge.h"
#include "solvers/edge_based/shortfalls.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// The strip through which a window came, in one word.
struct Strip {
  std::uint32_t depth : 26;    ///< in faces
  bool from_right : 1;         ///< over the side of the face below that is next to the head
  std::uint32_t apart : 3;     ///< faces until it may join its neighbour towards the origin
  std::uint32_t side : 2 = 0;  ///< of the face ahead: where it waits
};
inline constexpr std::uint32_t kMostDepth = (1u << 26) - 1;
/// Neighbours that were not joined are not tried again for this many faces, as long as they go the
/// same way.
inline constexpr std::uint32_t kApart = 3;

/// A window of the list that is crossing.
struct Line {
  MergedWindow merged;
  Strip strip;
  Sides seen;      ///< of the apex, by its lines
  double to_apex;  ///< length of its path to the apex; kInfinity when it does not reach the apex
};

/// A vector that stores its size: computing it from two pointers takes a multiplication.
template <class Item>
class Stack {
 public:
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }
  Item& operator[](std::size_t i) { return items_[i]; }
  Item& back() { return items_[size_ - 1]; }
  Item* begin() { return items_.data(); }
  Item* end() { return items_.data() + size_; }
  const Item& back() const { return items_[size_ - 1]; }
  /// @return the place of the new item, to be filled there without a copy
  Item& push() {
    if (size_ == items_.size()) [[unlikely]] {
      items_.resize(2 * size_ + 16);
    }
    return items_[size_++];
  }
  /// Without a branch, which would often be mispredicted.
  void push_if(bool wanted, const Item& item) {
    push() = item;
    size_ -= !wanted;
  }
  void pop() { --size_; }

 private:
  std::vector<Item> items_;
  std::size_t size_ = 0;
};

/// The windows that wait, and those of the list that crosses next.
class MergedLists {
 public:
  MergedLists(const Mesh& mesh, const MergeRule& rule, double rounding)
      : mesh_(mesh),
        rule_(rule),
        rounding_(rounding),
        shortfalls_(rule.most),
        waiting_(mesh.face_count()) {}

  void start(std::span<const double> distances) {
    distances_ = distances;
    shortfalls_.start(distances);
    std::ranges::fill(waiting_, Waiting{});
    nodes_.clear();
    window_count_ = 0;
  }

  Shortfalls& shortfalls() { return shortfalls_; }
  std::uint64_t window_count() const { return window_count_; }

  template <class Visit>
  void for_each_window(Index h, const Visit& visit) const {
    const Waiting waiting = waiting_[h / 3];
    for (Index n = waiting.first; n != kNil; n = nodes_[n].next) {
      if (nodes_[n].strip.side == h % 3) visit(nodes_[n].merged.window);
    }
    if ((waiting.sends >> h % 3 & 1) != 0) visit(sent_from_below(h).window);
  }

  // A window is passed in registers: if it were stored number by number and read in pairs, the read
  // would wait for the stores. So the code up to the node is inlined and takes it by value.

  /// Adds a window that waits on h.
  [[gnu::always_inline]] void put(Index h, Window w, float shortfall, Strip strip) {
    Waiting& waiting = waiting_[h / 3];
    strip.side = h % 3 & 3;
    waiting.first = nodes_.add({{w, shortfall}, strip, waiting.first}) & kNil;
    ++window_count_;
  }

  /// Adds a window from the third vertex of the face below h, if `wanted`. It is created when the
  /// list crosses: by then it is known which part others leave of it. Has no branch on `wanted`,
  /// which would often be mispredicted.
  void send(Index h, bool wanted) {
    Waiting& waiting = waiting_[h / 3];
    const unsigned sends = waiting.sends | unsigned{wanted} << h % 3;
    window_count_ += unsigned{sends != waiting.sends};
    waiting.sends = sends & kAllSides;
  }

  /// Takes the window on h if nothing else waits on its face: most lists.
  /// @return false when it takes nothing
  [[gnu::always_inline]] bool take_only(Index h, Line& line) {
    Waiting& waiting = waiting_[h / 3];
    const Index only = waiting.first;
    if (only == kNil || nodes_[only].next != kNil || nodes_[only].strip.side != h % 3 ||
        waiting.sends != 0) {
      return false;
    }
    line.merged = nodes_[only].merged;
    line.strip = nodes_[only].strip;
    nodes_.release(only);
    waiting.first = kNil;
    --window_count_;
    return true;
  }

  /// Moves the windows on h into lines(), joined, without those that paths over the ends of h beat.
  template <class Recorder>
  void gather(Index h, const EndpointBounds& bounds, Recorder& recorder) {
    const auto timed = recorder.enter(Phase::trimming);
    const unsigned side = h % 3;
    Waiting& waiting = waiting_[h / 3];
    const bool sends = (waiting.sends >> side & 1) != 0;
    waiting.sends &= kAllSides ^ 1u << side;
    lines_.clear();
    from_left_.clear();
    from_right_.clear();
    Index others_first = kNil;  // those of the other sides stay
    Index* others_end = &others_first;
    for (Index n = waiting.first; n != kNil;) {
      Node& node = nodes_[n];
      const bool ours = node.strip.side == side, from_right = node.strip.from_right;
      from_left_.push_if(ours & !from_right, n);
      from_right_.push_if(ours & from_right, n);
      window_count_ -= unsigned{ours};
      recorder.created(ours);
      *others_end = n;
      others_end = ours ? others_end : &node.next;
      n = node.next;
    }
    *others_end = kNil;
    waiting.first = others_first & kNil;
    for (const Index n : from_left_) append(n, bounds);
    if (sends) {
      --window_count_;
      recorder.created(1);
      while (!from_right_.empty() && is_useless(nodes_[from_right_.back()], bounds)) {
        nodes_.release(from_right_.back());
        from_right_.pop();
      }
      const MergedWindow sent = not_left_to_others(sent_from_below(h), bounds.length);
      if (!is_void(sent.window, bounds.length) && !bounds.beat(sent.window)) {
        append(sent, {1, false, 0}, bounds.length);
      }
    }
    for (; !from_right_.empty(); from_right_.pop()) append(from_right_.back(), bounds);
  }

  /// The windows that `gather` has taken, in order along the edge.
  Stack<Line>& lines() { return lines_; }

  /// Whether a path over an end of the edge beats a window, or no shortest path has its strip.
  bool is_useless(const Window& window, Strip strip, const EndpointBounds& bounds) const {
    return bounds.beat(window) ||
           is_strip_too_long(mesh_.face_count(), strip.depth + std::uint64_t{1});
  }

 private:
  // Handles of nodes have 29 bits.
  static constexpr Index kNil = kNone >> 3;

  /// A window that waits on a side of a face.
  struct alignas(64) Node {
    MergedWindow merged;
    Strip strip;
    Index next;
  };

  /// The windows that wait on the sides of a face, last node first, and the sides on which the
  /// third vertex of the face below sends one. Lists per face take a third of the memory of lists
  /// per half-edge.
  struct Waiting {
    Index first : 29 = kNil;
    Index sends : 3 = 0;
  };
  static constexpr unsigned kAllSides = 7;

  bool is_useless(const Node& node, const EndpointBounds& bounds) const {
    return is_useless(node.merged.window, node.strip, bounds);
  }

  /// The window that the third vertex of the face below sends over all of h.
  MergedWindow sent_from_below(Index h) const {
    const Index below = mesh_.twin(h), v = mesh_.apex(below);
    const Point2 from = apex_from_beyond(mesh_.half_edge(below));
    return {{0, mesh_.half_edge(h).length, from.x, from.y, distances_[v]}, shortfalls_.of(v)};
  }

  /// The part of that window that windows over the sides of the face below leave (merge.h).
  MergedWindow not_left_to_others(MergedWindow sent, double length) const {
    const double flat = -kFlatFace * length;
    Window& p = sent.window;
    if (p.y > flat) return sent;
    const auto is_no_longer = [&](const Window& w, double t) {
      return distance_at(w, t) <= distance_at(p, t) * (1 + kPathMargin) + rounding_;
    };
    if (!lines_.empty() && lines_.back().merged.window.y <= flat) {
      const Window& a = lines_.back().merged.window;
      if (is_right_of_line(a, a.begin, p.x, p.y) && is_right_of_line(a, a.end, p.x, p.y) &&
          is_no_longer(a, a.end)) {
        p.begin = a.end;
      }
    }
    if (!from_right_.empty() && nodes_[from_right_.back()].merged.window.y <= flat) {
      const Window& b = nodes_[from_right_.back()].merged.window;
      if (is_left_of_line(b, b.begin, p.x, p.y) && is_left_of_line(b, b.end, p.x, p.y) &&
          is_no_longer(b, b.begin)) {
        p.end = b.begin;
      }
    }
    return sent;
  }

  void append(Index n, const EndpointBounds& bounds) {
    const Node& node = nodes_[n];
    if (!is_useless(node, bounds)) append(node.merged, node.strip, bounds.length);
    nodes_.release(n);
  }

  /// Appends a window, and joins the last two as long as one remains of them.
  void append(const MergedWindow& merged, Strip strip, double length) {
    Line& line = lines_.push();
    line.merged = merged;
    line.strip = strip;
    while (lines_.size() > 1) {
      Line &a = lines_[lines_.size() - 2], &b = lines_.back();
      if (b.strip.apart > 0) return;
      switch (join(a.merged, b.merged, length, rounding_, rule_)) {
        case Joined::neither:
          b.strip.apart = kApart;
          return;
        case Joined::merged:
          a.strip.depth = std::max(a.strip.depth, b.strip.depth) & kMostDepth;
          break;
        case Joined::first_gone:
          a = b;
          break;
        case Joined::second_gone:
          lines_.pop();
          return;
      }
      lines_.pop();
    }
  }

  const Mesh& mesh_;
  MergeRule rule_;
  double rounding_;  // of coordinates
  std::span<const double> distances_;
  Shortfalls shortfalls_;
  std::vector<Waiting> waiting_;  // by face
  Pool<Node> nodes_;
  std::uint64_t window_count_ = 0;
  // Scratch memory for one list. In from_right_, the first window is the last item.
  Stack<Line> lines_;
  Stack<Index> from_left_, from_right_;  // nodes
};

}  // namespace geodesic::edge_based
