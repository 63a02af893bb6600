#include "solvers/paths/funnel.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <utility>

#include "solvers/core/tolerance.h"

namespace geodesic {
namespace {

/// The position of a point of a face that is laid out.
Point2 place_of(const Mesh& mesh, const InternalPoint& point, const LaidFace& laid) {
  std::array<double, 3> weights = point.weights;
  if (point.is_vertex()) {
    for (std::size_t k = 0; k < 3; ++k) weights[k] = mesh.triangle(laid.face)[k] == point.vertex;
  } else if (point.face != laid.face) {
    for (const InternalPoint& image : in_every_face(mesh, point)) {
      if (image.face == laid.face) weights = image.weights;
    }
  }
  Point2 place{0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    place.x += weights[k] * laid.corners[k].x;
    place.y += weights[k] * laid.corners[k].y;
  }
  return place;
}

/// The lines from an apex to both ends of the last gate. From the apex outwards, the line to the
/// left end turns left at each of its vertices, and the line to the right end turns right.
class Funnel {
 public:
  explicit Funnel(const Point2& apex) : chain_{{.at = apex}} {}

  /// Goes on to the next gate, one end of which is new.
  void add(const Bend& corner) {
    const bool left = corner.left;
    while (size_on(left) > 0 && !bends_at(on(left, 1), on(left, 0), corner)) pop(left);
    while (size_on(left) == 0 && size_on(!left) > 0 &&
           passes(chain_[apex_], on(!left, size_on(!left) - 1), corner)) {
      bends_.push_back(on(!left, size_on(!left) - 1));
      // The vertices before the new apex are on neither line any more.
      if (left) {
        chain_.pop_front();
      } else {
        chain_.pop_back();
        --apex_;
      }
    }
    if (left) {
      chain_.push_front(corner);
      ++apex_;
    } else {
      chain_.push_back(corner);
    }
  }

  /// The bends of the line to the last corner that was added, on the left.
  std::vector<Bend> bends_to_last() && {
    for (std::size_t i = apex_; i > 1; --i) bends_.push_back(chain_[i - 1]);
    return std::move(bends_);
  }

 private:
  /// Number of vertices of a line, without the apex.
  std::size_t size_on(bool left) const { return left ? apex_ : chain_.size() - 1 - apex_; }
  /// The vertex of a line at this place from its end.
  const Bend& on(bool left, std::size_t from_end) const {
    return left ? chain_[from_end] : chain_[chain_.size() - 1 - from_end];
  }
  void pop(bool left) {
    if (left) {
      chain_.pop_front();
      --apex_;
    } else {
      chain_.pop_back();
    }
  }

  /// How far the line from a to c turns to its left at b, times lengths; and its rounding.
  struct Bent {
    double by, rounding;
    bool goes_on;  ///< c is farther away than b
  };
  static Bent bent(const Bend& a, const Bend& b, const Bend& c) {
    const double near = length_between(a.at, b.at), far = length_between(a.at, c.at);
    return {turn(a.at, b.at, c.at), kPathThrough * far * std::max(near, far), far >= near};
  }
  static bool bends_at(const Bend& a, const Bend& b, const Bend& c) {
    const Bent bend = bent(a, b, c);
    const double away = c.left ? bend.by : -bend.by;
    return away > (bend.goes_on ? -bend.rounding : 0);
  }
  /// Whether b, a vertex of the other line, lies between a and c.
  static bool passes(const Bend& a, const Bend& b, const Bend& c) {
    const Bent bend = bent(a, b, c);
    const double across = c.left ? -bend.by : bend.by;
    return across > (bend.goes_on ? -bend.rounding : 0);
  }

  std::deque<Bend> chain_;  ///< from the left end over the apex to the right end
  std::size_t apex_ = 0;    ///< its index
  std::vector<Bend> bends_;
};

/// Index of the first crossing from i on that does not have the vertex of crossing i on this side.
std::size_t end_of_run(const Mesh& mesh, const Crossings& crossings, std::size_t i, bool left) {
  const Index v = vertex_beside(mesh, crossings[i], left);
  while (i < crossings.size() && vertex_beside(mesh, crossings[i], left) == v) ++i;
  return i;
}

void measure_bends(const Mesh& mesh, const Crossings& crossings, SleeveLine& line) {
  for (std::size_t i = 0; i < line.bends.size(); ++i) {
    Bend& bend = line.bends[i];
    const Point2 from = i == 0 ? line.begin : line.bends[i - 1].at;
    const Point2 to = i + 1 == line.bends.size() ? line.end : line.bends[i + 1].at;
    bend.before = length_between(from, bend.at);
    bend.behind = length_between(bend.at, to);
    line.length += bend.before;
    bend.inside = angle_inside(bend.at, from, line.gates[bend.first].end(!bend.left), bend.left) +
                  angle_inside(bend.at, line.gates[bend.end - 1].end(!bend.left), to, bend.left);
    for (std::size_t k = bend.first + 1; k < bend.end; ++k) {
      bend.inside += angle_before(mesh, crossings[k], bend.left);
    }
  }
  const Point2& last = line.bends.empty() ? line.begin : line.bends.back().at;
  line.length += length_between(last, line.end);
}

}  // namespace

LaidFace lay_out(const Mesh& mesh, Index face) {
  const HalfEdge& e = mesh.half_edge(3 * face);
  return {face, {Point2{0, 0}, {e.length, 0}, {e.apex_x, e.apex_y}}};
}

LaidFace lay_out_beyond(const Mesh& mesh, const LaidFace& laid, Index side) {
  const Index twin = mesh.twin(side);
  const HalfEdge& e = mesh.half_edge(twin);
  const auto [origin, head] = gate_of(laid, side);
  const double length = length_between(origin, head);
  const Point2 along = length > 0
                           ? Point2{(head.x - origin.x) / length, (head.y - origin.y) / length}
                           : Point2{1, 0};
  LaidFace next{twin / 3, {}};
  next.corners[twin % 3] = origin;
  next.corners[Mesh::next(twin) % 3] = head;
  next.corners[Mesh::previous(twin) % 3] = {origin.x + along.x * e.apex_x - along.y * e.apex_y,
                                            origin.y + along.y * e.apex_x + along.x * e.apex_y};
  return next;
}

SleeveLine shortest_line(const Mesh& mesh, const Sleeve& sleeve) {
  const Crossings& crossings = sleeve.crossings;
  SleeveLine line;
  LaidFace laid = lay_out(mesh, sleeve.face);
  line.begin = place_of(mesh, sleeve.begin, laid);
  Funnel funnel(line.begin);
  std::size_t run_end[2] = {0, 0};  // of the vertex on the right and on the left
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    line.gates.push_back(gate_of(laid, crossings[i]));
    laid = lay_out_beyond(mesh, laid, crossings[i]);
    for (const bool left : {false, true}) {
      if (i < run_end[left]) continue;
      run_end[left] = end_of_run(mesh, crossings, i, left);
      funnel.add({.vertex = vertex_beside(mesh, crossings[i], left),
                  .left = left,
                  .first = i,
                  .end = run_end[left],
                  .at = line.gates[i].end(left)});
    }
  }
  line.end = place_of(mesh, sleeve.end, laid);
  funnel.add({.left = true, .at = line.end});
  line.bends = std::move(funnel).bends_to_last();
  measure_bends(mesh, crossings, line);
  return line;
}

double angle_inside(const Point2& at, const Point2& from, const Point2& to, bool left) {
  const Point2 a{from.x - at.x, from.y - at.y}, b{to.x - at.x, to.y - at.y};
  const double across = a.x * b.y - a.y * b.x, along = a.x * b.x + a.y * b.y;
  const double angle = std::atan2(left ? across : -across, along);
  // A straight angle, in a face without area, has either sign.
  return angle < kNearTurn - std::numbers::pi ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace geodesic
