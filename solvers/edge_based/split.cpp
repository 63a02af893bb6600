#include "solvers/edge_based/split.h"

#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {
double bent_distance(const Window& w, Side side, const FaceFrame& face) {
  const double bend = side == Side::left ? w.end : w.begin;
  const double dx = face.apex_x - bend;
  return distance_at(w, bend) + std::sqrt(dx * dx + face.apex_y * face.apex_y);
}

double crossing(const Window& w, const FaceFrame& face) {
  const double t = w.x + (face.apex_x - w.x) * (-w.y / (face.apex_y - w.y));
  return std::clamp(t, w.begin, w.end);
}

Side sides_kept(const Window& w, Side seen, const Separator& separator, const Window& best,
                const FaceFrame& face) {
  if (seen == Side::both) {
    // Windows that meet in the line to the apex both see it: a tie leaves both whole.
    if (!is_shorter(separator.distance, distance_through(w, face.apex_x, face.apex_y))) return seen;
    // Its line to the apex is the longer one: lines between that and the separator's source are
    // beaten, which is one whole side unless the source lies inside the pencil.
    const double t = crossing(w, face);
    if (!is_left_of_line(w, t, best.x, best.y)) {
      return is_right_of_line(w, w.end, best.x, best.y) ? Side::left : Side::both;
    }
    if (!is_right_of_line(w, t, best.x, best.y)) {
      return is_left_of_line(w, w.begin, best.x, best.y) ? Side::right : Side::both;
    }
    return Side::both;
  }
  const bool crosses =
      seen == Side::left ? w.begin >= separator.crossing : w.end <= separator.crossing;
  if (crosses && is_shorter(separator.distance, bent_distance(w, seen, face))) return Side::none;
  return seen;
}

}  // namespace geodesic::edge_based
