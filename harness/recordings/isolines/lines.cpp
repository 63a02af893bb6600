#include "harness/recordings/isolines/lines.h"

#include <algorithm>
#include <cmath>

namespace geodesic::harness {
namespace {

// Farther than this, relative to the longest edge of the face, nothing is joined.
constexpr double kReach = 1e-4;

// The part of the chord error that goes to replacing arcs by chords; the rest to leaving out.
constexpr double kChordShare = 0.25;

class Joiner {
 public:
  Joiner(std::span<const Arc> arcs, std::span<const BorderCrossing> crossings, double size,
         double sagitta)
      : arcs_(arcs),
        crossings_(crossings),
        reach_(kReach * size),
        sagitta_(sagitta),
        arc_used_(arcs.size(), false),
        crossing_used_(crossings.size(), false) {}

  /// Another line: from a crossing as long as there are any, then from an arc that is left.
  bool take(Line& line) {
    line.clear();
    for (std::size_t i = 0; i < crossings_.size() && line.empty(); ++i) {
      if (crossings_[i].begins && !crossing_used_[i]) append_crossing(i, line);
    }
    for (std::size_t i = 0; i < arcs_.size() && line.empty(); ++i) {
      if (!arc_used_[i]) append_arc(i, line);
    }
    if (line.empty()) return false;
    while (go_on(line)) {
    }
    const bool comes_back = line.size() > 2 && is_near(line.front().at, line.back().at);
    if (comes_back && line.front().crossing == kNone) line.back() = line.front();
    return true;
  }

  /// True for the rest of an arc that rounding has made twice.
  bool is_left_over(const Line& line) const {
    return line[0].crossing == kNone &&
           std::ranges::all_of(line, [&](const LinePoint& p) { return is_near(p.at, line[0].at); });
  }

 private:
  // Appends what begins nearest to the line's end.
  bool go_on(Line& line) {
    const Point2 end = line.back().at;
    if (line.size() > 1 && line.back().crossing != kNone) return false;
    double nearest = reach_;
    const auto is_nearer = [&](const Point2& p) {
      const double distance = separation(p, end);
      if (distance <= nearest) nearest = distance;
      return distance <= nearest;
    };
    std::size_t arc = arcs_.size(), crossing = crossings_.size();
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      const bool open = !crossings_[i].begins && !crossing_used_[i];
      if (open && is_nearer(crossings_[i].at)) crossing = i;
    }
    for (std::size_t i = 0; i < arcs_.size(); ++i) {
      if (!arc_used_[i] && is_nearer(arcs_[i].begin())) arc = i;
    }
    if (arc < arcs_.size()) {
      append_arc(arc, line);
    } else if (crossing < crossings_.size()) {
      // It is the point at which the last arc ends.
      if (line.back().crossing == kNone) line.pop_back();
      append_crossing(crossing, line);
    }
    return arc < arcs_.size() || crossing < crossings_.size();
  }

  void append_crossing(std::size_t i, Line& line) {
    crossing_used_[i] = true;
    line.push_back({crossings_[i].at, static_cast<Index>(i)});
  }

  // Appends points of an arc without its first if the line is there already.
  void append_arc(std::size_t i, Line& line) {
    arc_used_[i] = true;
    const Arc& arc = arcs_[i];
    if (line.empty()) line.push_back({arc.begin()});
    // A chord over an angle t leaves its circle by about r t^2 / 8.
    const double angle = arc.to - arc.from;
    const double chords = std::ceil(angle / std::sqrt(8 * sagitta_ / arc.radius));
    for (double k = 1; k < chords; ++k) line.push_back({arc.at(arc.from + angle * (k / chords))});
    line.push_back({arc.end()});
  }

  bool is_near(const Point2& a, const Point2& b) const { return separation(a, b) <= reach_; }

  std::span<const Arc> arcs_;
  std::span<const BorderCrossing> crossings_;
  double reach_, sagitta_;
  std::vector<bool> arc_used_, crossing_used_;
};

double distance_to_chord(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 chord = b - a;
  const double square = dot(chord, chord);
  const double t = square > 0 ? std::clamp(dot(p - a, chord) / square, 0.0, 1.0) : 0.0;
  return separation(p, a + t * chord);
}

// Marks what stays between two points that do.
void mark_kept(const Line& line, std::size_t first, std::size_t last, double error,
               std::vector<bool>& kept) {
  double farthest = error;
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double distance = distance_to_chord(line[i].at, line[first].at, line[last].at);
    if (distance > farthest) {
      farthest = distance;
      at = i;
    }
  }
  if (at == first) return;
  kept[at] = true;
  mark_kept(line, first, at, error, kept);
  mark_kept(line, at, last, error, kept);
}

// Leaves out points where that moves the line by no more than an error (Douglas, Peucker 1973).
void simplify(Line& line, double error) {
  if (line.size() < 3) return;
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  mark_kept(line, 0, line.size() - 1, error, kept);
  std::size_t next = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) line[next++] = line[i];
  }
  line.resize(next);
}

}  // namespace

void join_arcs(std::span<const Arc> arcs, std::span<const BorderCrossing> crossings, double size,
               double chord_error, std::vector<Line>& lines) {
  lines.clear();
  Joiner joiner(arcs, crossings, size, kChordShare * chord_error);
  Line line;
  while (joiner.take(line)) {
    if (joiner.is_left_over(line)) continue;
    simplify(line, (1 - kChordShare) * chord_error);
    lines.push_back(line);
  }
}

}  // namespace geodesic::harness
