// Defects of the triangles of a mesh: their kinds, and a function that finds them.
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

/// Kinds of defects, in the order of reports. The first six are errors: a solver would measure
/// another surface than the author of the file meant, or none at all. The rest are warnings.
enum class DefectKind {
  index_out_of_range,     ///< face with a vertex that the file does not contain
  repeated_vertex,        ///< face that names a vertex twice, or has fewer than three corners
  non_finite_coordinate,  ///< vertex with a coordinate that is NaN, infinite, or so large
                          ///< (kLargestCoordinate) that lengths overflow
  repeated_face,          ///< face of the same three vertices as an earlier one, either way round
  non_manifold_edge,      ///< edge of more than two faces
  inconsistent_orientation,  ///< edge of two faces that both run along it in the same direction
  non_manifold_vertex,       ///< vertex whose faces form several groups that share no edge there
  zero_area_face,            ///< face whose vertices lie on a line, up to rounding
  zero_length_edge,          ///< edge between different vertices at the same position
  isolated_vertex,           ///< vertex without a face; it is kept and unreachable
  coincident_vertex,         ///< vertex of faces at the place of an earlier one, which no edge of
                             ///< length 0 connects with it: paths do not cross between their faces
  nearly_coincident_vertex,  ///< the same, not at its place but within kNearlyCoincident
  several_components,        ///< groups of faces that no path connects; counted when more than one
};
inline constexpr std::size_t kDefectKinds = 13;

enum class Severity { error, warning };

/// Names and severity of a kind.
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
  std::vector<Defect> defects;  ///< at most one per kind, in the order of DefectKind

  /// Number of defects of a kind; 0 if there are none.
  std::size_t count(DefectKind kind) const;
  bool has_errors() const;
};

/// Largest coordinate whose differences have finite squares, in the mesh's unit of length.
inline constexpr double kLargestCoordinate = 1e150;

/// A face has zero area if its height over its longest side, divided by the length of that side, is
/// below this value: three points on a line have such heights after rounding.
inline constexpr double kFlatHeight = 1e-15;

/// Two vertices nearly coincide if their distance, divided by the mean edge length, is at most this
/// value: rounding to floats moves vertices less, unless the mesh is far from the origin.
inline constexpr double kNearlyCoincident = 1e-6;

/// The usable faces, which a repair keeps, and the reasons why the others are unusable.
struct FaceCensus {
  std::vector<bool> usable;           ///< one flag per triangle
  std::vector<bool> finite_vertices;  ///< one flag per vertex
  /// Triangles of each kind of unusable face. A triangle of several kinds is in the first of them.
  std::vector<Index> index_out_of_range, repeated_vertex, at_non_finite_vertex, repeated_face;
};
FaceCensus take_census(const TriangleSoup& soup);

/// Finds all defects. Edges, groups and components are those of the usable faces: an unusable face
/// is reported once, without its consequences.
/// @param lines line numbers of the file, for the examples; empty without a file
DefectReport find_defects(const TriangleSoup& soup, const FileLines& lines = {});

/// Returns whether a triangle has zero area as defined at kFlatHeight. Its vertices must be finite.
bool has_zero_area(std::span<const Vec3> positions, const Triangle& triangle);

}  // namespace geodesic
