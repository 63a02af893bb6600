#include "solvers/edge_based/trim.h"

#include "solvers/core/tolerance.h"

namespace geodesic::edge_based {
namespace {

/// Two lines cross in the third vertex of the face below when they do within this share of its
/// height.
constexpr double kNearVertex = 1e-9;

/// Positive when (px, py) lies to the right of the line from the source of w through t.
double right_of(const Window& w, double t, double px, double py) {
  return (px - w.x) * -w.y - (t - w.x) * (py - w.y);
}

double right_of_scale(const Window& w, double t, double px, double py) {
  return kOnLine * (std::abs(px - w.x) * -w.y + std::abs(t - w.x) * std::abs(py - w.y));
}

/// Where the line from the source of w through (px, py) meets the edge; w.y < py.
double hit(const Window& w, double px, double py) { return w.x + (px - w.x) * (-w.y / (py - w.y)); }

/// `winner` is the shorter one at a point that the loser's line through position `p` passes.
/// Removes the lines of the loser between p and the direction of the winner's source. Nothing is
/// removed when that source lies on the line itself: it has no side then.
void beat(const Window& winner, Window& loser, double p) {
  if (!is_left_of_line(loser, p, winner.x, winner.y)) {
    if (is_right_of_line(loser, loser.end, winner.x, winner.y)) {
      loser.end = std::max(loser.begin, std::min(loser.end, p));
    } else if (p <= loser.begin) {
      loser.begin = std::clamp(hit(loser, winner.x, winner.y), loser.begin, loser.end);
    }
  } else if (!is_right_of_line(loser, p, winner.x, winner.y)) {
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
  const double closing = (left.x - left.end) * depth_right - (right.x - right.begin) * depth_left;
  if (!(closing > 0)) return;
  const double depth = (right.begin - left.end) * depth_left * depth_right / closing;
  if (!(depth < depth_left) || !(depth < depth_right)) return;
  // Lines that meet in the third vertex of the face pass it on different sides: they come through
  // different strips, and neither can be said to cross the other.
  if (!(depth < -face.below_y * (1 - kNearVertex))) return;
  const double x = left.end + (left.x - left.end) * (depth / depth_left);
  // Inside the face below: between its two other edges at this depth.
  const double share = face.below_y < 0 ? depth / -face.below_y : 0;
  if (x < face.below_x * share || x > face.length + (face.below_x - face.length) * share) return;
  decide(left, left.end, right, right.begin, x, -depth);
}

/// The distances that two windows give to a point of the edge.
struct Pair {
  double t = 0, first = 0, second = 0;
};
Pair pair_at(const Window& first, const Window& second, double t) {
  return {t, distance_at(first, t), distance_at(second, t)};
}

/// As `decide` for a point of the edge, both windows' lines through it passing at the point itself.
void decide_at(const Pair& at, Window& first, Window& second) {
  if (is_shorter(at.first, at.second)) {
    beat(first, second, at.t);
  } else if (is_shorter(at.second, at.first)) {
    beat(second, first, at.t);
  }
}

/// Whether the source of `of` lies on one side of all lines of `lines` through [begin, end].
bool is_to_one_side(const Window& lines, const Window& of, double begin, double end) {
  return (is_right_of_line(lines, begin, of.x, of.y) && is_right_of_line(lines, end, of.x, of.y)) ||
         (is_left_of_line(lines, begin, of.x, of.y) && is_left_of_line(lines, end, of.x, of.y));
}

/// The overlap of the windows where neither end of it was decided. Where the winner is nowhere
/// longer on it, the loser keeps only what reaches beyond it. A tie at one end is the usual case:
/// the loser's source is a vertex on the line that bounds the winner's pencil, and the winner's
/// shadow begins there.
///
/// Along the edge the difference of the two distances changes by the difference of the cosines of
/// their lines' angles, which keeps its sign while the loser's source stays on one side of the
/// winner's lines: then its two ends decide for the whole overlap.
void settle_overlap(Window& first, Window& second, const Pair& begin, const Pair& end) {
  const bool first_wins =
      !is_shorter(begin.second, begin.first) && !is_shorter(end.second, end.first);
  const auto shorten = [&](Window& loser) {
    if (begin.t == loser.begin) {
      loser.begin = end.t;
    } else if (end.t == loser.end) {
      loser.end = begin.t;
    }
  };
  if (first_wins && is_to_one_side(first, second, begin.t, end.t)) return shorten(second);
  const bool second_wins =
      !is_shorter(begin.first, begin.second) && !is_shorter(end.first, end.second);
  if (second_wins && is_to_one_side(second, first, begin.t, end.t)) shorten(first);
}

}  // namespace

bool is_shorter(double a, double b) { return a < b * (1 - kPathMargin); }

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

bool in_order(const Window& first, const Window& second) {
  return first.begin <= second.begin && first.end <= second.end &&
         is_left_of_line(second, second.begin, first.x, first.y) &&
         is_right_of_line(first, first.end, second.x, second.y);
}

bool is_void(const Window& w, double length) { return !(w.end - w.begin > kWindowWidth * length); }

void trim_pair(Window& first, Window& second, const Crossed& face) {
  if (in_order(first, second)) return;
  if (first.end <= second.begin) return trim_apart(first, second, face);
  if (second.end <= first.begin) return trim_apart(second, first, face);
  const double begin = std::max(first.begin, second.begin);
  Pair at_begin = pair_at(first, second, begin);
  decide_at(at_begin, first, second);
  const double end = std::min(first.end, second.end);
  const double still = std::max(first.begin, second.begin);
  if (end <= still) return;
  Pair at_end = pair_at(first, second, end);
  decide_at(at_end, first, second);
  const double left_begin = std::max(first.begin, second.begin);
  const double left_end = std::min(first.end, second.end);
  if (!(left_begin < left_end)) return;
  if (left_begin != begin) at_begin = pair_at(first, second, left_begin);
  if (left_end != end) at_end = pair_at(first, second, left_end);
  settle_overlap(first, second, at_begin, at_end);
}

}  // namespace geodesic::edge_based
