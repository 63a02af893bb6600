#include "meshes/nearest_point.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "solvers/core/messages.h"

namespace geodesic {
namespace {

using Corners = std::array<Vec3, 3>;
using Weights = std::array<double, 3>;

Vec3 at_weights(const Corners& corners, const Weights& weights) {
  Vec3 at{};
  for (std::size_t k = 0; k < 3; ++k) at = add(at, scale(weights[k], corners[k]));
  return at;
}

// Returns the weights of the nearest point on the side from corner k to the next: the projection of
// the place, clamped to the side.
Weights nearest_on_side(const Corners& corners, std::size_t k, const Vec3& place) {
  const Vec3 along = subtract(corners[(k + 1) % 3], corners[k]);
  const double square = dot(along, along);
  const double share = square > 0 ? dot(subtract(place, corners[k]), along) / square : 0;
  Weights weights{};
  weights[(k + 1) % 3] = std::clamp(share, 0.0, 1.0);
  weights[k] = 1 - weights[(k + 1) % 3];
  return weights;
}

// Returns the weights of the place's projection to the plane of the face. They are negative outside
// the face, and NaN for a face without area.
Weights projected(const Corners& corners, const Vec3& place) {
  const Vec3 ab = subtract(corners[1], corners[0]), ac = subtract(corners[2], corners[0]);
  const Vec3 normal = cross(ab, ac);
  const Vec3 from_a = subtract(place, corners[0]);
  const double square = dot(normal, normal);
  const double c = dot(cross(ab, from_a), normal) / square;
  const double b = dot(cross(from_a, ac), normal) / square;
  return {1 - b - c, b, c};
}

constexpr double kFar = 0.01;  // share of the longest side

// The nearest point so far, by the square of its distance.
struct Nearest {
  Index face = kNone;
  Weights weights = {};
  double square = kInfinity;

  void offer(const Corners& corners, Index of_face, const Weights& at, const Vec3& place) {
    const Vec3 away = subtract(place, at_weights(corners, at));
    const double found = dot(away, away);
    if (found < square) *this = {of_face, at, found};
  }
};

}  // namespace

NearestPoint nearest_point(const Mesh& mesh, const Vec3& place) {
  if (!is_finite(place)) {
    throw std::invalid_argument("a place in space must have finite coordinates");
  }
  Nearest nearest;
  for (Index f = 0; f < mesh.given_face_count(); ++f) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.position(mesh.triangle(f)[k]);
    const Weights inside = projected(corners, place);
    if (std::ranges::all_of(inside, [](double w) { return w > 0; })) {
      nearest.offer(corners, f, inside, place);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      nearest.offer(corners, f, nearest_on_side(corners, k, place), place);
    }
  }
  if (nearest.face == kNone) {
    throw std::invalid_argument(mesh.face_count() == 0
                                    ? "a mesh without faces has no surface"
                                    : "a place in space is too far from the mesh");
  }
  return {point_in_face(mesh, mesh.numbers().external_face(nearest.face), nearest.weights),
          std::sqrt(nearest.square)};
}

std::string remark_if_far(const Mesh& mesh, double distance) {
  const double extent = 2 * box_around(mesh.positions()).half_extent();
  if (distance <= kFar * extent) return {};
  return "is " + significant(distance, 3) +
         " from the surface, whose nearest point is taken; the longest side of the mesh is " +
         significant(extent, 3);
}

}  // namespace geodesic
