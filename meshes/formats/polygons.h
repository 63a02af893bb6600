// The polygons of a file, and their triangulation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshes/mesh_file.h"

namespace geodesic {

/// Faces of any size. Call `add_corner` for each corner of a face, then `end_polygon`.
class Polygons {
 public:
  void reserve(std::size_t polygons);
  void add_corner(Index vertex) { open_.push_back(vertex); }
  /// A polygon of fewer than three corners becomes a triangle that repeats its last corner (vertex
  /// 0 if it has none), which find_defects reports and repair drops.
  /// @param line the line of the polygon in the file; 0 in a binary file
  void end_polygon(std::uint32_t line);

  /// Writes the triangles of the polygons, in order, to file.soup.triangles (and
  /// file.lines.triangles), and removes the polygons from this object. Needs file.soup.positions.
  ///
  /// A polygon becomes the fan around the first of its corners from which all triangles have the
  /// orientation of the polygon, in the projection along the coordinate in which its normal is
  /// longest. Every convex polygon and every quadrilateral has such a corner. A polygon without
  /// such a corner, or one that crosses itself or has no area, becomes the fan around its first
  /// corner, which may be folded; file.warnings counts these polygons.
  void triangulate(MeshFile& file);

  /// Number of corners that are tried, which bounds the time by this number times the corners.
  static constexpr std::size_t kMostApexes = 1000;

 private:
  /// A polygon of more than three corners. Its corners end where those of the next one begin.
  struct Larger {
    std::size_t triangles_before;
    std::size_t first_corner;  // in larger_corners_
    std::uint32_t line;
  };

  std::vector<Index> open_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> lines_;  // by triangle of triangles_; empty in a binary file
  std::vector<Larger> larger_;
  std::vector<Index> larger_corners_;
};

}  // namespace geodesic
