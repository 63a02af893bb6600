// A rectangle of square cells, each split into two triangles, laid out over any surface and closed
// into a tube or torus where its columns or rows wrap: the connectivity of most generators.
#pragma once

#include <functional>
#include <vector>

#include "meshes/generators/parameters.h"

namespace geodesic {

/// Which way a cell is split: forward from its corner (i, j) to (i+1, j+1), backward from (i+1, j)
/// to (i, j+1), alternating forward where i + j is even.
enum class Diagonal { forward, backward, alternating };

ParameterDescription diagonal_parameter(ParameterValue default_value = "alternating");
Diagonal diagonal_of(const CheckedParameters& parameters);

/// Refuses what does not fit 32-bit indices before memory is spent on it.
/// @throws std::invalid_argument when a half-edge could not be numbered by an Index
void check_face_count(double faces);

/// Column i runs along the surface's first parameter, row j along its second; the normal is first
/// x second. Vertex (i, j) has id j * vertex_columns() + i.
struct Sheet {
  Index columns = 1;  ///< cells
  Index rows = 1;
  bool columns_wrap = false;  ///< the last column's right side is the first one's left side
  bool rows_wrap = false;
  Diagonal diagonal = Diagonal::forward;

  Index vertex_columns() const { return columns_wrap ? columns : columns + 1; }
  Index vertex_rows() const { return rows_wrap ? rows : rows + 1; }
};

using CellFilter = std::function<bool(Index i, Index j)>;

/// Two triangles for each cell, row by row.
/// @param keeps only cells for which it is true; empty for all
std::vector<Triangle> sheet_faces(const Sheet& sheet, const CellFilter& keeps = {});

/// The whole sheet with vertex (i, j) at `position(i, j)`.
template <typename Position>
TriangleSoup make_sheet(const Sheet& sheet, Position position, const CellFilter& keeps = {}) {
  TriangleSoup soup;
  soup.triangles = sheet_faces(sheet, keeps);
  soup.positions.reserve(std::size_t{sheet.vertex_columns()} * sheet.vertex_rows());
  for (Index j = 0; j < sheet.vertex_rows(); ++j)
    for (Index i = 0; i < sheet.vertex_columns(); ++i) soup.positions.push_back(position(i, j));
  return soup;
}

/// Removes vertices without a face and renumbers the rest in their order.
void drop_isolated_vertices(TriangleSoup& soup);

}  // namespace geodesic
