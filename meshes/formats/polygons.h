// Polygons as files hold them, and their triangulation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshes/mesh_file.h"

namespace geodesic {

/// Faces of any number of corners. `add_corner` for each corner of a face, then `end_polygon`.
class Polygons {
 public:
  void reserve(std::size_t polygons);
  void add_corner(Index vertex) { open_.push_back(vertex); }
  /// Corners of the polygon that has not been ended yet.
  std::size_t open_corners() const { return open_.size(); }
  /// @param line of the file that holds it; 0 in a binary file
  void end_polygon(std::uint32_t line);

  /// Fills file.soup.triangles (and file.lines.triangles) from the polygons, in their order; needs
  /// file.soup.positions. Leaves none here.
  ///
  /// A polygon becomes the fan around the first of its corners from which all triangles have the
  /// orientation of the polygon, in the projection along the coordinate in which its normal is
  /// longest: every convex polygon and every quadrilateral has such a corner. Where there is none,
  /// or the polygon crosses itself or has no area, it becomes the fan around its first corner,
  /// which may be folded, and file.warnings counts them.
  void triangulate(MeshFile& file);

  /// Corners that are tried: the time is this times the number of corners at most.
  static constexpr std::size_t kMostApexes = 1000;

 private:
  /// A polygon of more than three corners, which end where the next one's begin.
  struct Larger {
    std::size_t triangles_before;
    std::size_t first_corner;  // in larger_corners_
    std::uint32_t line;
  };

  std::vector<Index> open_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> lines_;  // of triangles_; empty in a binary file
  std::vector<Larger> larger_;
  std::vector<Index> larger_corners_;
};

}  // namespace geodesic
