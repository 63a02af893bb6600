#include "harness/recordings/isolines/crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace geodesic::harness {
namespace {

// What lies outside the level over less than this, relative to the edge, is a rounding error
// between two windows.
constexpr double kWeld = 1e-12;

struct Part {
  double begin, end;
};

// Where a window is nearer than the level.
std::optional<Part> inside(const Window& w, double level) {
  const double radius = level - w.sigma, height = std::abs(w.y);
  if (!(radius > height)) return std::nullopt;
  const double half = std::sqrt((radius - height) * (radius + height));
  const Part part{std::max(w.begin, w.x - half), std::min(w.end, w.x + half)};
  return part.begin < part.end ? std::optional(part) : std::nullopt;
}

// The union of parts that are added in the order of their beginnings, as crossings.
class Union {
 public:
  Union(const EdgeDistance& edge, double level, std::vector<Crossing>& result)
      : length_(edge.length),
        origin_inside_(edge.at_origin < level),
        head_inside_(edge.at_head < level),
        result_(result) {}

  void add(const Part& next) {
    if (!empty_ && next.begin <= last_.end + kWeld * length_) {
      last_.end = std::max(last_.end, next.end);
      return;
    }
    close();
    last_ = next;
    empty_ = false;
  }

  void close() {
    if (empty_) return;
    if (!(origin_inside_ && last_.begin <= 0)) result_.push_back({last_.begin, true});
    if (!(head_inside_ && last_.end >= length_)) result_.push_back({last_.end, false});
  }

 private:
  double length_;
  bool origin_inside_, head_inside_;
  bool empty_ = true;
  Part last_{0, 0};
  std::vector<Crossing>& result_;
};

}  // namespace

void find_crossings(const EdgeDistance& edge, double level, std::vector<Crossing>& result) {
  result.clear();
  Union parts(edge, level, result);
  // The ends offer ways along the edge: they are inside whenever their distances are, whatever
  // rounding does to the windows.
  const double from_origin = level - edge.at_origin, to_head = level - edge.at_head;
  if (from_origin > 0) parts.add({0, std::min(from_origin, edge.length)});
  std::optional<Part> at_head;
  if (to_head > 0) at_head = {std::max(edge.length - to_head, 0.0), edge.length};
  for (const Window& w : edge.windows) {
    const auto part = inside(w, level);
    if (!part) continue;
    if (at_head && at_head->begin <= part->begin) parts.add(*std::exchange(at_head, std::nullopt));
    parts.add(*part);
  }
  if (at_head) parts.add(*at_head);
  parts.close();
}

}  // namespace geodesic::harness
