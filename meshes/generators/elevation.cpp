// Terrain from measured heights. The grid is an array as maps are stored: its first row lies in the
// north, its first column in the west. x runs east along a row, y north against the order of rows.
#include <vector>

#include "meshes/formats/npy.h"
#include "meshes/generators/families.h"
#include "meshes/generators/natural_spline.h"
#include "meshes/generators/sheet.h"
#include "meshes/mesh_file.h"

namespace geodesic {
namespace {

/// Every row resampled at `count` + 1 points, as the columns of a transposed array.
Array resample_rows(const Array& array, std::size_t count) {
  Array result{.rows = count + 1, .columns = array.rows, .values = {}};
  result.values.resize(result.rows * result.columns);
  for (std::size_t row = 0; row < array.rows; ++row) {
    const auto begin = array.values.begin() + static_cast<std::ptrdiff_t>(row * array.columns);
    const NaturalSpline spline({begin, begin + static_cast<std::ptrdiff_t>(array.columns)});
    const std::vector<double> values = spline.resampled(count);
    for (std::size_t k = 0; k <= count; ++k) result.values[k * result.columns + row] = values[k];
  }
  return result;
}

TriangleSoup make_elevation(const CheckedParameters& parameters) {
  const Sheet sheet{.columns = parameters.integer("columns"),
                    .rows = parameters.integer("rows"),
                    .diagonal = diagonal_of(parameters)};
  check_face_count(2.0 * sheet.columns * sheet.rows);
  const std::string& file = parameters.file("input");
  const Array samples = parse_npy(read_bytes(file), file);
  // Metres from vertex to vertex.
  const double dx =
      parameters.real("spacing-x") * (static_cast<double>(samples.columns - 1) / sheet.columns);
  const double dy =
      parameters.real("spacing-y") * (static_cast<double>(samples.rows - 1) / sheet.rows);
  const Array heights = resample_rows(resample_rows(samples, sheet.columns), sheet.rows);
  return make_sheet(sheet, [&](Index i, Index j) {
    return Vec3{i * dx, j * dy, heights.at(sheet.rows - j, i)};
  });
}

}  // namespace

Family elevation() {
  return {
      {.name = "elevation",
       .description = "open terrain through a grid of heights in metres, an array of two "
                      "dimensions whose first row lies in the north: a natural bicubic spline at "
                      "(columns + 1)(rows + 1) vertices, x to the east, y to the north, in metres",
       .closed_form = "",
       .parameters = {file_parameter("input", "the heights, a .npy file"),
                      integer_parameter("columns", 1024, 1, 40000, "cells along x"),
                      integer_parameter("rows", 1536, 1, 40000, "cells along y"),
                      real_parameter("spacing-x", 1, 1e-6, 1e6, "metres from sample to sample"),
                      real_parameter("spacing-y", 1, 1e-6, 1e6, "metres from sample to sample"),
                      diagonal_parameter()}},
      make_elevation};
}

}  // namespace geodesic
