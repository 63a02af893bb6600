// What crosses a face in the approximate solver: the few windows of its edge that are left where
// neighbours are merged (merge.h), one or two in the mean. What they do to each other is decided at
// points of the edge and of the face beyond.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "solvers/core/prefetch.h"
#include "solvers/core/recorders.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/merge.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// A Crossing (wavefront.h).
class MergedCrossing {
 public:
  /// @param tolerance of distances, relative: they are off by no more
  MergedCrossing(const Mesh& mesh, double tolerance)
      : mesh_(mesh),
        tolerance_(tolerance),
        parameters_(tolerance >= kCoarse ? kForCoarse : kForFine),
        rule_{parameters_.room * tolerance * (1 - kShortfallRounding), parameters_.share_of_rest},
        waiting_(mesh.half_edge_count()),
        budget_(mesh),
        rounding_(coordinate_rounding(mesh)) {}

  void start(std::span<double> distances) {
    distances_ = distances;
    shortfalls_.assign(distances.size(), 0);
    std::ranges::fill(waiting_, Waiting{});
    nodes_.clear();
    free_ = kNil;
    window_count_ = 0;
    budget_.start();
  }
  void prefetch(Index h) const { geodesic::prefetch(&waiting_[h]); }
  void follow_edge(Index from, Index to) { shortfalls_[to] = shortfalls_[from]; }
  double rounding() const { return rounding_; }
  std::uint64_t window_count() const { return window_count_; }

  /// The truth is from D to D + s, and s is at most room * tolerance * D, where room is at most 2:
  /// what is given is off by at most tolerance * D on both sides.
  void finish() {
    for (std::size_t v = 0; v < distances_.size(); ++v) {
      const double s = shortfalls_[v];
      if (s > 0) distances_[v] += std::max(parameters_.given * s, s - tolerance_ * distances_[v]);
    }
  }

  template <class Visit>
  void for_each_window(Index h, const Visit& visit) const {
    for (Index n = waiting_[h].first; n != kNil; n = nodes_[n].next) visit(nodes_[n].merged.window);
    if (waiting_[h].sends) visit(sent_from_below(h).merged.window);
  }

  template <class Wavefront>
  void emit(Index side, const Point2& from, double distance, Index root, Wavefront& wavefront) {
    const HalfEdge& e = mesh_.half_edge(side);
    if (e.twin == kNone || !(e.length > 0)) return;
    if (root < mesh_.vertex_count() && !mesh_.crosses_non_manifold_edges()) {
      // The window is made when the list crosses: by then it is known what others leave of it.
      Waiting& waiting = waiting_[e.twin];
      window_count_ += 1 - waiting.sends;
      waiting.sends = 1;
      return wavefront.land(e.twin);
    }
    const float shortfall = root < mesh_.vertex_count() ? shortfalls_[root] : 0;
    land(side, {{{0, e.length, from.x, from.y, distance}, shortfall}, 1, true, 0, kNil}, wavefront);
  }

  template <class Wavefront>
  void cross(Index h, Wavefront& wavefront) {
    auto& recorder = wavefront.recorder();
    gather(h, recorder);
    if (lines_.empty()) return;
    budget_.spend(lines_.size());

    const FaceFrame face = face_frame(mesh_, h);
    const Index apex = mesh_.apex(h);
    const Line* best = classify(face);
    if (best != nullptr) {
      if (best->to_apex < distances_[apex]) {
        wavefront.reach(apex, best->to_apex);
        shortfalls_[apex] = best->merged.shortfall;
      }
      if (lines_.size() > 1) drop_crossing(*best, face);
    }
    if constexpr (recorder.kRecords) {
      for (const Line& line : lines_) {
        recorder.propagated(1, {line.depth + 1});
        if (line.left || line.right) recorder.valid(1);
      }
    }
    unfold(h, face, wavefront);
  }

 private:
  /// How the tolerance is used: measured on scans and terrain.
  struct Parameters {
    double room;           ///< the greatest shortfall over the tolerance, at most 2
    double given;          ///< share of a vertex's shortfall that is added to its distance
    double share_of_rest;  ///< MergeRule::share
  };
  static constexpr double kCoarse = 3e-3;
  static constexpr Parameters kForCoarse = {1.4, 0.2, 0.2}, kForFine = {2, 0.3, 0.3};
  /// Neighbours that are not joined are not tried again for so many faces, as long as they go the
  /// same way.
  static constexpr std::uint32_t kApart = 3;

  // Handles of nodes have 31 bits.
  static constexpr Index kNil = kNone >> 1;

  static constexpr std::uint32_t kMostDepth = (1u << 28) - 1;

  /// A window that waits on a half-edge.
  struct Node {
    MergedWindow merged;
    std::uint32_t depth : 28;  ///< of its strip, in faces
    bool from_right : 1;       ///< over the side of the face below that is next to the head
    std::uint32_t apart : 3;   ///< from its neighbour towards the origin, for so many faces
    Index next;
  };

  /// What waits on a half-edge: the last node first, and whether the third vertex of the face below
  /// sends a window.
  struct Waiting {
    Index first : 31 = kNil;
    Index sends : 1 = 0;
  };

  /// A window of the list that crosses.
  struct Line {
    MergedWindow merged;
    std::uint32_t depth, apart;
    double crossing = 0;  ///< where the line to the apex crosses the edge's line
    double to_apex = 0;   ///< along that line, where it passes the window
    bool left = false, right = false;
  };

  /// Moves the list of h into lines_, joined, without what paths over the ends of h beat.
  template <class Recorder>
  void gather(Index h, Recorder& recorder) {
    const auto timed = recorder.enter(Phase::trimming);
    const HalfEdge& edge = mesh_.half_edge(h);
    const EndpointBounds bounds(edge.length, distances_[edge.origin], distances_[mesh_.head(h)]);
    const Waiting waiting = waiting_[h];
    waiting_[h] = {};
    lines_.clear();
    from_right_.clear();
    for (Index n = waiting.first; n != kNil;) {
      const Node& node = nodes_[n];
      const bool too_long = is_strip_too_long(mesh_, node.depth + std::uint64_t{1});
      if (!too_long && !bounds.beat(node.merged.window)) {
        const Line line = {node.merged, node.depth, node.apart};
        if (node.from_right) {
          from_right_.push_back(line);
        } else {
          append(line, edge.length);
        }
      }
      --window_count_;
      recorder.created(1);
      n = release(n);
    }
    if (waiting.sends != 0) {
      --window_count_;
      recorder.created(1);
      const Line line = not_left_to_others(sent_from_below(h), edge.length);
      const Window& w = line.merged.window;
      if (!is_void(w, edge.length) && !bounds.beat(w)) append(line, edge.length);
    }
    for (std::size_t i = from_right_.size(); i-- > 0;) append(from_right_[i], edge.length);
  }

  /// The window that the third vertex of the face below sends over the whole of h.
  Line sent_from_below(Index h) const {
    const Index below = mesh_.twin(h), v = mesh_.apex(below);
    const Point2 from = apex_from_beyond(mesh_.half_edge(below));
    return {{{0, mesh_.half_edge(h).length, from.x, from.y, distances_[v]}, shortfalls_[v]}, 1, 0};
  }

  /// What the windows that came over the sides of the face below leave of that window (merge.h).
  Line not_left_to_others(Line sent, double length) const {
    const double flat = -kFlatFace * length;
    Window& p = sent.merged.window;
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
    if (!from_right_.empty() && from_right_.back().merged.window.y <= flat) {
      const Window& b = from_right_.back().merged.window;
      if (is_left_of_line(b, b.begin, p.x, p.y) && is_left_of_line(b, b.end, p.x, p.y) &&
          is_no_longer(b, b.begin)) {
        p.end = b.begin;
      }
    }
    return sent;
  }

  /// Puts a window behind the others, and joins the last two as long as that leaves one.
  void append(const Line& line, double length) {
    lines_.push_back(line);
    while (lines_.size() > 1) {
      Line &a = lines_[lines_.size() - 2], &b = lines_.back();
      if (b.apart > 0) return;
      switch (join(a.merged, b.merged, length, rounding_, rule_)) {
        case Joined::neither:
          b.apart = kApart;
          return;
        case Joined::merged:
          a.depth = std::max(a.depth, b.depth);
          break;
        case Joined::first_gone:
          a = b;
          break;
        case Joined::second_gone:
          lines_.pop_back();
          return;
      }
      lines_.pop_back();
    }
  }

  /// Finds out on which sides of the apex the lines of each window pass it.
  /// @return the one with the shortest line to the apex; null when none sees it
  const Line* classify(const FaceFrame& face) {
    const double slack = kApexTolerance * face.length;
    const Line* best = nullptr;
    for (Line& line : lines_) {
      const Window& w = line.merged.window;
      line.crossing = line_crossing(w, face);
      line.left = !(line.crossing < w.begin - slack);
      line.right = !(line.crossing > w.end + slack);
      if (!line.left || !line.right) continue;
      line.to_apex = distance_through(w, face.apex_x, face.apex_y);
      if (best == nullptr || line.to_apex < best->to_apex) best = &line;
    }
    return best;
  }

  /// Drops the lines that cross the shortest one to the apex.
  void drop_crossing(const Line& best, const FaceFrame& face) {
    for (Line& line : lines_) {
      const Window& w = line.merged.window;
      const bool after = w.begin >= best.crossing, before = w.end <= best.crossing;
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

  template <class Wavefront>
  void unfold(Index h, const FaceFrame& face, Wavefront& wavefront) {
    const Index left = Mesh::previous(h), right = Mesh::next(h);
    // The ends of an edge are seen as such where neither the source nor the apex lies on it.
    const auto is_off = [&](const Window& w) {
      return std::max(w.y, -face.apex_y) < -kFlatFace * face.length;
    };
    const auto child = [](const Line& line, bool behind_another, const Window& w, bool from_right) {
      Node node{{w, line.merged.shortfall}, 0, from_right, 0, kNil};
      node.depth = (line.depth + 1) & kMostDepth;
      if (behind_another && line.apart > 0) node.apart = (line.apart - 1) & kApart;
      return node;
    };
    if (mesh_.twin(left) != kNone) {
      for (std::size_t i = lines_.size(); i-- > 0;) {  // the last one is to be the first
        const Line& line = lines_[i];
        if (!line.left) continue;
        const Window& w = line.merged.window;
        const Point2 from = face.to_left(w.x, w.y);
        const double begin = w.begin > 0 || !is_off(w) ? face.on_left(w, w.begin) : 0;
        const double end = line.right ? face.left : face.on_left(w, w.end);
        const Window on_left = {begin, end, from.x, std::min(from.y, 0.0), w.sigma};
        if (is_void(on_left, face.left)) continue;
        land(left, child(line, i > 0 && lines_[i - 1].left, on_left, false), wavefront);
      }
    }
    if (mesh_.twin(right) != kNone) {
      for (std::size_t i = 0; i < lines_.size(); ++i) {
        const Line& line = lines_[i];
        if (!line.right) continue;
        const Window& w = line.merged.window;
        const Point2 from = face.to_right(w.x, w.y);
        const double begin = line.left ? 0 : face.on_right(w, w.begin);
        const double end = w.end < face.length || !is_off(w) ? face.on_right(w, w.end) : face.right;
        const Window on_right = {begin, end, from.x, std::min(from.y, 0.0), w.sigma};
        if (is_void(on_right, face.right)) continue;
        land(right, child(line, i > 0 && lines_[i - 1].right, on_right, true), wavefront);
      }
    }
  }

  /// @param side through which the window leaves a face
  template <class Wavefront>
  void land(Index side, const Node& window, Wavefront& wavefront) {
    if (!mesh_.crosses_non_manifold_edges()) return put(mesh_.twin(side), window, wavefront);
    mesh_.for_each_sheet(side, [&](Index g) { put(mesh_.twin(g), window, wavefront); });
  }

  template <class Wavefront>
  void put(Index h, const Node& window, Wavefront& wavefront) {
    if (free_ == kNil) add_node();
    const Index n = free_;
    free_ = nodes_[n].next;
    nodes_[n] = window;
    nodes_[n].next = waiting_[h].first;
    waiting_[h].first = n & kNil;
    ++window_count_;
    wavefront.land(h);
  }

  [[gnu::cold, gnu::noinline]] void add_node() {
    free_ = static_cast<Index>(nodes_.size());
    nodes_.push_back({{}, 0, false, 0, kNil});
  }

  /// @return the node behind it
  Index release(Index n) { return std::exchange(nodes_[n].next, std::exchange(free_, n)); }

  const Mesh& mesh_;
  double tolerance_;
  Parameters parameters_;
  MergeRule rule_;
  std::span<double> distances_;
  std::vector<float> shortfalls_;  // of the distances, rounded up
  std::vector<Waiting> waiting_;   // by half-edge
  std::vector<Node> nodes_;
  Index free_ = kNil;  // the first of the nodes that are not in use
  std::uint64_t window_count_ = 0;
  WindowBudget budget_;
  double rounding_;  // of coordinates
  // Scratch of one list. Of what came over the right side the first one is the last.
  std::vector<Line> lines_, from_right_;
};

}  // namespace geodesic::edge_based
