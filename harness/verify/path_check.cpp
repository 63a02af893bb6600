#include "harness/verify/path_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "meshes/oracles/view.h"
#include "solvers/core/messages.h"

namespace geodesic::harness {
namespace {

using Weights = std::array<double, 3>;

/// Relative rounding of edge lengths, in a solver's frames and in a point's position on an edge.
constexpr Real kLastPlace = 2.2e-16L;

/// Rounding of coordinates in the plane, relative to the sides around them.
constexpr Real kLaid = 4 * std::numeric_limits<Real>::epsilon();

/// A point of a path, and the face over which the path continues, by the mesh's internal numbers.
struct Stop {
  InternalPoint at;
  Index face;
};

std::vector<Stop> stops_of(const Mesh& mesh, const Path& path) {
  std::vector<Stop> stops;
  for (const PathPoint& point : path.points) {
    const bool goes_on = point.face != kNone;
    stops.push_back({in_internal_numbers(mesh, point.at),
                     goes_on ? mesh.numbers().internal_face(point.face) : kNone});
  }
  return stops;
}

/// Barycentric coordinates of a point in any face; nothing when the point is not on the face.
std::optional<Weights> weights_on(const Mesh& mesh, Index face, const InternalPoint& point) {
  if (point.is_vertex()) {
    const Triangle corners = mesh.triangle(face);
    const auto corner = std::ranges::find(corners, point.vertex);
    if (corner == corners.end()) return {};
    Weights weights{};
    weights[static_cast<std::size_t>(corner - corners.begin())] = 1;
    return weights;
  }
  if (point.face == face) return point.weights;
  if (edge_under(point) == kNone) return {};
  const std::vector<InternalPoint> images = in_every_face(mesh, point);
  const auto image = std::ranges::find(images, face, &InternalPoint::face);
  if (image == images.end()) return {};
  return image->weights;
}

Real length_between(const Mesh& mesh, Index face, const Weights& a, const Weights& b) {
  std::array<Real, 3> sum{};
  const Triangle corners = mesh.triangle(face);
  const std::array<Real, 3> origin = extended(mesh.position(corners[0]));
  for (std::size_t k = 1; k < 3; ++k) {
    const auto side = subtract(extended(mesh.position(corners[k])), origin);
    const Real weight = Real{b[k]} - a[k];
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * side[c];
  }
  return geodesic::norm(sum);
}

Finding wrong(const std::string& what, std::size_t point = kNone) {
  const std::string where = point == kNone ? "" : " at its point " + std::to_string(point);
  return Violation{.what = "the path " + what + where, .kind = "the path " + what};
}

/// A face unfolded into the plane.
struct LaidFace {
  Index face;
  std::array<PlanePoint, 3> corners;

  PlanePoint at(const Weights& weights) const {
    PlanePoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      p.x += weights[k] * corners[k].x;
      p.y += weights[k] * corners[k].y;
    }
    return p;
  }
};

LaidFace first_face(const Mesh& mesh, Index face) {
  LaidFace laid{face, {}};
  laid.corners[1] = {straight_distance(mesh, mesh.origin(3 * face), mesh.head(3 * face)), 0};
  laid.corners[2] = lay_out_apex(mesh, 3 * face, laid.corners[0], laid.corners[1]);
  return laid;
}

/// Unfolds the face of h next to the face of its twin.
LaidFace next_face(const Mesh& mesh, Index h, const LaidFace& before) {
  const Index twin = mesh.twin(h);
  LaidFace laid{h / 3, {}};
  PlanePoint &origin = laid.corners[h % 3], &head = laid.corners[Mesh::next(h) % 3];
  head = before.corners[twin % 3];
  origin = before.corners[Mesh::next(twin) % 3];
  laid.corners[Mesh::previous(h) % 3] = lay_out_apex(mesh, h, origin, head);
  return laid;
}

Real longest_side(const LaidFace& laid) {
  const auto& [a, b, c] = laid.corners;
  return std::max({distance(a, b), distance(b, c), distance(c, a)});
}

/// Direction of a stretch's line at a vertex where the stretch ends, in a face there.
struct Beam {
  Index corner = kNone;  ///< the half-edge of the face that leaves the vertex
  Real from_right = 0;   ///< angle from that half-edge to the line, counter-clockwise
  Real to_left = 0;      ///< angle from the line to the other side at the vertex
};

/// Part of a path between two consecutive vertices on it.
struct Stretch {
  Real length = 0;    ///< of the straight line
  Real rounding = 0;  ///< of a point's offset from the line, over all faces
  Beam first, last;
};

class StraightCheck {
 public:
  StraightCheck(const Mesh& mesh, const Path& path, const Tolerance& tolerance)
      : mesh_(mesh), points_(stops_of(mesh, path)), length_(path.length()), tolerance_(tolerance) {}

  Finding run() {
    std::optional<Stretch> before;
    for (std::size_t i = 0; i + 1 < points_.size();) {
      std::size_t end = i + 1;
      while (end + 1 < points_.size() && !points_[end].at.is_vertex()) ++end;
      Stretch stretch;
      if (Finding finding = unfold(i, end, stretch)) return finding;
      if (before) {
        if (Finding finding = check_vertex(i, *before, stretch)) return finding;
      }
      before = stretch;
      i = end;
    }
    return {};
  }

 private:
  Finding unfold(std::size_t first, std::size_t last, Stretch& stretch) const {
    std::vector<PlanePoint> line;
    LaidFace laid = first_face(mesh_, points_[first].face);
    const LaidFace start = laid;
    line.push_back(at(laid, first));
    Real longest = longest_side(laid), turned = 0;
    for (std::size_t i = first; i < last; ++i) {
      const Index face = points_[i].face;
      if (face != laid.face) {
        const auto h = side_into(face, points_[i].at);
        if (!h || mesh_.twin(*h) / 3 != laid.face) return wrong("jumps", i);
        laid = next_face(mesh_, *h, laid);
        longest = std::max(longest, longest_side(laid));
        // Rounding rotates the faces beyond a side that is far shorter than the others.
        turned += kLaid * longest / mesh_.half_edge(*h).length;
      }
      line.push_back(at(laid, i + 1));
    }
    stretch.length = distance(line.front(), line.back());
    // Every unfolded face adds the rounding of its sides; 2 is for the rounding of this check.
    stretch.rounding = (kLastPlace * static_cast<Real>(line.size() + 2) + turned) * longest;
    const Real slack = allowed(stretch.length) + stretch.rounding;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Real off = std::abs(turn(line.front(), line.back(), line[i]));
      if (off > slack * stretch.length) {
        const Real relative = off / (stretch.length * stretch.length);
        return wrong("is not straight: it leaves its line by " +
                         significant(static_cast<double>(relative), 2) + " of its length",
                     first + i);
      }
    }
    stretch.first = beam(start, first, line.front(), line.back());
    stretch.last = beam(laid, last, line.back(), line.front());
    return {};
  }

  Real allowed(Real length) const {
    return tolerance_.relative * std::max<Real>(length, tolerance_.least);
  }

  PlanePoint at(const LaidFace& laid, std::size_t i) const {
    return laid.at(*weights_on(mesh_, laid.face, points_[i].at));
  }

  /// The half-edge of the face on which the point lies; nothing when the point is on no edge.
  std::optional<Index> side_into(Index face, const InternalPoint& point) const {
    const Index h = edge_under(point);
    if (h == kNone) return {};
    return h / 3 == face ? h : mesh_.twin(h);
  }

  Beam beam(const LaidFace& laid, std::size_t i, const PlanePoint& from,
            const PlanePoint& to) const {
    const InternalPoint& point = points_[i].at;
    Beam beam;
    for (Index h = 3 * laid.face; point.is_vertex() && h < 3 * laid.face + 3; ++h) {
      if (mesh_.origin(h) != point.vertex) continue;
      beam.corner = h;
      beam.from_right = angle(from, laid.corners[Mesh::next(h) % 3], to);
      beam.to_left = angle(from, to, laid.corners[Mesh::previous(h) % 3]);
    }
    return beam;
  }

  /// Angle at `at`, counter-clockwise from the direction of a to that of b, between -pi and pi.
  static Real angle(const PlanePoint& at, const PlanePoint& a, const PlanePoint& b) {
    const PlanePoint u{a.x - at.x, a.y - at.y}, v{b.x - at.x, b.y - at.y};
    return std::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
  }

  Finding check_vertex(std::size_t i, const Stretch& in, const Stretch& out) const {
    const Index v = points_[i].at.vertex;
    Real radius = kInfinity;  // a disk of this radius around v lies in its faces
    for (const Index h : mesh_.outgoing(v)) {
      if (!(mesh_.half_edge(h).apex_y > 0) || !(mesh_.half_edge(h).length > 0)) return {};
      radius = std::min(radius, Real{mesh_.half_edge(Mesh::next(h)).apex_y});
    }
    const Real left = between(in.last, out.first), right = between(out.first, in.last);
    const Real least = std::min(left, right);
    const Real a = in.length, b = out.length;
    if (least < std::numbers::pi) {
      // The chord between two points of the path in the disk saves this length.
      const Real near = std::min({a, b, radius}), half = std::sin(least / 2);
      const Real saved = 2 * near * (1 - half);
      if (saved > allowed(length_)) {
        return wrong(
            "has an angle of " + significant(static_cast<double>(least), 6) + " on one side", i);
      }
    }
    if (mesh_.is_pseudo_source(v)) return {};
    // A stretch this short has no direction: it may lead to a vertex next to a source and back.
    if (std::min(a, b) <= allowed(length_)) return {};
    const Real pi = std::numbers::pi_v<Real>;
    const Real bend = std::min(std::abs(left - pi), std::abs(right - pi));
    // Offset of the vertex from the straight line between the stretches' other ends. It may be as
    // large as rounding allows for any other point of the path (`unfold`).
    const Real off = bend * a * b / (a + b);
    // Negated for NaN and infinity: beyond an edge without length a line has no direction.
    if (!(off > allowed(a + b) + std::max(in.rounding, out.rounding))) return {};
    return wrong("bends where none may, by " + significant(static_cast<double>(bend), 2), i);
  }

  /// Angle around a vertex from one line to another, counter-clockwise. Infinite when a boundary
  /// lies between them or they are in different fans.
  Real between(const Beam& from, const Beam& to) const {
    Real sum = from.to_left;
    if (from.corner == to.corner && to.from_right >= from.from_right) {
      return to.from_right - from.from_right;
    }
    Index h = mesh_.twin(Mesh::previous(from.corner));
    for (; h != to.corner; h = mesh_.twin(Mesh::previous(h))) {
      if (h == kNone || h == from.corner) return kInfinity;
      const HalfEdge& e = mesh_.half_edge(h);
      sum += std::atan2(Real{e.apex_y}, Real{e.apex_x});
    }
    return sum + to.from_right;
  }

  const Mesh& mesh_;
  const std::vector<Stop> points_;
  const double length_;
  const Tolerance& tolerance_;
};

}  // namespace

Finding check_path(const Mesh& mesh, const Query& query, const SurfacePoint& end, double distance,
                   const Path& path, const Tolerance& tolerance) {
  if (path.points.empty()) return wrong("has no points");
  if (path.source >= query.sources.size()) return wrong("comes from no source of the query");
  const Source& source = query.sources[path.source];
  if (path.points.front().at != source.at) return wrong("does not begin in its source");
  if (path.points.back().at != end) return wrong("does not end in its end");
  if (path.points.back().face != kNone) return wrong("goes on at its end");
  const std::vector<Stop> stops = stops_of(mesh, path);
  const double slack = tolerance.relative * std::max(distance, tolerance.least);
  Real travelled = 0;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const PathPoint& point = path.points[i];
    if (point.position != position_of(mesh, point.at)) return wrong("is elsewhere", i);
    if (!(std::abs(travelled - point.travelled) <= slack)) {
      return wrong("is not as long as it says", i);
    }
    if (i + 1 == stops.size()) break;
    const Index face = stops[i].face;
    if (face >= mesh.external_face_count()) return wrong("leaves the surface", i);
    const auto from = weights_on(mesh, face, stops[i].at);
    const auto to = weights_on(mesh, face, stops[i + 1].at);
    if (!from || !to) return wrong("leaves its face", i);
    travelled += length_between(mesh, face, *from, *to);
  }
  const double length = static_cast<double>(travelled + source.distance);
  const double error = relative_error(length, distance, tolerance.least);
  if (std::abs(error) <= tolerance.relative) return {};
  return wrong("is " + significant(length) + " long, the distance is " + significant(distance) +
               " (relative error " + significant(error, 2) + ")");
}

Finding check_straight(const Mesh& mesh, const Path& path, const Tolerance& tolerance) {
  return StraightCheck(mesh, path, tolerance).run();
}

}  // namespace geodesic::harness
