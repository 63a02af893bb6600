#include "solvers/edge_based/split.h"

#include "solvers/core/tolerance.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {
namespace {

double slack(const Window& w, double t, const FaceFrame& face) {
  return kApexTolerance * face.length * (std::abs(t - w.x) - w.y);
}

}  // namespace

Side sides_seen(const Window& w, const FaceFrame& face) {
  if (apex_side(w, w.begin, face) < -slack(w, w.begin, face)) return Side::right;
  if (apex_side(w, w.end, face) > slack(w, w.end, face)) return Side::left;
  return Side::both;
}

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
    // Its line to the apex is the longer one: lines between that and the separator's source are
    // beaten, which is one whole side unless the source lies inside the pencil.
    if (crossing(w, face) <= separator.crossing) {
      return is_right_of_line(w, w.end, best.x, best.y) ? Side::left : Side::both;
    }
    return is_left_of_line(w, w.begin, best.x, best.y) ? Side::right : Side::both;
  }
  const bool crosses = seen == Side::left ? w.begin >= separator.crossing
                                          : w.end <= separator.crossing;
  if (crosses && bent_distance(w, seen, face) >= separator.distance) return Side::none;
  return seen;
}

}  // namespace geodesic::edge_based
