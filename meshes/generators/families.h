// The families of generators, and building blocks that several of them use.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meshes/generators/generators.h"

namespace geodesic {

/// A mesh, and one line for each change to the mesh of the input file.
struct GeneratedMesh {
  GeneratedMesh(TriangleSoup mesh, std::vector<std::string> lines = {})
      : soup(std::move(mesh)), remarks(std::move(lines)) {}

  TriangleSoup soup;
  std::vector<std::string> remarks;
};

struct Family {
  GeneratorDescription description;
  std::function<GeneratedMesh(const CheckedParameters& parameters)> make;
  /// Distances of all vertices from `source` in closed form, in the unit of the positions, on the
  /// mesh that `make` returns; null without a closed form. It is evaluated on the stored positions
  /// in `long double`: rounding of a position (1e-16 of the mesh's size) is part of the mesh, and
  /// results are accurate to the last bit or two of a double. Only on cones and saddles does that
  /// rounding also bend faces, by up to 1e-16 of a vertex's distance from the apex, which the
  /// unrolled plane does not include.
  std::vector<double> (*known_distances)(const CheckedParameters& parameters,
                                         const TriangleSoup& soup, Index source) = nullptr;
};

// The families, one function per source file.
Family box();
std::vector<Family> cones();     ///< cone, saddle-cone
std::vector<Family> sheets();    ///< grid, capped-grid, square-with-hole, holed-plate, egg-carton
std::vector<Family> spheres();   ///< icosphere, two-components
std::vector<Family> terrains();  ///< terrain, elevation
std::vector<Family> tubes();     ///< cylinder, needles, torus, torus-knot
Family clean();
Family decimate();
Family involute();
Family noise();
Family refine();
Family subdivide();
Family transform();

/// Returns `distance(v)` of all vertices, rounded to double.
template <typename Distance>
std::vector<double> distances_to_all(const TriangleSoup& soup, Distance distance) {
  std::vector<double> distances(soup.positions.size());
  for (Index v = 0; v < distances.size(); ++v) distances[v] = static_cast<double>(distance(v));
  return distances;
}

// ---- Sine and cosine with the same bits on every machine. The results of the C library differ in
// the last bit between processors (it selects variants with or without fused multiply-add at run
// time) and between versions. Rounding to a coarser grid would only make differences rare, and
// would bend flat faces. These functions use only + - * /.

struct CirclePoint {
  double cosine;
  double sine;
};

inline constexpr double kTwoPi = 6.283185307179586476925;

/// Returns the point of the unit circle at an angle, which is finite and in turns (1 = 360
/// degrees). Its error is below 4e-16 for |turns| <= 1; eighths of turns have exact symmetries.
CirclePoint circle_point(double turns);

/// Returns the corners of the regular n-gon: entry i is at i / n turns.
std::vector<CirclePoint> regular_polygon(Index n);

// ---- Sheets: a rectangle of square cells, each split into two triangles, mapped to any surface.
// It is closed into a tube or torus if its columns or rows wrap.

/// The diagonal that splits a cell: forward from its corner (i, j) to (i+1, j+1), backward from
/// (i+1, j) to (i, j+1), alternating: forward where i + j is even, backward elsewhere.
enum class Diagonal { forward, backward, alternating };

ParameterDescription diagonal_parameter(ParameterValue default_value = "alternating");
Diagonal diagonal_of(const CheckedParameters& parameters);

/// Column i runs along the surface's first parameter, row j along its second; the normal is first
/// x second. Vertex (i, j) has id j * vertex_columns() + i.
struct Sheet {
  Index columns = 1;  ///< columns of cells
  Index rows = 1;
  Diagonal diagonal = Diagonal::forward;
  bool columns_wrap = false;  ///< the last column's right side is the first one's left side
  bool rows_wrap = false;

  Index vertex_columns() const { return columns_wrap ? columns : columns + 1; }
  Index vertex_rows() const { return rows_wrap ? rows : rows + 1; }
};

/// Returns the open sheet with the cells of two parameters and the parameter "diagonal".
Sheet sheet_of(const CheckedParameters& parameters, std::string_view columns,
               std::string_view rows);

/// Checks, before memory is allocated, that an Index can number the half-edges of a mesh.
/// @throws std::invalid_argument if it cannot
void check_face_count(double faces);

using CellFilter = std::function<bool(Index i, Index j)>;

/// Two triangles for each cell, row by row.
/// @param keeps selects the cells to keep; empty for all
std::vector<Triangle> sheet_faces(const Sheet& sheet, const CellFilter& keeps = {});

/// Returns a sheet with vertex (i, j) at `position(i, j)`. It has the vertices of all cells.
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

// ---- Meshes that are the input of generators.

/// The parameter "input" of a generator that reads a mesh file.
ParameterDescription input_parameter();

/// Reads the mesh of the parameter "input". Any topology is accepted: non-manifold, several
/// components, isolated vertices.
/// @throws MeshError if the file cannot be read or is malformed, for faces of fewer than three
///         different vertices or with one that does not exist, and for coordinates that are not
///         finite
TriangleSoup read_input(const CheckedParameters& parameters);

/// The natural cubic spline through equidistant samples: twice continuously differentiable, with
/// zero curvature at its ends, and of least bending. It reproduces straight lines.
class NaturalSpline {
 public:
  /// @param samples values at 0, 1, 2, ...; at least two
  explicit NaturalSpline(std::vector<double> samples);

  /// The value at `interval` + `part`; exactly the sample's value if `part` is 0.
  /// @param interval below samples - 1
  /// @param part in [0, 1]
  double at(std::size_t interval, double part) const;

  /// The values at `count` + 1 equidistant points from the first sample to the last.
  std::vector<double> resampled(std::size_t count) const;

 private:
  std::vector<double> samples_;
  std::vector<double> curvature_;  // second derivative at each sample
};

}  // namespace geodesic
