// Everything that can be wrong with the triangles of a mesh, found and named.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/connectivity.h"
#include "meshes/mesh_file.h"

namespace geodesic {

/// What can be wrong; the order of reports. The first six are errors: a solver would measure on
/// another surface than the file's author meant, or cannot measure at all. The rest are warnings.
enum class DefectKind {
  index_out_of_range,     ///< face that names a vertex that the file does not have
  repeated_vertex,        ///< face that names a vertex twice
  non_finite_coordinate,  ///< vertex with a coordinate that is NaN, infinite, or so large
                          ///< (kLargestCoordinate) that lengths overflow
  repeated_face,          ///< face of the same three vertices as an earlier one, either way round
  non_manifold_edge,      ///< edge of more than two faces
  inconsistent_orientation,  ///< edge of two faces that both run along it in the same direction
  non_manifold_vertex,       ///< vertex whose faces form several groups that share no edge there
  zero_area_face,            ///< face of three vertices on a line, up to rounding
  zero_length_edge,          ///< edge between different vertices at one place
  isolated_vertex,           ///< vertex of no face; it is kept and unreachable
  several_components,        ///< groups of faces that no path connects; counted when more than one
};
inline constexpr std::size_t kDefectKinds = 11;

enum class Severity { error, warning };

/// Names and consequence of a kind.
struct DefectType {
  std::string_view key;       ///< "non_manifold_edge", for JSON
  std::string_view singular;  ///< "edge of more than two faces"
  std::string_view plural;
  Severity severity;
};
const DefectType& type_of(DefectKind kind);

struct Defect {
  DefectKind kind;
  std::size_t count;    ///< how many faces, edges, vertices or components; never 0
  std::string example;  ///< the first one, with ids from 0 and, for a text file, its line
  /// "3 edges of more than two faces (first: edge 4-7 of faces 1, 2 and 9)"
  std::string text() const;
};

struct DefectReport {
  std::vector<Defect> defects;  ///< at most one a kind, in the order of DefectKind

  /// How many there are of a kind; 0 when none.
  std::size_t count(DefectKind kind) const;
  bool has_errors() const;
};

/// Squares of differences of coordinates up to this stay finite, in the mesh's unit of length.
inline constexpr double kLargestCoordinate = 1e150;

/// A face counts as of zero area when its height over its longest side is below this, relative to
/// that side: what rounding leaves of three points on a line.
inline constexpr double kFlatHeight = 1e-15;

/// What each face is good for; a repair drops all but the usable ones.
struct FaceCensus {
  std::vector<bool> usable;           ///< one a triangle
  std::vector<bool> finite_vertices;  ///< one a vertex
  /// Triangles of each kind of unusable face, each triangle in the first kind that fits.
  std::vector<Index> index_out_of_range, repeated_vertex, at_non_finite_vertex, repeated_face;
};
FaceCensus take_census(const TriangleSoup& soup);

/// Edges, groups and components are those of the usable faces: what makes a face unusable is
/// reported once, and not again as its consequences.
/// @param lines of the file, when there is one, for the examples
DefectReport find_defects(const TriangleSoup& soup, const FileLines& lines = {});

/// True for a triangle of zero area in the sense of kFlatHeight; its vertices must be finite.
bool has_zero_area(std::span<const Vec3> positions, const Triangle& triangle);

}  // namespace geodesic
