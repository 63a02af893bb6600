#include "solvers/edge_based/trim.h"

#include "solvers/core/tolerance.h"

namespace geodesic::edge_based {
namespace {

/// Pseudo-sources often lie exactly on the line that bounds a neighbour's pencil: the vertex that
/// split the pencil became a source itself. Relative to the two lengths whose product is the sign.
constexpr double kOnLine = 1e-11;

/// Positive when (px, py) lies to the right of the line from the source of w through t.
double right_of(const Window& w, double t, double px, double py) {
  return (px - w.x) * -w.y - (t - w.x) * (py - w.y);
}

double right_of_scale(const Window& w, double t, double px, double py) {
  return kOnLine * (std::abs(px - w.x) * -w.y + std::abs(t - w.x) * std::abs(py - w.y));
}

bool is_shorter(double a, double b) { return a < b * (1 - kPathMargin); }

/// Where the line from the source of w through (px, py) meets the edge; w.y < py.
double hit(const Window& w, double px, double py) {
  return w.x + (px - w.x) * (-w.y / (py - w.y));
}

/// `winner` is the shorter one at a point that the loser's line through position `p` passes.
/// Removes the lines of the loser between p and the direction of the winner's source.
void beat(const Window& winner, Window& loser, double p) {
  const double side = right_of(loser, p, winner.x, winner.y);
  if (side > 0) {
    if (is_right_of_line(loser, loser.end, winner.x, winner.y)) {
      loser.end = std::max(loser.begin, std::min(loser.end, p));
    } else if (p <= loser.begin) {
      loser.begin = std::clamp(hit(loser, winner.x, winner.y), loser.begin, loser.end);
    }
  } else if (side < 0) {
    if (is_left_of_line(loser, loser.begin, winner.x, winner.y)) {
      loser.begin = std::min(loser.end, std::max(loser.begin, p));
    } else if (p >= loser.end) {
      loser.end = std::clamp(hit(loser, winner.x, winner.y), loser.begin, loser.end);
    }
  }
}

/// Decides at the point (px, py), which the line of `a` through `pa` and that of `b` through `pb`
/// pass, which window is beaten.
void decide(Window& a, double pa, Window& b, double pb, double px, double py) {
  const double da = distance_through(a, px, py);
  const double db = distance_through(b, px, py);
  if (is_shorter(da, db)) {
    beat(a, b, pb);
  } else if (is_shorter(db, da)) {
    beat(b, a, pa);
  }
}

/// `left` ends before `right` begins. Their facing boundary lines may cross below the edge.
void trim_apart(Window& left, Window& right, const Crossed& face) {
  const double depth_left = -left.y, depth_right = -right.y;
  // The lines drift by drift_left / depth_left per unit of depth.
  const double closing =
      (left.x - left.end) * depth_right - (right.x - right.begin) * depth_left;
  if (!(closing > 0)) return;
  const double depth = (right.begin - left.end) * depth_left * depth_right / closing;
  if (!(depth < depth_left) || !(depth < depth_right) || !(depth <= -face.below_y)) return;
  const double x = left.end + (left.x - left.end) * (depth / depth_left);
  // Inside the face below: between its two other edges at this depth.
  const double share = face.below_y < 0 ? depth / -face.below_y : 0;
  if (x < face.below_x * share || x > face.length + (face.below_x - face.length) * share) return;
  decide(left, left.end, right, right.begin, x, -depth);
}

}  // namespace

Crossed crossed_face(const Mesh& mesh, Index h) {
  const HalfEdge& below = mesh.half_edge(mesh.twin(h));
  return {mesh.half_edge(h).length, below.length - below.apex_x, -below.apex_y};
}

bool is_right_of_line(const Window& w, double t, double px, double py) {
  return right_of(w, t, px, py) > -right_of_scale(w, t, px, py);
}

bool is_left_of_line(const Window& w, double t, double px, double py) {
  return right_of(w, t, px, py) < right_of_scale(w, t, px, py);
}

bool beaten_by_ends(const Window& w, double length, double at_origin, double at_head) {
  return is_shorter(at_origin + w.end, distance_at(w, w.end)) ||
         is_shorter(at_head + (length - w.begin), distance_at(w, w.begin));
}

bool is_void(const Window& w, double length) { return !(w.end - w.begin > kWindowWidth * length); }

void trim_pair(Window& first, Window& second, const Crossed& face) {
  if (first.end <= second.begin) return trim_apart(first, second, face);
  if (second.end <= first.begin) return trim_apart(second, first, face);
  const double begin = std::max(first.begin, second.begin);
  decide(first, begin, second, begin, begin, 0);
  const double end = std::min(first.end, second.end);
  if (end <= std::max(first.begin, second.begin)) return;
  decide(first, end, second, end, end, 0);
}

}  // namespace geodesic::edge_based
