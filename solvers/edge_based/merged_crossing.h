// The crossing of the approximate solver: takes the few windows that are left on an edge after
// neighbours are merged (merge.h), one or two on average, across a face. Comparisons at points of
// the edge and of the face beyond decide how they trim each other.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "solvers/core/recorders.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/merge.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// Implements a Crossing (wavefront.h).
class MergedCrossing {
 public:
  /// @param tolerance largest relative error of distances
  MergedCrossing(const Mesh& mesh, double tolerance)
      : mesh_(mesh),
        tolerance_(tolerance),
        parameters_(tolerance >= kCoarse ? kForCoarse : kForFine),
        rule_{parameters_.room * tolerance * (1 - kShortfallRounding), parameters_.share_of_rest},
        waiting_(mesh.face_count()),
        budget_(mesh),
        rounding_(coordinate_rounding(mesh)) {}

  void start(std::span<double> distances) {
    distances_ = distances;
    shares_.assign(distances.size(), 0);
    std::ranges::fill(waiting_, Waiting{});
    nodes_.clear();
    free_ = kNil;
    window_count_ = 0;
    budget_.start();
  }
  void follow_edge(Index from, Index to) { set_shortfall(to, shortfall(from)); }
  double rounding() const { return rounding_; }
  std::uint64_t window_count() const { return window_count_; }

  /// The truth lies from D to D + s, and s is at most room * tolerance * D with room at most 2: the
  /// result differs from it by at most tolerance * D in either direction.
  void finish() {
    for (Index v = 0; v < distances_.size(); ++v) {
      const double s = shortfall(v);
      if (s > 0) distances_[v] += std::max(parameters_.given * s, s - tolerance_ * distances_[v]);
    }
  }

  template <class Visit>
  void for_each_window(Index h, const Visit& visit) const {
    const Waiting waiting = waiting_[h / 3];
    for (Index n = waiting.first; n != kNil; n = nodes_[n].next) {
      if (nodes_[n].strip.side == h % 3) visit(nodes_[n].merged.window);
    }
    if ((waiting.sends >> h % 3 & 1) != 0) visit(sent_from_below(h).window);
  }

  template <class Wavefront>
  void emit(Index side, const Point2& from, double distance, Index root, Wavefront& wavefront) {
    const HalfEdge& e = mesh_.half_edge(side);
    if (e.twin == kNone || !(e.length > 0)) return;
    const float missing = root < mesh_.vertex_count() ? shortfall(root) : 0;
    land(side, {0, e.length, from.x, from.y, distance}, missing, {1, true, 0}, wavefront);
  }

  /// The window is created when the list crosses: by then it is known which part others leave of
  /// it. Has no branch on `wanted`, which would often be mispredicted.
  template <class Wavefront>
  void emit_from_apex(bool wanted, Index side, Wavefront& wavefront) {
    const HalfEdge& e = mesh_.half_edge(side);
    if (e.twin == kNone || !(e.length > 0)) return;
    if (mesh_.crosses_non_manifold_edges()) [[unlikely]] {
      const Index v = mesh_.apex(side);
      if (wanted) emit(side, apex_from_beyond(e), distances_[v], v, wavefront);
      return;
    }
    Waiting& waiting = waiting_[e.twin / 3];
    const unsigned sends = waiting.sends | unsigned{wanted} << e.twin % 3;
    window_count_ += unsigned{sends != waiting.sends};
    waiting.sends = sends & kAllSides;
    wavefront.land(e.twin, wanted);
  }

  template <class Wavefront>
  void cross(Index h, Wavefront& wavefront) {
    auto& recorder = wavefront.recorder();
    const HalfEdge& edge = mesh_.half_edge(h);
    const EndpointBounds bounds(edge.length, distances_[edge.origin], distances_[mesh_.head(h)]);
    Waiting& waiting = waiting_[h / 3];
    if (const Index only = waiting.first; only != kNil && nodes_[only].next == kNil &&
                                          nodes_[only].strip.side == h % 3 &&
                                          waiting.sends == 0) {  // most lists
      Line line{nodes_[only].merged, nodes_[only].strip, 0, false, false};
      nodes_[only].next = std::exchange(free_, only);
      waiting.first = kNil;
      --window_count_;
      recorder.created(1);
      if (!is_useless(line.merged.window, line.strip, bounds)) cross_alone(h, line, wavefront);
      return;
    }
    gather(h, bounds, recorder);
    if (lines_.size() == 1) {
      cross_alone(h, lines_.back(), wavefront);
    } else if (!lines_.empty()) {
      cross_together(h, wavefront);
    }
  }

 private:
  /// Use of the tolerance; values measured on scans and terrain.
  struct Parameters {
    double room;           ///< greatest shortfall divided by the tolerance, at most 2
    double given;          ///< share of a vertex's shortfall that is added to its distance
    double share_of_rest;  ///< MergeRule::share
  };
  static constexpr double kCoarse = 3e-3;
  static constexpr Parameters kForCoarse = {1.4, 0.2, 0.2}, kForFine = {2, 0.3, 0.3};
  /// Neighbours that were not joined are not tried again for this many faces, as long as they go
  /// the same way.
  static constexpr std::uint32_t kApart = 3;

  // Handles of nodes have 29 bits.
  static constexpr Index kNil = kNone >> 3;

  /// The strip through which a window came, in one word.
  struct Strip {
    std::uint32_t depth : 26;    ///< in faces
    bool from_right : 1;         ///< over the side of the face below that is next to the head
    std::uint32_t apart : 3;     ///< faces until it may join its neighbour towards the origin
    std::uint32_t side : 2 = 0;  ///< of the face ahead: where it waits
  };
  static constexpr std::uint32_t kMostDepth = (1u << 26) - 1;

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

  /// A window of the list that is crossing.
  struct Line {
    MergedWindow merged;
    Strip strip;
    double to_apex;  ///< along the line to the apex
    bool left, right;
  };

  // The shortfall of a vertex is stored as a share of the greatest allowed one, rounded up: 16 bits
  // per vertex.
  static constexpr double kWhole = UINT16_MAX;

  float shortfall(Index v) const {
    return internal::rounded_up(rule_.most / kWhole * shares_[v] * distances_[v]);
  }
  void set_shortfall(Index v, float missing) {
    const double share = missing > 0 ? missing / (rule_.most / kWhole * distances_[v]) : 0;
    shares_[v] = static_cast<std::uint16_t>(std::min(std::ceil(share), kWhole));
  }

  /// Moves the windows on h into lines_, joined, without those that paths over the ends of h beat.
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
    // The nodes of this side become free; those of the other sides stay.
    Index ours_first = kNil, others_first = kNil;
    Index *ours_end = &ours_first, *others_end = &others_first;
    for (Index n = waiting.first; n != kNil;) {
      Node& node = nodes_[n];
      const bool ours = node.strip.side == side, from_right = node.strip.from_right;
      from_left_.push_if(ours & !from_right, n);
      from_right_.push_if(ours & from_right, n);
      window_count_ -= unsigned{ours};
      recorder.created(ours);
      *(ours ? ours_end : others_end) = n;
      ours_end = ours ? &node.next : ours_end;
      others_end = ours ? others_end : &node.next;
      n = node.next;
    }
    *ours_end = free_;
    *others_end = kNil;
    free_ = ours_first;
    waiting.first = others_first & kNil;
    for (const Index n : from_left_) append(n, bounds);
    if (sends) {
      --window_count_;
      recorder.created(1);
      while (!from_right_.empty() && is_useless(nodes_[from_right_.back()], bounds)) {
        from_right_.pop();
      }
      const MergedWindow sent = not_left_to_others(sent_from_below(h), bounds.length);
      if (!is_void(sent.window, bounds.length) && !bounds.beat(sent.window)) {
        append(sent, {1, false, 0}, bounds.length);
      }
    }
    for (; !from_right_.empty(); from_right_.pop()) append(from_right_.back(), bounds);
  }

  bool is_useless(const Node& node, const EndpointBounds& bounds) const {
    return is_useless(node.merged.window, node.strip, bounds);
  }
  bool is_useless(const Window& window, Strip strip, const EndpointBounds& bounds) const {
    return bounds.beat(window) || is_strip_too_long(mesh_, strip.depth + std::uint64_t{1});
  }

  /// The window that the third vertex of the face below sends over all of h.
  MergedWindow sent_from_below(Index h) const {
    const Index below = mesh_.twin(h), v = mesh_.apex(below);
    const Point2 from = apex_from_beyond(mesh_.half_edge(below));
    return {{0, mesh_.half_edge(h).length, from.x, from.y, distances_[v]}, shortfall(v)};
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

  /// Finds the sides on which the lines of a window pass the apex.
  static void find_sides(Line& line, const FaceFrame& face) {
    const double slack = kApexTolerance * face.length;
    const Window& w = line.merged.window;
    const double up = std::max(face.apex_y - w.y, kLeastHeight);
    const double across = (face.apex_x - w.x) * -w.y;
    line.left = across >= (w.begin - slack - w.x) * up;
    line.right = across <= (w.end + slack - w.x) * up;
    if (line.left && line.right) line.to_apex = distance_through(w, face.apex_x, face.apex_y);
  }

  /// One window crosses a face: as cross_together, without the comparison of windows.
  template <class Wavefront>
  void cross_alone(Index h, Line& line, Wavefront& wavefront) {
    budget_.spend(1);
    const FaceFrame face = face_frame(mesh_, h);
    find_sides(line, face);
    count(line, wavefront.recorder());
    const Index left = Mesh::previous(h), right = Mesh::next(h);
    if (line.left && line.right) reach_apex(h, line, wavefront);
    if (line.left && mesh_.twin(left) != kNone) go_left(left, face, line, false, wavefront);
    if (line.right && mesh_.twin(right) != kNone) go_right(right, face, line, false, wavefront);
  }

  template <class Wavefront>
  [[gnu::noinline]] void cross_together(Index h, Wavefront& wavefront) {
    budget_.spend(lines_.size());
    const FaceFrame face = face_frame(mesh_, h);
    const Line* best = nullptr;  // with the shortest line to the apex
    for (Line& line : lines_) {
      find_sides(line, face);
      if (!line.left || !line.right) continue;
      if (best == nullptr || line.to_apex < best->to_apex) best = &line;
    }
    if (best != nullptr) {
      reach_apex(h, *best, wavefront);
      drop_crossing(*best, face);
    }
    for (const Line& line : lines_) count(line, wavefront.recorder());
    const Index left = Mesh::previous(h), right = Mesh::next(h);
    if (mesh_.twin(left) != kNone) {
      for (std::size_t i = lines_.size(); i-- > 0;) {  // the last one must come first
        if (lines_[i].left) go_left(left, face, lines_[i], i > 0 && lines_[i - 1].left, wavefront);
      }
    }
    if (mesh_.twin(right) != kNone) {
      for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (!lines_[i].right) continue;
        go_right(right, face, lines_[i], i > 0 && lines_[i - 1].right, wavefront);
      }
    }
  }

  template <class Wavefront>
  void reach_apex(Index h, const Line& line, Wavefront& wavefront) {
    const Index apex = mesh_.apex(h);
    if (!(line.to_apex < distances_[apex])) return;
    wavefront.reach(apex, line.to_apex);
    set_shortfall(apex, line.merged.shortfall);
  }

  template <class Recorder>
  static void count(const Line& line, Recorder& recorder) {
    if constexpr (Recorder::kRecords) {
      recorder.propagated(1, {std::uint32_t{line.strip.depth} + 1});
      if (line.left || line.right) recorder.valid(1);
    }
  }

  /// Drops lines that cross the shortest line to the apex.
  void drop_crossing(const Line& best, const FaceFrame& face) {
    const double crossing = line_crossing(best.merged.window, face);
    for (Line& line : lines_) {
      const Window& w = line.merged.window;
      const bool after = w.begin >= crossing, before = w.end <= crossing;
      if (&line == &best || (!after && !before)) continue;
      if (line.left && line.right) {
        if (is_shorter(best.to_apex, line.to_apex, rounding_)) {
          (after ? line.left : line.right) = false;
        }
      } else if (line.left ? after : before) {
        const Side side = line.left ? Side::left : Side::right;
        if (is_shorter(best.to_apex, bent_distance(w, side, face), rounding_)) {
          line.left = line.right = false;
        }
      }
    }
  }

  /// The ends of an edge are visible as such if neither the source nor the apex lies on it.
  static bool sees_ends(const Window& w, const FaceFrame& face) {
    return std::max(w.y, -face.apex_y) < -kFlatFace * face.length;
  }

  /// @param behind_another the line before it goes there, too
  template <class Wavefront>
  [[gnu::always_inline]] void go_left(Index side, const FaceFrame& face, const Line& line,
                                      bool behind_another, Wavefront& wavefront) {
    const Window& w = line.merged.window;
    const Point2 from = face.to_left(w.x, w.y);
    const double begin = w.begin > 0 || !sees_ends(w, face) ? face.on_left(w, w.begin) : 0;
    const double end = line.right ? face.left : face.on_left(w, w.end);
    const Window child = {begin, end, from.x, std::min(from.y, 0.0), w.sigma};
    if (is_void(child, face.left)) return;
    land(side, child, line.merged.shortfall, strip_of(line, behind_another, false), wavefront);
  }

  template <class Wavefront>
  [[gnu::always_inline]] void go_right(Index side, const FaceFrame& face, const Line& line,
                                       bool behind_another, Wavefront& wavefront) {
    const Window& w = line.merged.window;
    const Point2 from = face.to_right(w.x, w.y);
    const double begin = line.left ? 0 : face.on_right(w, w.begin);
    const bool to_head = w.end >= face.length && sees_ends(w, face);
    const double end = to_head ? face.right : face.on_right(w, w.end);
    const Window child = {begin, end, from.x, std::min(from.y, 0.0), w.sigma};
    if (is_void(child, face.right)) return;
    land(side, child, line.merged.shortfall, strip_of(line, behind_another, true), wavefront);
  }

  static Strip strip_of(const Line& line, bool behind_another, bool from_right) {
    const std::uint32_t apart = line.strip.apart;
    return {(line.strip.depth + 1) & kMostDepth, from_right,
            behind_another && apart > 0 ? (apart - 1) & kApart : 0};
  }

  // A window is passed in registers: if it were stored number by number and read in pairs, the read
  // would wait for the stores. So the code up to the node is inlined and takes it by value.

  /// @param side the half-edge through which the window leaves a face
  template <class Wavefront>
  [[gnu::always_inline]] void land(Index side, Window w, float shortfall, Strip strip,
                                   Wavefront& wavefront) {
    if (mesh_.crosses_non_manifold_edges()) [[unlikely]] {
      return land_on_sheets(side, w, shortfall, strip, wavefront);
    }
    put(mesh_.twin(side), w, shortfall, strip, wavefront);
  }

  template <class Wavefront>
  [[gnu::cold, gnu::noinline]] void land_on_sheets(Index side, Window w, float shortfall,
                                                   Strip strip, Wavefront& wavefront) {
    mesh_.for_each_sheet(side,
                         [&](Index g) { put(mesh_.twin(g), w, shortfall, strip, wavefront); });
  }

  template <class Wavefront>
  [[gnu::always_inline]] void put(Index h, Window w, float shortfall, Strip strip,
                                  Wavefront& wavefront) {
    if (free_ == kNil) add_node();
    const Index n = free_;
    Node& node = nodes_[n];
    free_ = node.next;
    Waiting& waiting = waiting_[h / 3];
    strip.side = h % 3 & 3;
    node = {{w, shortfall}, strip, waiting.first};
    waiting.first = n & kNil;
    ++window_count_;
    wavefront.land(h);
  }

  [[gnu::cold, gnu::noinline]] void add_node() {
    free_ = static_cast<Index>(nodes_.size());
    nodes_.push_back({{}, {}, kNil});
  }

  const Mesh& mesh_;
  double tolerance_;
  Parameters parameters_;
  MergeRule rule_;
  std::span<double> distances_;
  std::vector<std::uint16_t> shares_;  // by vertex: shortfall, as a share of the greatest one
  std::vector<Waiting> waiting_;       // by face
  std::vector<Node> nodes_;
  Index free_ = kNil;  // the first of the nodes that are not in use
  std::uint64_t window_count_ = 0;
  WindowBudget budget_;
  double rounding_;  // of coordinates
  // Scratch memory for one list. In from_right_, the first window is the last item.
  Stack<Line> lines_;
  Stack<Index> from_left_, from_right_;  // nodes
};

}  // namespace geodesic::edge_based
