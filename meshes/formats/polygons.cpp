#include "meshes/formats/polygons.h"

#include <algorithm>
#include <span>

#include "solvers/core/geometry.h"

namespace geodesic {
namespace {

using FlatPoint = std::array<double, 2>;

// Returns twice the signed area of a triangle, positive if it is counter-clockwise.
double area2(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The sum of the cross products of a polygon's sides: twice its area along its normal (Newell).
Vec3 newell_normal(std::span<const Vec3> positions, std::span<const Index> corners) {
  Vec3 sum = {0, 0, 0};
  const Vec3& origin = positions[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum = add(sum, cross(subtract(positions[corners[i]], origin),
                         subtract(positions[corners[i + 1]], origin)));
  }
  return sum;
}

// Returns the polygon, counter-clockwise, without the coordinate in which its normal is longest.
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

// Returns whether all triangles from one corner are counter-clockwise, like the polygon.
bool fan_is_unfolded(std::span<const FlatPoint> points, std::size_t apex) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const FlatPoint& a = points[(apex + i) % points.size()];
    const FlatPoint& b = points[(apex + i + 1) % points.size()];
    if (!(area2(points[apex], a, b) > 0)) return false;
  }
  return true;
}

void append_fan(std::span<const Index> corners, std::size_t apex,
                std::vector<Triangle>& triangles) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    triangles.push_back({corners[apex], corners[(apex + i) % corners.size()],
                         corners[(apex + i + 1) % corners.size()]});
  }
}

// Returns whether the triangles cover the polygon once.
bool append_polygon(std::span<const Vec3> positions, std::span<const Index> corners,
                    std::vector<Triangle>& triangles) {
  const bool usable = std::all_of(corners.begin(), corners.end(), [&](Index v) {
    return v < positions.size() && is_finite(positions[v]);
  });
  if (!usable) {  // find_defects will report it
    append_fan(corners, 0, triangles);
    return true;
  }
  const Vec3 normal = newell_normal(positions, corners);
  const std::vector<FlatPoint> points = project(positions, corners, normal);
  const std::size_t tried = std::min(points.size(), Polygons::kMostApexes);
  std::size_t apex = 0;
  while (apex < tried && !fan_is_unfolded(points, apex)) ++apex;
  append_fan(corners, apex < tried ? apex : 0, triangles);
  return apex < tried;
}

}  // namespace

void Polygons::reserve(std::size_t polygons) { triangles_.reserve(polygons); }

void Polygons::end_polygon(std::uint32_t line) {
  if (open_.size() <= 3) {
    open_.resize(3, open_.empty() ? 0 : open_.back());
    triangles_.push_back({open_[0], open_[1], open_[2]});
    if (line > 0) lines_.push_back(line);
  } else {
    larger_.push_back({triangles_.size(), larger_corners_.size(), line});
    larger_corners_.insert(larger_corners_.end(), open_.begin(), open_.end());
  }
  open_.clear();
}

void Polygons::triangulate(MeshFile& file) {
  std::vector<Triangle>& triangles = file.soup.triangles;
  std::vector<std::uint32_t>& lines = file.lines.triangles;
  if (larger_.empty()) {
    triangles = std::move(triangles_);
    lines = std::move(lines_);
    return;
  }
  triangles.reserve(triangles_.size() + larger_corners_.size() - 2 * larger_.size());
  std::size_t taken = 0;  // number of triangles_ taken
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
  std::size_t folded = 0, first = 0;
  for (std::size_t i = 0; i < larger_.size(); ++i) {
    take_to(larger_[i].triangles_before);
    const std::size_t begin = larger_[i].first_corner;
    const std::size_t end =
        i + 1 < larger_.size() ? larger_[i + 1].first_corner : larger_corners_.size();
    const std::span<const Index> corners(larger_corners_.data() + begin, end - begin);
    if (!append_polygon(file.soup.positions, corners, triangles) && folded++ == 0) first = i;
    if (larger_[i].line > 0) lines.resize(triangles.size(), larger_[i].line);
  }
  take_to(triangles_.size());
  if (folded > 0) {
    file.warnings.push_back(
        std::to_string(folded) +
        " faces of more than three corners are seen whole from none of them, cross themselves or "
        "have no area, and became fans that may be folded: triangulate them (first: " +
        place(first) + ")");
  }
}

}  // namespace geodesic
