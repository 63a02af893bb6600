#include "harness/recordings/isolines/arcs.h"

#include <algorithm>
#include <cmath>

#include "solvers/core/tolerance.h"

namespace geodesic::harness {
namespace {

double clockwise_angle(const Point2& axis, const Point2& v) {
  return std::atan2(-cross(axis, v), dot(axis, v));
}

// Whether a wedge may come nearer than its radius somewhere on an arc: false when the middle of the
// arc misses it by more than half the arc's length.
template <class Circle>
bool may_meet(const Arc& arc, const Point2& middle, const Circle& rival) {
  const double half = 0.5 * arc.length();
  const Point2 ray = middle - rival.centre;
  return cross(rival.first, ray) < half && cross(rival.last, ray) > -half &&
         norm(ray) - half < rival.radius;
}

}  // namespace

Point2 Arc::at(double angle) const {
  return centre + (radius * std::cos(angle)) * axis - (radius * std::sin(angle)) * left_of(axis);
}

void ArcFinder::set_face(const std::array<Point2, 3>& corners, std::span<const Wedge> wedges) {
  corners_ = corners;
  size_ = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 side = corners[(k + 1) % 3] - corners[k];
    size_ = std::max(size_, norm(side));
    directions_[k] = (1 / norm(side)) * side;
  }
  circles_.clear();
  for (const Wedge& w : wedges) {
    const Point2 first = w.first - w.centre, last = w.last - w.centre;
    if (!(norm(first) > 0 && norm(last) > 0)) continue;
    Circle circle{.centre = w.centre,
                  .sigma = w.sigma,
                  .first = (1 / norm(first)) * first,
                  .last = (1 / norm(last)) * last,
                  .opening = clockwise_angle(first, last),
                  .near = 0,
                  .far = 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 to_corner = corners[k] - w.centre;
      circle.near = std::max(circle.near, cross(directions_[k], to_corner));
      circle.far = std::max(circle.far, norm(to_corner));
    }
    circles_.push_back(circle);
  }
}

void ArcFinder::find(double level, std::vector<Arc>& arcs) {
  arcs.clear();
  level_ = level;
  for (Circle& circle : circles_) circle.radius = level - circle.sigma;
  for (const Circle& circle : circles_) {
    if (circle.near < circle.radius && circle.radius < circle.far) find_on(circle, arcs);
  }
  std::erase_if(arcs, [&](const Arc& arc) { return arc.length() < kSpeck * size_; });
}

void ArcFinder::find_on(const Circle& circle, std::vector<Arc>& arcs) {
  const Arc whole{circle.centre, circle.first, circle.radius, 0, circle.opening};
  cuts_.clear();
  for (std::size_t k = 0; k < 3; ++k) cut_by_line(whole, corners_[k], directions_[k]);
  within_.clear();
  parts_between_cuts(
      whole, [&](const Point2& p) { return in_face(p); }, within_);
  for (const Arc& arc : within_) add_visible(arc, circle, arcs);
}

// Adds the parts of an arc to which no other wedge offers a shorter path.
void ArcFinder::add_visible(const Arc& arc, const Circle& circle, std::vector<Arc>& arcs) {
  const Point2 middle = arc.middle();
  rivals_.clear();
  cuts_.clear();
  for (const Circle& rival : circles_) {
    if (&rival == &circle || !may_meet(arc, middle, rival)) continue;
    rivals_.push_back(&rival);
    cut_by_rival(arc, rival);
  }
  parts_between_cuts(
      arc, [&](const Point2& p) { return !is_beaten(p); }, arcs);
}

// Appends the parts of an arc, from cut to cut, whose middle is to be kept; neighbours as one.
template <class Keep>
void ArcFinder::parts_between_cuts(const Arc& arc, Keep keep, std::vector<Arc>& parts) {
  cuts_.insert(cuts_.end(), {arc.from, arc.to});
  std::sort(cuts_.begin(), cuts_.end());
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
    Arc part = arc;
    part.from = cuts_[i];
    part.to = cuts_[i + 1];
    const bool kept = part.from < part.to && keep(part.middle());
    if (kept && goes_on) {
      parts.back().to = part.to;
    } else if (kept) {
      parts.push_back(part);
    }
    // An empty part between two cuts at one place ends nothing.
    if (part.from < part.to) goes_on = kept;
  }
}

// Notes where an arc crosses a line. @param direction of length 1
void ArcFinder::cut_by_line(const Arc& arc, const Point2& point, const Point2& direction) {
  const double offset = dot(point - arc.centre, left_of(direction));
  const double square = (arc.radius - offset) * (arc.radius + offset);
  if (!(square > 0)) return;
  const Point2 foot = offset * left_of(direction);
  for (const double side : {-1.0, 1.0}) cut_at(arc, foot + (side * std::sqrt(square)) * direction);
}

// Notes where an arc crosses the circle and the rays of another wedge.
void ArcFinder::cut_by_rival(const Arc& arc, const Circle& rival) {
  cut_by_line(arc, rival.centre, rival.first);
  cut_by_line(arc, rival.centre, rival.last);
  const Point2 between = rival.centre - arc.centre;
  const double apart = norm(between);
  if (!(apart > 0)) return;
  const double difference = (arc.radius - rival.radius) * (arc.radius + rival.radius);
  const double along = 0.5 * (apart + difference / apart);
  // The common chord: perpendicular to the line of the centres.
  const Point2 direction = (1 / apart) * between;
  cut_by_line(arc, arc.centre + along * direction, left_of(direction));
}

void ArcFinder::cut_at(const Arc& arc, const Point2& from_centre) {
  const double angle = clockwise_angle(arc.axis, from_centre);
  if (arc.from < angle && angle < arc.to) cuts_.push_back(angle);
}

bool ArcFinder::in_face(const Point2& p) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(cross(directions_[k], p - corners_[k]) > 0)) return false;
  }
  return true;
}

// Whether a rival offers a point of the level a path that is shorter by more than rounding.
bool ArcFinder::is_beaten(const Point2& p) const {
  for (const Circle* rival : rivals_) {
    const Point2 ray = p - rival->centre;
    if (cross(rival->first, ray) <= 0 && cross(rival->last, ray) >= 0 &&
        norm(ray) < rival->radius - kPathMargin * level_) {
      return true;
    }
  }
  return false;
}

}  // namespace geodesic::harness
