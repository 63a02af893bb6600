#include "solvers/mmp/intersect.h"

#include <algorithm>

namespace geodesic::mmp {
namespace {

double square(double x) { return x * x; }

/// False when `winner`, which is shorter at both ends of an interval, is also shorter between them.
/// There it can lose only to a source nearer to the edge, with a sigma so much larger that this
/// source loses at both ends of the whole line.
bool may_lose_between(const Window& winner, const Window& other) {
  const double lead = other.sigma - winner.sigma;
  const double along = std::abs(winner.x - other.x);
  const double across = std::abs(winner.y) - std::abs(other.y);
  return lead >= along && square(lead) < square(along) + square(across);
}

Division whole(bool challenger) { return {.challenger_first = challenger}; }

/// Keeps the intersections strictly inside the interval and apart from each other.
void restrict_to(double from, double to, double narrowest, Crossings& found) {
  int kept = 0;
  double previous = from;
  for (int k = 0; k < found.count; ++k) {
    const double t = found.at[k];
    if (t - previous > narrowest && to - t > narrowest) found.at[kept++] = previous = t;
  }
  found.count = kept;
}

/// Compares the windows in the middle of each part, if the ends tie or contradict the cuts. The
/// middle of a long part may be so far from both sources that they tie: its end then decides.
Division divide_by_parts(const Window& challenger, const Window& incumbent, double from, double to,
                         const Crossings& cuts, int at_from, int at_to) {
  Division division;
  bool last = false;
  for (int k = 0; k <= cuts.count; ++k) {
    const double begin = k == 0 ? from : cuts.at[k - 1];
    const double end = k == cuts.count ? to : cuts.at[k];
    const double middle = 0.5 * (begin + end);
    int who = nearer(distance_at(challenger, middle), distance_at(incumbent, middle));
    if (who == 0 && k == 0) who = at_from;
    if (who == 0 && k == cuts.count) who = at_to;
    const bool wins = who < 0;
    if (k == 0) division.challenger_first = wins;
    if (k > 0 && wins != last) division.at[division.cuts++] = begin;
    last = wins;
  }
  return division;
}

}  // namespace

Crossings crossings(const Window& a, const Window& b) {
  // With t counted from a's source: r_a = r_b + s, where r_a^2 = t^2 + y_a^2 and
  // r_b^2 = (t - d)^2 + y_b^2. Squaring twice gives (s^2 - d^2) t^2 - k d t + s^2 y_a^2 - k^2 / 4 =
  // 0 with k as below. Its solutions count if k + 2 d t has the sign of s.
  const double d = b.x - a.x;
  const double s = b.sigma - a.sigma;
  const double k =
      (s - d) * (s + d) + (std::abs(a.y) - std::abs(b.y)) * (std::abs(a.y) + std::abs(b.y));
  const double leading = (s - d) * (s + d);
  const double constant = (s * a.y - 0.5 * k) * (s * a.y + 0.5 * k);
  // k^2 / 4 - y_a^2 (s^2 - d^2), factored. The difference would cancel where one source lies on the
  // edge's line, as sources at vertices do; the root would be off by 1e-8 of the edge.
  const double discriminant = 0.25 * (leading - square(std::abs(a.y) + std::abs(b.y))) *
                              (leading - square(std::abs(a.y) - std::abs(b.y)));
  if (!(discriminant > 0)) return {};  // apart or touching; coinciding sources
  const double half = 0.5 * k * d;
  const double root = std::abs(s) * std::sqrt(discriminant);
  // Each solution by the formula without cancellation in its sum.
  if (leading <= 0) {
    const double signed_root = (s < 0) == (d < 0) ? root : -root;
    const bool same_sign = (half < 0) == (signed_root < 0) && signed_root != 0 && half != 0;
    const double t = same_sign ? constant / (half + signed_root) : (half - signed_root) / leading;
    return {.count = 1, .at = {a.x + t}};
  }
  // Beyond the distance of the sources one of them always wins: the solutions belong to an ellipse.
  if (!(k * s > 0) || leading >= square(std::abs(a.y) - std::abs(b.y))) return {};
  const double larger = half < 0 ? half - root : half + root;
  const double t = larger / leading, u = constant / larger;
  return {.count = 2, .at = {a.x + std::min(t, u), a.x + std::max(t, u)}};
}

Division divide_at_intersections(const Window& challenger, const Window& incumbent, double from,
                                 double to, double narrowest, int at_from, int at_to) {
  if (at_from * at_to > 0) {
    const Window& winner = at_from < 0 ? challenger : incumbent;
    const Window& other = at_from < 0 ? incumbent : challenger;
    if (!may_lose_between(winner, other)) return whole(at_from < 0);
  }
  Crossings cuts = crossings(challenger, incumbent);
  restrict_to(from, to, narrowest, cuts);
  // Without a cut one window is nearer everywhere. If they tie at one end, because the lead is lost
  // in the rounding of far longer distances there, the other end decides.
  if (cuts.count == 0 && at_from + at_to != 0) return whole(at_from + at_to < 0);
  if (at_from * at_to < 0 && cuts.count == 1) {
    return {.challenger_first = at_from < 0, .cuts = 1, .at = {cuts.at[0]}};
  }
  return divide_by_parts(challenger, incumbent, from, to, cuts, at_from, at_to);
}

}  // namespace geodesic::mmp
