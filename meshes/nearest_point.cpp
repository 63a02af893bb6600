#include "meshes/nearest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "solvers/core/messages.h"
#include "solvers/core/numbering.h"

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

// The square of the distance from a place to a box, 0 inside. Rounding is monotonic: the square
// that is computed for a point of the box is at least this.
double square_to(const Box& box, const Vec3& place) {
  Vec3 away;
  for (std::size_t k = 0; k < 3; ++k) {
    away[k] = std::max({box.low[k] - place[k], place[k] - box.high[k], 0.0});
  }
  return dot(away, away);
}

void include(Box& box, const Box& other) {
  box.include(other.low);
  box.include(other.high);
}

// The nearest point so far, by the square of its distance.
struct Nearest {
  const Vec3& place;
  Index face = 0;
  Weights weights = {};
  double square = kInfinity;  // infinite: none

  void offer(const Corners& corners, Index of_face, const Weights& at) {
    const Vec3 away = subtract(place, at_weights(corners, at));
    const double found = dot(away, away);
    if (found < square || (found == square && of_face < face)) {
      face = of_face;
      weights = at;
      square = found;
    }
  }
};

}  // namespace

// Boxes of successive faces along a curve. Successive faces of the mesh may lie anywhere.
class NearestPointSearch::Tree {
 public:
  explicit Tree(const Mesh& mesh) : mesh_(mesh), faces_(faces_along_curve(mesh)) {
    levels_.emplace_back((faces_.size() + kLeaf - 1) / kLeaf);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      include(levels_[0][i / kLeaf], box_of(faces_[i]));
    }
    while (levels_.back().size() > 1) {
      const std::vector<Box>& below = levels_.back();
      std::vector<Box> level((below.size() + 1) / 2);
      for (std::size_t i = 0; i < below.size(); ++i) include(level[i / 2], below[i]);
      levels_.push_back(std::move(level));
    }
  }

  const Box& whole() const { return levels_.back().front(); }

  Nearest nearest_to(const Vec3& place) const {
    Nearest nearest{place};
    search(levels_.size() - 1, 0, nearest);
    return nearest;
  }

 private:
  static constexpr std::size_t kLeaf = 8;  // faces

  static std::vector<Index> faces_along_curve(const Mesh& mesh) {
    std::vector<Vec3> middles(mesh.given_face_count());
    std::vector<Index> faces(middles.size());
    for (Index f = 0; f < faces.size(); ++f) {
      faces[f] = f;
      for (const Index v : mesh.triangle(f)) {
        middles[f] = add(middles[f], scale(1.0 / 3, mesh.position(v)));
      }
    }
    std::ranges::transform(cells_along_curve(middles, faces), faces.begin(), &OnCurve::vertex);
    return faces;
  }

  // A box around all points of a face as at_weights computes them: the roundings add up to less
  // than 2^-48 of the largest coordinate.
  Box box_of(Index face) const {
    Box box;
    for (const Index v : mesh_.triangle(face)) box.include(mesh_.position(v));
    for (std::size_t k = 0; k < 3; ++k) {
      const double rounding = 0x1p-48 * std::max(std::abs(box.low[k]), std::abs(box.high[k]));
      box.low[k] -= rounding;
      box.high[k] += rounding;
    }
    return box;
  }

  void visit(Index face, Nearest& nearest) const {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh_.position(mesh_.triangle(face)[k]);
    const Weights inside = projected(corners, nearest.place);
    if (std::ranges::all_of(inside, [](double w) { return w > 0; })) {
      nearest.offer(corners, face, inside);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      nearest.offer(corners, face, nearest_on_side(corners, k, nearest.place));
    }
  }

  // A box that is as far as the nearest point so far may hold one of a lesser face.
  void search(std::size_t level, std::size_t node, Nearest& nearest) const {
    if (level == 0) {
      const std::size_t end = std::min((node + 1) * kLeaf, faces_.size());
      for (std::size_t i = node * kLeaf; i < end; ++i) visit(faces_[i], nearest);
      return;
    }
    const std::vector<Box>& boxes = levels_[level - 1];
    std::size_t near = 2 * node, far = std::min(2 * node + 1, boxes.size() - 1);
    double to_near = square_to(boxes[near], nearest.place);
    double to_far = square_to(boxes[far], nearest.place);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    if (to_near <= nearest.square) search(level - 1, near, nearest);
    if (far != near && to_far <= nearest.square) search(level - 1, far, nearest);
  }

  const Mesh& mesh_;
  const std::vector<Index> faces_;
  // levels_[0] has a box for every kLeaf faces in turn, each other level has one for every two
  // boxes of the level before, and the last has one box.
  std::vector<std::vector<Box>> levels_;
};

NearestPointSearch::NearestPointSearch(const Mesh& mesh) : mesh_(mesh) {}
NearestPointSearch::~NearestPointSearch() = default;

const NearestPointSearch::Tree& NearestPointSearch::tree() const {
  std::call_once(built_, [this] { tree_ = std::make_unique<const Tree>(mesh_); });
  return *tree_;
}

NearestPoint NearestPointSearch::nearest_to(const Vec3& place) const {
  if (!is_finite(place)) {
    throw std::invalid_argument("a place in space must have finite coordinates");
  }
  if (mesh_.face_count() == 0) {
    throw std::invalid_argument("a mesh without faces has no surface");
  }
  const Nearest nearest = tree().nearest_to(place);
  if (nearest.square == kInfinity) {
    throw std::invalid_argument("a place in space is too far from the mesh");
  }
  return {point_in_face(mesh_, mesh_.numbers().external_face(nearest.face), nearest.weights),
          std::sqrt(nearest.square)};
}

std::string NearestPointSearch::remark_if_far(double distance) const {
  const double extent = 2 * tree().whole().half_extent();
  if (distance <= kFar * extent) return {};
  return "is " + significant(distance, 3) +
         " from the surface, whose nearest point is taken; the longest side of the mesh is " +
         significant(extent, 3);
}

}  // namespace geodesic
