// What crosses a face in the approximate solver: the windows of its edge, with neighbours merged
// (merge.h); so few that vectors do not pay. What they do to each other is decided at points of the
// edge and of the face beyond.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "solvers/core/recorders.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/merge.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"
#include "solvers/edge_based/window_lists.h"

namespace geodesic::edge_based {

/// A Crossing (wavefront.h).
class MergedCrossing {
 public:
  /// @param shortfall the greatest, relative to distances
  /// @param share of a vertex's shortfall, which is added to its distance in the end
  MergedCrossing(const Mesh& mesh, double shortfall, double share)
      : mesh_(mesh),
        shortfall_(shortfall),
        share_(share),
        lists_(mesh.half_edge_count(), kShortfall + 1),
        budget_(mesh),
        rounding_(coordinate_rounding(mesh)) {}

  void start(std::span<double> distances) {
    distances_ = distances;
    shortfalls_.assign(distances.size(), 0);
    lists_.clear();
    budget_.start();
  }
  bool is_empty(Index h) const { return lists_.is_empty(h); }
  void prefetch(Index h) const { lists_.prefetch(h); }
  void follow_edge(Index from, Index to) { shortfalls_[to] = shortfalls_[from]; }
  double rounding() const { return rounding_; }
  std::uint64_t window_count() const { return lists_.window_count(); }

  void finish() {
    for (std::size_t v = 0; v < distances_.size(); ++v) {
      distances_[v] += share_ * double{shortfalls_[v]};
    }
  }

  template <class Visit>
  void for_each_window(Index h, const Visit& visit) const {
    lists_.for_each_segment(h, [&](const Segment& segment) {
      for (std::size_t i = 0; i < segment.count; ++i) visit(window_of(segment, i));
    });
  }

  template <class Wavefront>
  void emit(Index side, const Point2& from, double distance, Index root, Wavefront& wavefront) {
    const HalfEdge& e = mesh_.half_edge(side);
    if (e.twin == kNone || !(e.length > 0)) return;
    Segment* segment = lists_.allocate(1);
    const double shortfall = root < mesh_.vertex_count() ? double{shortfalls_[root]} : 0;
    add(*segment, {{0, e.length, from.x, from.y, distance}, shortfall, 1});
    land(side, segment, Place::back, wavefront);
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
    if (best != nullptr && best->to_apex < distances_[apex]) {
      wavefront.reach(apex, best->to_apex);
      shortfalls_[apex] = rounded_up(best->merged.shortfall);
    }
    if (best != nullptr && lines_.size() > 1) drop_crossing(*best, face);
    if constexpr (recorder.kRecords) {
      for (const Line& line : lines_) {
        recorder.propagated(1, {static_cast<std::uint32_t>(line.merged.depth) + 1});
        if (line.left || line.right) recorder.valid(1);
      }
    }
    unfold(Mesh::previous(h), face.left, Place::front, wavefront, [&](const Line& line, Window& w) {
      const Point2 from = face.to_left(w.x, w.y);
      const double end = line.right ? face.left : face.on_left(w, w.end);
      w = {face.on_left(w, w.begin), end, from.x, std::min(from.y, 0.0), w.sigma};
      return line.left;
    });
    unfold(Mesh::next(h), face.right, Place::back, wavefront, [&](const Line& line, Window& w) {
      const Point2 from = face.to_right(w.x, w.y);
      const double begin = line.left ? 0 : face.on_right(w, w.begin);
      w = {begin, face.on_right(w, w.end), from.x, std::min(from.y, 0.0), w.sigma};
      return line.right;
    });
  }

 private:
  static constexpr unsigned kShortfall = kRoot;  // of windows that carry no root

  /// A window of the list that crosses.
  struct Line {
    MergedWindow merged;
    double crossing = 0;  ///< where the line to the apex crosses the edge's line
    double to_apex = 0;   ///< along that line, where it passes the window
    bool left = false, right = false;
  };

  /// Moves the list of h into lines_, without what paths over the ends of h or other windows of the
  /// list beat.
  template <class Recorder>
  void gather(Index h, Recorder& recorder) {
    const auto timed = recorder.enter(Phase::trimming);
    const HalfEdge& edge = mesh_.half_edge(h);
    const EndpointBounds bounds(edge.length, distances_[edge.origin], distances_[mesh_.head(h)]);
    lines_.clear();
    lists_.consume(h, [&](const Segment& segment) {
      recorder.created(segment.count);
      for (std::size_t i = 0; i < segment.count; ++i) {
        const Window w = window_of(segment, i);
        const double depth = segment.array(kDepth)[i];
        const bool too_long = is_strip_too_long(mesh_, static_cast<std::uint64_t>(depth) + 1);
        if (too_long || bounds.beat(w)) continue;
        lines_.push_back({{w, segment.array(kShortfall)[i], depth}});
      }
    });
    if (lines_.size() > 1) trim_and_merge(edge.length);
  }

  void trim_and_merge(double length) {
    const EdgeBelow edge = {length, 0, 0, rounding_};
    for (std::size_t i = 1; i < lines_.size(); ++i) {
      for (std::size_t before = 0; before < i; ++before) {
        Window &a = lines_[before].merged.window, &b = lines_[i].merged.window;
        if (a.end > b.begin && b.end > a.begin) trim_overlap(a, b, edge);
      }
    }
    std::size_t count = 0;
    for (const Line& line : lines_) {
      if (is_void(line.merged.window, length)) continue;
      if (count > 0 && merge(lines_[count - 1].merged, line.merged, length, shortfall_)) continue;
      lines_[count++] = line;
    }
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(count), lines_.end());
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

  /// @param onto_side called as (line, window): unfolds it; false when the line does not go there
  template <class Wavefront, class OntoSide>
  void unfold(Index side, double length, Place place, Wavefront& wavefront,
              const OntoSide& onto_side) {
    if (mesh_.twin(side) == kNone) return;
    Segment* out = lists_.allocate(lines_.size());
    for (const Line& line : lines_) {
      Window w = line.merged.window;
      if (!onto_side(line, w) || is_void(w, length)) continue;
      add(*out, {w, line.merged.shortfall, line.merged.depth + 1});
    }
    land(side, out, place, wavefront);
  }

  static void add(Segment& segment, const MergedWindow& merged) {
    segment.array(kDepth)[segment.count] = merged.depth;
    segment.array(kShortfall)[segment.count] = merged.shortfall;
    segment.add(merged.window);
  }

  /// @param segment windows that leave a face through `side`; nothing when it is empty
  template <class Wavefront>
  void land(Index side, Segment* segment, Place place, Wavefront& wavefront) {
    if (segment->count == 0) return lists_.release(segment);
    mesh_.for_each_sheet(side, [&](Index g) {
      lists_.add(mesh_.twin(g), g == side ? segment : lists_.copy(*segment), place);
      wavefront.land(mesh_.twin(g));
    });
  }

  /// What is a float already stays as it is: nothing grows from vertex to vertex.
  static float rounded_up(double shortfall) {
    const auto near = static_cast<float>(shortfall);
    return near < shortfall ? std::nextafter(near, std::numeric_limits<float>::max()) : near;
  }

  const Mesh& mesh_;
  double shortfall_, share_;
  std::span<double> distances_;
  std::vector<float> shortfalls_;  // of the distances, rounded up
  WindowLists lists_;
  WindowBudget budget_;
  double rounding_;          // of coordinates
  std::vector<Line> lines_;  // scratch of one list
};

}  // namespace geodesic::edge_based
