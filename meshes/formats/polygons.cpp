#include "meshes/formats/polygons.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "solvers/core/geometry.h"

namespace geodesic {
namespace {

using FlatPoint = std::array<double, 2>;

// Twice the signed area of a triangle, positive when it is counter-clockwise.
double area2(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The sum of the cross products of a polygon's sides, twice its area along its normal (Newell).
Vec3 newell_normal(std::span<const Vec3> positions, std::span<const Index> corners) {
  Vec3 sum = {0, 0, 0};
  const Vec3& origin = positions[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3 normal =
        cross(subtract(positions[corners[i]], origin), subtract(positions[corners[i + 1]], origin));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += normal[k];
  }
  return sum;
}

// The polygon without the coordinate in which its normal is longest, counter-clockwise.
std::vector<FlatPoint> project(std::span<const Vec3> positions, std::span<const Index> corners,
                               const Vec3& normal) {
  std::size_t axis = 0;
  for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  }
  std::size_t u = (axis + 1) % 3;
  std::size_t v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<FlatPoint> points;
  for (const Index corner : corners) points.push_back({positions[corner][u], positions[corner][v]});
  return points;
}

bool fan_is_unfolded(std::span<const FlatPoint> points) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (!(area2(points[0], points[i], points[i + 1]) > 0)) return false;
  }
  return true;
}

// Takes the square of the number of corners in time: what has been ruled out as an obstacle of a
// triangle stays so, and only the two triangles beside a lost ear change.
class EarClipper {
 public:
  EarClipper(std::span<const FlatPoint> points, std::span<const Index> corners)
      : points_(points),
        corners_(corners),
        left_(points.size()),
        lost_(points.size(), false),
        ruled_out_(points.size(), 0) {
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }

  // Appends the triangles; what has no ear left becomes a fan. Returns whether all were ears.
  bool clip(std::vector<Triangle>& triangles) {
    while (left_.size() > 3) {
      std::size_t ear = 0;
      while (ear < left_.size() && !is_ear(ear)) ++ear;
      if (ear == left_.size()) break;
      triangles.push_back(triangle(before(ear), left_[ear], after(ear)));
      lost_[left_[ear]] = true;
      ruled_out_[before(ear)] = ruled_out_[after(ear)] = 0;
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    const bool whole =
        left_.size() == 3 && area2(points_[left_[0]], points_[left_[1]], points_[left_[2]]) > 0;
    for (std::size_t i = 1; i + 1 < left_.size(); ++i) {
      triangles.push_back(triangle(left_[0], left_[i], left_[i + 1]));
    }
    return whole;
  }

 private:
  std::size_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
  std::size_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }
  Triangle triangle(std::size_t a, std::size_t b, std::size_t c) const {
    return {corners_[a], corners_[b], corners_[c]};
  }

  bool is_ear(std::size_t i) {
    const FlatPoint& a = points_[before(i)];
    const FlatPoint& b = points_[left_[i]];
    const FlatPoint& c = points_[after(i)];
    if (!(area2(a, b, c) > 0)) return false;
    const auto is_obstacle = [&](std::size_t j) {
      const FlatPoint& p = points_[j];
      // A corner of the same place is no obstacle: polygons with holes walk a slit twice.
      if (lost_[j] || p == a || p == b || p == c) return false;
      return area2(a, b, p) >= 0 && area2(b, c, p) >= 0 && area2(c, a, p) >= 0;
    };
    std::size_t& j = ruled_out_[left_[i]];
    while (j < points_.size() && !is_obstacle(j)) ++j;
    return j == points_.size();
  }

  std::span<const FlatPoint> points_;
  std::span<const Index> corners_;
  std::vector<std::size_t> left_;  // the polygon that remains, as positions in points_
  std::vector<bool> lost_;
  std::vector<std::size_t> ruled_out_;  // of each corner's triangle: so many points, as obstacles
};

void append_fan(std::span<const Index> corners, std::vector<Triangle>& triangles) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    triangles.push_back({corners[0], corners[i], corners[i + 1]});
  }
}

enum class Outcome { triangulated, not_simple, too_many_corners };

Outcome append_polygon(std::span<const Vec3> positions, std::span<const Index> corners,
                       std::vector<Triangle>& triangles) {
  const bool usable = std::all_of(corners.begin(), corners.end(), [&](Index v) {
    return v < positions.size() && is_finite(positions[v]);
  });
  if (!usable) {  // find_defects will say so
    append_fan(corners, triangles);
    return Outcome::triangulated;
  }
  const Vec3 normal = newell_normal(positions, corners);
  const std::vector<FlatPoint> points = project(positions, corners, normal);
  if (fan_is_unfolded(points)) {
    append_fan(corners, triangles);
    return Outcome::triangulated;
  }
  if (corners.size() > Polygons::kMostCornersWithEars) return Outcome::too_many_corners;
  return EarClipper(points, corners).clip(triangles) ? Outcome::triangulated : Outcome::not_simple;
}

}  // namespace

void Polygons::reserve(std::size_t polygons) { triangles_.reserve(polygons); }

void Polygons::end_polygon(std::uint32_t line) {
  if (open_.size() == 3) {
    triangles_.push_back({open_[0], open_[1], open_[2]});
    if (line > 0) lines_.push_back(line);
  } else {
    larger_.push_back({triangles_.size(), larger_corners_.size(), line});
    larger_corners_.insert(larger_corners_.end(), open_.begin(), open_.end());
  }
  open_.clear();
}

void Polygons::triangulate(MeshFile& file, const std::string& name) {
  std::vector<Triangle>& triangles = file.soup.triangles;
  std::vector<std::uint32_t>& lines = file.lines.triangles;
  if (larger_.empty()) {
    triangles = std::move(triangles_);
    lines = std::move(lines_);
    return;
  }
  triangles.reserve(triangles_.size() + larger_corners_.size() - 2 * larger_.size());
  std::size_t taken = 0;  // of triangles_
  const auto take_to = [&](std::size_t end) {
    const auto from = static_cast<std::ptrdiff_t>(taken), to = static_cast<std::ptrdiff_t>(end);
    triangles.insert(triangles.end(), triangles_.begin() + from, triangles_.begin() + to);
    if (!lines_.empty()) lines.insert(lines.end(), lines_.begin() + from, lines_.begin() + to);
    taken = end;
  };
  const auto place = [&](std::size_t i) {
    const Larger& polygon = larger_[i];
    return polygon.line > 0 ? "line " + std::to_string(polygon.line)
                            : "face " + std::to_string(polygon.triangles_before + i);
  };
  std::size_t not_simple = 0;
  std::size_t first_not_simple = 0;
  for (std::size_t i = 0; i < larger_.size(); ++i) {
    take_to(larger_[i].triangles_before);
    const std::size_t begin = larger_[i].first_corner;
    const std::size_t end =
        i + 1 < larger_.size() ? larger_[i + 1].first_corner : larger_corners_.size();
    const std::span<const Index> corners(larger_corners_.data() + begin, end - begin);
    const Outcome outcome = append_polygon(file.soup.positions, corners, triangles);
    if (outcome == Outcome::too_many_corners) {
      throw MeshError(name + ", " + place(i) + ": a face that is not convex has " +
                      std::to_string(corners.size()) + " corners, more than the " +
                      std::to_string(kMostCornersWithEars) + " that are triangulated; split it");
    }
    if (outcome == Outcome::not_simple && not_simple++ == 0) first_not_simple = i;
    if (larger_[i].line > 0) lines.resize(triangles.size(), larger_[i].line);
  }
  take_to(triangles_.size());
  if (not_simple > 0) {
    file.warnings.push_back(
        std::to_string(not_simple) +
        " faces of more than three corners cross themselves or have no area, and became fans that "
        "may be folded (first: " +
        place(first_not_simple) + ")");
  }
}

}  // namespace geodesic
