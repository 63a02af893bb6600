#include "solvers/paths/straightest.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "solvers/core/tolerance.h"
#include "solvers/paths/path_points.h"
#include "solvers/paths/trace.h"

namespace geodesic {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kNoAngle = std::numeric_limits<double>::quiet_NaN();
/// A line of more edges fills the memory.
constexpr double kMostEdges = 1e7;
/// A line passes a vertex at this distance from it, relative to the length so far and the side.
constexpr double kThroughVertex = 1e-12;

double determinant(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }
double inner(const Point2& a, const Point2& b) { return a.x * b.x + a.y * b.y; }
Point2 minus(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }
/// The angle from a to b, counter-clockwise.
double angle_between(const Point2& a, const Point2& b) {
  return std::atan2(determinant(a, b), inner(a, b));
}

/// The corner of a face at a vertex.
struct Corner {
  Index half_edge;  ///< leaves the vertex
  double begin;     ///< direction of the half-edge
  double angle;
  std::size_t fan;
};

/// The directions at a vertex that has faces; none for kNone.
class Directions {
 public:
  Directions(const Mesh& mesh, Index v) {
    if (v == kNone) return;
    std::vector<Index> left(mesh.outgoing(v).begin(), mesh.outgoing(v).end());
    std::ranges::sort(left, {}, [&](Index h) { return mesh.numbers().external_face(h / 3); });
    while (!left.empty()) {
      const Index first = first_of_fan(mesh, left.front());
      const double begin = total_;
      Index h = first;
      do {
        const HalfEdge& e = mesh.half_edge(h);
        if (e.length == 0 || mesh.half_edge(Mesh::previous(h)).length == 0) {
          throw std::invalid_argument("at " + name_of(mesh, InternalPoint(v)) +
                                      " an edge without a length has no direction");
        }
        corners_.push_back({h, total_, std::atan2(e.apex_y, e.apex_x), fans_.size()});
        total_ += corners_.back().angle;
        std::erase(left, h);
        h = mesh.twin(Mesh::previous(h));
      } while (h != kNone && h != first);
      fans_.push_back({begin, total_ - begin, h == first});
    }
  }

  double total() const { return total_; }
  const std::vector<Corner>& corners() const { return corners_; }

  /// The corner of a direction from 0 to the total.
  const Corner& at(double angle) const {
    const auto after = std::ranges::upper_bound(corners_, angle, {}, &Corner::begin);
    return after == corners_.begin() ? *after : *std::prev(after);
  }
  const Corner& of(Index half_edge) const {
    return *std::ranges::find(corners_, half_edge, &Corner::half_edge);
  }

  /// The direction that leaves the same angle on both sides as one of a corner; none at a boundary.
  std::optional<double> opposite(const Corner& corner, double in_corner) const {
    const auto& [begin, total, closed] = fans_[corner.fan];
    if (!closed) return std::nullopt;
    const double angle = corner.begin - begin + in_corner + total / 2;
    return begin + (angle < total ? angle : angle - total);
  }

 private:
  struct Fan {
    double begin, total;
    bool closed;
  };

  /// The half-edge itself in a closed fan, otherwise the boundary edge where the fan begins.
  static Index first_of_fan(const Mesh& mesh, Index h) {
    for (Index at = h;;) {
      const Index twin = mesh.twin(at);
      if (twin == kNone) return at;
      at = Mesh::next(twin);
      if (at == h) return h;
    }
  }

  std::vector<Corner> corners_;
  std::vector<Fan> fans_;
  double total_ = 0;
};

/// A point and a direction in the frame of a half-edge of the face that a line is about to cross.
struct Ray {
  Index half_edge;
  Point2 at, ahead;
  std::array<double, 3> weights;  ///< of `at`: of the origin, the head and the apex
};

Ray ray_from_corner(const Corner& corner, double in_corner) {
  return {corner.half_edge, {0, 0}, {std::cos(in_corner), std::sin(in_corner)}, {1, 0, 0}};
}

class Line {
 public:
  Line(const Mesh& mesh, const InternalPoint& begin) : mesh_(mesh), points_(mesh) {
    points_.add(begin, kNone, 0);
  }

  StraightestLine run(Ray ray, double length) {
    left_ = length;
    Index idle = 0;  // faces crossed at one point
    for (std::optional<Ray> next = ray; next;) {
      const double before = left_;
      next = cross_face(*next);
      idle = left_ < before ? 0 : idle + 1;
      if (idle > mesh_.half_edge_count()) {
        throw std::runtime_error("a straightest line does not go on; please report this mesh");
      }
    }
    return {points_.from_begin(), at_boundary_};
  }

 private:
  /// How a ray leaves its face: by a point of a side, from corner `side` to the next one, or
  /// through a corner.
  struct Exit {
    std::size_t side = 0;
    double share = 0;  ///< of the side, from its begin
    double step = -kInfinity;
    bool through_corner = false;  ///< `side`, with share 0
  };

  /// Goes on to the next face. @return nothing at the end of the line
  std::optional<Ray> cross_face(const Ray& ray) {
    const HalfEdge& e = mesh_.half_edge(ray.half_edge);
    const Corners corners = {Point2{0, 0}, {e.length, 0}, {e.apex_x, e.apex_y}};
    const Exit exit = exit_of(ray, corners, kThroughVertex * (travelled_ + e.length));
    if (exit.step >= left_) return end_in_face(ray, exit);
    left_ -= exit.step;
    travelled_ += exit.step;
    const Index leaving = side_at(ray.half_edge, exit.side);
    if (exit.through_corner) return pass_vertex(ray, corners, exit, leaving);
    const double length = mesh_.half_edge(leaving).length, to_head = (1 - exit.share) * length;
    points_.add_edge_point(leaving, to_head, exit.step);
    const Index twin = mesh_.twin(leaving);
    if (twin == kNone) return end_at_boundary();
    const Point2 along = minus(corners[(exit.side + 1) % 3], corners[exit.side]);
    const Point2 unit = {along.x / length, along.y / length};
    return Ray{twin,
               {to_head, 0},
               {-inner(unit, ray.ahead), -determinant(unit, ray.ahead)},
               {exit.share, 1 - exit.share, 0}};
  }

  using Corners = std::array<Point2, 3>;

  static Index side_at(Index h, std::size_t side) {
    return side == 0 ? h : side == 1 ? Mesh::next(h) : Mesh::previous(h);
  }

  static Exit exit_of(const Ray& ray, const Corners& corners, double slack) {
    std::array<double, 3> off, ahead;  // of the corners: to the left of the line, and along it
    Exit exit;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 to = minus(corners[k], ray.at);
      off[k] = determinant(ray.ahead, to);
      ahead[k] = inner(ray.ahead, to);
      const bool is_through = std::abs(off[k]) <= slack && ahead[k] > 0 && ray.weights[k] != 1;
      if (is_through && ahead[k] > exit.step) exit = {k, 0, ahead[k], true};
    }
    if (exit.through_corner) return exit;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t j = (k + 1) % 3;
      if (!(off[k] <= 0 && off[j] >= 0)) continue;
      const double share = off[k] < off[j] ? off[k] / (off[k] - off[j]) : 0;
      const double step = ahead[k] + share * (ahead[j] - ahead[k]);
      if (step > exit.step) exit = {k, share, step, false};
    }
    exit.step = std::max(exit.step, 0.0);
    return exit;
  }

  std::optional<Ray> pass_vertex(const Ray& ray, const Corners& corners, const Exit& exit,
                                 Index leaves) {
    const Index vertex = mesh_.origin(leaves);
    points_.add(InternalPoint(vertex), ray.half_edge / 3, exit.step);
    const Directions directions(mesh_, vertex);
    const Corner& corner = directions.of(leaves);
    const double back = angle_between(minus(corners[(exit.side + 1) % 3], corners[exit.side]),
                                      {-ray.ahead.x, -ray.ahead.y});
    const auto out = directions.opposite(corner, std::clamp(back, 0.0, corner.angle));
    if (!out) return end_at_boundary();
    const Corner& into = directions.at(*out);
    return ray_from_corner(into, *out - into.begin);
  }

  std::optional<Ray> end_at_boundary() {
    at_boundary_ = left_ > 0;
    return std::nullopt;
  }

  std::optional<Ray> end_in_face(const Ray& ray, const Exit& exit) {
    const double part = exit.step > 0 ? left_ / exit.step : 0;
    std::array<double, 3> out{};
    out[exit.side] = 1 - exit.share;
    out[(exit.side + 1) % 3] = exit.share;
    InternalPoint end;
    end.face = ray.half_edge / 3;
    for (Index k = 0; k < 3; ++k) {
      const double weight = ray.weights[k] + part * (out[k] - ray.weights[k]);
      const Index corner = (ray.half_edge + k) % 3;
      if (weight >= 1 - kWeightSum) end = InternalPoint(mesh_.origin(3 * end.face + corner));
      if (end.is_vertex()) break;
      end.weights[corner] = weight <= kWeightSum ? 0 : weight;
    }
    points_.add(end, ray.half_edge / 3, left_);
    return std::nullopt;
  }

  const Mesh& mesh_;
  PathPoints points_;
  double left_ = 0, travelled_ = 0;
  bool at_boundary_ = false;
};

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

void refuse_crossed(const Mesh& mesh) {
  if (!mesh.crosses_non_manifold_edges()) return;
  refuse("a mesh whose paths cross non-manifold edges has no orientation for angles");
}

InternalPoint checked(const Mesh& mesh, const SurfacePoint& point) {
  const std::string defect = defect_of(mesh, point);
  if (!defect.empty()) refuse(defect);
  refuse_crossed(mesh);
  const InternalPoint own = in_internal_numbers(mesh, point);
  if (own.is_vertex() && mesh.outgoing(own.vertex).empty()) {
    refuse(name_of(mesh, own) + " has no face, and so no directions");
  }
  return own;
}

/// Direction of side k of a face in the frame of its side 0.
Point2 side_of(const Mesh& mesh, Index face, Index k) {
  const HalfEdge& e = mesh.half_edge(3 * face);
  if (k == 0) return {e.length, 0};
  if (k == 1) return {e.apex_x - e.length, e.apex_y};
  return {-e.apex_x, -e.apex_y};
}

/// A vector in the plane of two others of length 1, as seen from the tip of the normal.
Point2 in_plane(const Vec3& vector, const Vec3& along, const Vec3& normal) {
  return {dot(vector, along), dot(vector, cross(normal, along))};
}

Vec3 normal_of(const Mesh& mesh, Index face) {
  const auto [a, b, c] = mesh.triangle(face);
  const Vec3 normal = cross(subtract(mesh.position(b), mesh.position(a)),
                            subtract(mesh.position(c), mesh.position(a)));
  const double length = norm(normal);
  return length > 0 ? scale(1 / length, normal) : Vec3{};
}

Vec3 unit(const Vec3& vector) { return scale(1 / norm(vector), vector); }

double angle_in_face(const Mesh& mesh, const InternalPoint& begin, const Vec3& vector) {
  const Vec3 normal = normal_of(mesh, begin.face);
  if (norm(normal) == 0) refuse(name_of(mesh, begin) + " is in a face without an area");
  const auto [a, b, c] = mesh.triangle(begin.face);
  const Vec3 along = unit(subtract(mesh.position(b), mesh.position(a)));
  const Point2 flat = in_plane(vector, along, normal);
  if (norm(flat) <= kThroughVertex) {
    refuse("the direction is perpendicular to the face of " + name_of(mesh, begin));
  }
  return std::atan2(flat.y, flat.x);
}

double angle_at_vertex(const Mesh& mesh, Index v, const Vec3& vector) {
  const Directions directions(mesh, v);
  Vec3 normal{};
  for (const Corner& corner : directions.corners()) {
    normal = add(normal, scale(corner.angle, normal_of(mesh, corner.half_edge / 3)));
  }
  const std::string name = name_of(mesh, InternalPoint(v));
  if (norm(normal) == 0) refuse("the faces at " + name + " have no mean normal");
  normal = unit(normal);
  const Vec3 rest = subtract(vector, scale(dot(vector, normal), normal));
  if (norm(rest) <= kThroughVertex) {
    refuse("the direction is perpendicular to the surface at " + name);
  }
  const Vec3 along = unit(rest);
  const auto turn_to = [&](Index vertex) {  // from the vector to an edge
    const Point2 flat = in_plane(subtract(mesh.position(vertex), mesh.position(v)), along, normal);
    return std::atan2(flat.y, flat.x);
  };
  for (const Corner& corner : directions.corners()) {
    const double from = turn_to(mesh.head(corner.half_edge)),
                 to = turn_to(mesh.apex(corner.half_edge));
    if (from <= 0 && to >= 0 && to - from < kTurn / 2) {
      return corner.begin + (to > from ? -from / (to - from) * corner.angle : 0);
    }
  }
  refuse("the direction leads off the surface at " + name);
}

/// Direction from a point of a face to another one of it, measured as at `begin`.
/// @param directions at a vertex
/// @param face contains both
double angle_to(const Mesh& mesh, const InternalPoint& begin, const Directions& directions,
                const InternalPoint& end, Index face) {
  const auto in_face = [&](const InternalPoint& point, Index h) -> std::optional<Point2> {
    const HalfEdge& e = mesh.half_edge(h);
    if (point.is_vertex()) {
      if (e.origin == point.vertex) return Point2{0, 0};
      if (mesh.head(h) == point.vertex) return Point2{e.length, 0};
      if (mesh.apex(h) == point.vertex) return Point2{e.apex_x, e.apex_y};
      return std::nullopt;
    }
    for (const InternalPoint& image : in_every_face(mesh, point)) {
      if (image.face == h / 3) return in_frame(mesh, image, h);
    }
    return std::nullopt;
  };
  const auto towards = [&](Index h) -> std::optional<Point2> {
    const auto from = in_face(begin, h), to = in_face(end, h);
    if (!from || !to) return std::nullopt;
    return minus(*to, *from);
  };
  if (begin.is_vertex()) {
    for (const Corner& corner : directions.corners()) {
      if (corner.half_edge / 3 != face) continue;
      const auto to = towards(corner.half_edge);
      if (to) return corner.begin + std::clamp(std::atan2(to->y, to->x), 0.0, corner.angle);
    }
    return kNoAngle;
  }
  const auto to = towards(3 * face);
  if (!to) return kNoAngle;
  const double angle = std::atan2(to->y, to->x);
  if (face == begin.face) return angle;
  const Index h = edge_under(begin), twin = mesh.twin(h);  // the point is on the edge of both faces
  return angle - angle_between({1, 0}, side_of(mesh, face, twin % 3)) + kTurn / 2 +
         angle_between({1, 0}, side_of(mesh, begin.face, h % 3));
}

double modulo(double angle, double total) {
  if (total == 0) return 0;  // of faces without an area
  const double rest = std::fmod(angle, total);
  return rest < 0 ? rest + total : rest;
}

}  // namespace

double total_angle(const Mesh& mesh, const SurfacePoint& point) {
  const InternalPoint own = checked(mesh, point);
  return own.is_vertex() ? Directions(mesh, own.vertex).total() : kTurn;
}

double angle_of(const Mesh& mesh, const SurfacePoint& begin, const Vec3& vector) {
  const InternalPoint own = checked(mesh, begin);
  const double length = norm(vector);
  if (!(length > 0 && length < kInfinity)) refuse("a direction must be finite and not 0");
  const Vec3 towards = scale(1 / length, vector);
  if (own.is_vertex()) return angle_at_vertex(mesh, own.vertex, towards);
  return modulo(angle_in_face(mesh, own, towards), kTurn);
}

StraightestLine trace_straightest(const Mesh& mesh, const SurfacePoint& begin, double angle,
                                  double length) {
  const InternalPoint own = checked(mesh, begin);
  if (!std::isfinite(angle)) refuse("the angle of a direction must be finite");
  if (!(length >= 0 && length <= kMostEdges * mesh.mean_edge_length())) {
    refuse("the length of a line must be from 0 to 10^7 times the mean edge length");
  }
  Line line(mesh, own);
  if (own.is_vertex()) {
    const Directions directions(mesh, own.vertex);
    const double total = directions.total();
    const double turned = angle >= 0 && angle <= total ? angle : modulo(angle, total);
    const Corner& corner = directions.at(turned);
    return line.run(ray_from_corner(corner, std::min(turned - corner.begin, corner.angle)), length);
  }
  const Index h = 3 * own.face;
  return line.run({h, in_frame(mesh, own, h), {std::cos(angle), std::sin(angle)}, own.weights},
                  length);
}

std::vector<PolarCoordinates> log_map(const Paths& paths) {
  const Mesh& mesh = paths.mesh();
  refuse_crossed(mesh);
  const std::vector<double>& distances = paths.distances();
  std::vector<PolarCoordinates> map(distances.size());
  std::map<Index, Directions> around;  // by vertex that is a source
  for (Index v = 0; v < map.size(); ++v) {
    map[v] = {distances[v], kNoAngle};
    if (distances[v] == kInfinity) continue;
    const std::vector<PathPoint> points = paths.to_vertex(v).points;
    if (points.size() == 1) map[v].angle = 0;
    if (points.front().face == kNone) continue;
    const InternalPoint begin = in_internal_numbers(mesh, points[0].at);
    const Directions& directions =
        around.try_emplace(begin.vertex, mesh, begin.vertex).first->second;
    const double angle = angle_to(mesh, begin, directions, in_internal_numbers(mesh, points[1].at),
                                  mesh.numbers().internal_face(points[0].face));
    map[v].angle = begin.is_vertex() ? angle : modulo(angle, kTurn);
  }
  return map;
}

}  // namespace geodesic
