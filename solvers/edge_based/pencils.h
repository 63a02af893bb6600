// The windows of one list while they cross a face, where windows are merged: so few that vectors do
// not pay.
#pragma once

#include <cstdint>
#include <vector>

#include "solvers/edge_based/merge.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"
#include "solvers/edge_based/window_lists.h"

namespace geodesic::edge_based {

/// The windows in the order in which their lines meet the edge. What they do to each other is
/// decided at points of the edge and of the face beyond (merge.h).
class Pencils {
 public:
  bool empty() const { return lines_.empty(); }
  std::size_t size() const { return lines_.size(); }

  void clear() { lines_.clear(); }
  void add(const Pencil& pencil) { lines_.push_back({pencil}); }

  /// Drops what one window beats of another, and merges neighbours.
  /// @param length of the edge
  /// @param rounding of coordinates (trim.h)
  void trim_and_merge(double length, double rounding, double tolerance) {
    for (std::size_t i = 1; i < lines_.size(); ++i) {
      for (std::size_t before = 0; before < i; ++before) {
        Window &a = lines_[before].pencil.window, &b = lines_[i].pencil.window;
        if (a.end > b.begin && b.end > a.begin) trim_overlap(a, b, {length, 0, 0, rounding});
      }
    }
    std::size_t count = 0;
    for (const Line& line : lines_) {
      if (is_void(line.pencil.window, length)) continue;
      if (count > 0 && merge(lines_[count - 1].pencil, line.pencil, length, tolerance)) continue;
      lines_[count++] = line;
    }
    lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(count), lines_.end());
  }

  /// Finds out on which sides of the apex the lines of each window pass it.
  /// @return the window that gives the least distance to the apex; null when none sees it
  const Pencil* classify(const FaceFrame& face, double& distance) {
    const double slack = kApexTolerance * face.length;
    best_ = nullptr;
    distance = kInfinity;
    for (Line& line : lines_) {
      const Window& w = line.pencil.window;
      line.crossing = line_crossing(w, face);
      line.left = !(line.crossing < w.begin - slack);
      line.right = !(line.crossing > w.end + slack);
      if (!line.left || !line.right) continue;
      const double through = distance_through(w, face.apex_x, face.apex_y);
      if (through < distance) {
        distance = through;
        best_ = &line;
      }
    }
    return best_ == nullptr ? nullptr : &best_->pencil;
  }

  /// Drops the lines that cross the shortest one to the apex, of that length.
  void drop_crossing(const FaceFrame& face, double distance, double rounding) {
    if (best_ == nullptr) return;
    for (Line& line : lines_) {
      const Window& w = line.pencil.window;
      const bool after = w.begin >= best_->crossing, before = w.end <= best_->crossing;
      if (&line == best_ || (!after && !before)) continue;
      if (line.left && line.right) {
        const double own = distance_through(w, face.apex_x, face.apex_y);
        if (is_shorter(distance, own, rounding)) (after ? line.left : line.right) = false;
      } else if (line.left ? after : before) {
        const Side side = line.left ? Side::left : Side::right;
        if (is_shorter(distance, bent_distance(w, side, face), rounding)) {
          line.left = line.right = false;
        }
      }
    }
  }

  /// Unfolds what leads to the left edge, or to the right one, into a segment with room for all.
  template <class Segment>
  void unfold_left(const FaceFrame& face, Segment& out) const {
    unfold(face.left, out, [&](const Line& line, Window& w) {
      if (!line.left) return false;
      const Point2 from = face.to_left(w.x, w.y);
      const double end = line.right ? face.left : face.on_left(w, w.end);
      w = {face.on_left(w, w.begin), end, from.x, std::min(from.y, 0.0), w.sigma};
      return true;
    });
  }
  template <class Segment>
  void unfold_right(const FaceFrame& face, Segment& out) const {
    unfold(face.right, out, [&](const Line& line, Window& w) {
      if (!line.right) return false;
      const Point2 from = face.to_right(w.x, w.y);
      const double begin = line.left ? 0 : face.on_right(w, w.begin);
      w = {begin, face.on_right(w, w.end), from.x, std::min(from.y, 0.0), w.sigma};
      return true;
    });
  }

  /// Calls visit(pencil, goes_on) for each window.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const Line& line : lines_) visit(line.pencil, line.left || line.right);
  }

 private:
  struct Line {
    Pencil pencil;
    double crossing = 0;  ///< where the line to the apex crosses the edge's line
    bool left = false, right = false;
  };

  template <class Segment, class OntoSide>
  void unfold(double length, Segment& out, const OntoSide& onto_side) const {
    for (const Line& line : lines_) {
      Window w = line.pencil.window;
      if (!onto_side(line, w) || is_void(w, length)) continue;
      const std::uint32_t i = out.count++;
      out.array(kBegin)[i] = w.begin;
      out.array(kEnd)[i] = w.end;
      out.array(kX)[i] = w.x;
      out.array(kY)[i] = w.y;
      out.array(kSigma)[i] = w.sigma;
      out.array(kDepth)[i] = line.pencil.depth + 1;
      out.array(kShortfall)[i] = line.pencil.shortfall;
    }
  }

  std::vector<Line> lines_;
  const Line* best_ = nullptr;
};

}  // namespace geodesic::edge_based
