// The families of generators, and the building blocks that several of them share.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meshes/generators/generators.h"

namespace geodesic {

/// A mesh, and one line for each change that was made to the input file's mesh.
struct GeneratedMesh {
  GeneratedMesh(TriangleSoup mesh, std::vector<std::string> lines = {})
      : soup(std::move(mesh)), remarks(std::move(lines)) {}

  TriangleSoup soup;
  std::vector<std::string> remarks;
};

struct Family {
  GeneratorDescription description;
  std::function<GeneratedMesh(const CheckedParameters& parameters)> make;
  /// The closed form where there is one: distances of all vertices from `source`, in the unit of
  /// the positions, on the mesh that `make` returns. It is evaluated on the stored positions in
  /// `long double`: rounding of a position (1e-16 of the mesh's size) is part of the mesh, and
  /// results are good to the last bit or two of a double. Only on cones and saddles does that
  /// rounding also bend faces, by up to 1e-16 of a vertex's distance from the apex, which no
  /// unrolled plane shows.
  std::vector<double> (*known_distances)(const CheckedParameters& parameters,
                                         const TriangleSoup& soup, Index source) = nullptr;
};

// The families, one function a source file.
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

/// Distances of all vertices: `distance(v)`, rounded to double.
template <typename Distance>
std::vector<double> distances_to_all(const TriangleSoup& soup, Distance distance) {
  std::vector<double> distances(soup.positions.size());
  for (Index v = 0; v < distances.size(); ++v) distances[v] = static_cast<double>(distance(v));
  return distances;
}

// ---- Sine and cosine with the same bits on every machine. The C library's differ in the last bit
// between processors (it picks variants with and without fused multiply-add at run time) and
// between versions. Rounding their results to a coarser grid only makes a difference rare and bends
// flat faces; these functions use nothing but + - * /.

struct CirclePoint {
  double cosine;
  double sine;
};

inline constexpr double kTwoPi = 6.283185307179586476925;

/// The point of the unit circle at an angle, in turns (1 = 360 degrees), which is finite. Its error
/// is below 4e-16 for |turns| <= 1, and eighths of turns have their symmetries.
CirclePoint circle_point(double turns);

/// The corners of the regular n-gon: entry i at i / n turns.
std::vector<CirclePoint> regular_polygon(Index n);

// ---- Sheets: a rectangle of square cells, each split into two triangles, laid out over any
// surface and closed into a tube or torus where its columns or rows wrap.

/// How a cell is split: forward from its corner (i, j) to (i+1, j+1), backward from (i+1, j) to
/// (i, j+1), alternating forward where i + j is even.
enum class Diagonal { forward, backward, alternating };

ParameterDescription diagonal_parameter(ParameterValue default_value = "alternating");
Diagonal diagonal_of(const CheckedParameters& parameters);

/// Column i runs along the surface's first parameter, row j along its second; the normal is first
/// x second. Vertex (i, j) has id j * vertex_columns() + i.
struct Sheet {
  Index columns = 1;  ///< cells
  Index rows = 1;
  Diagonal diagonal = Diagonal::forward;
  bool columns_wrap = false;  ///< the last column's right side is the first one's left side
  bool rows_wrap = false;

  Index vertex_columns() const { return columns_wrap ? columns : columns + 1; }
  Index vertex_rows() const { return rows_wrap ? rows : rows + 1; }
};

/// The open sheet of two parameters' cells and the parameter "diagonal".
Sheet sheet_of(const CheckedParameters& parameters, std::string_view columns,
               std::string_view rows);

/// Refuses a mesh whose half-edges an Index cannot number, before memory is spent on it.
/// @throws std::invalid_argument
void check_face_count(double faces);

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

// ---- Meshes that generators start from.

/// The parameter "input" of a generator that starts from a mesh file.
ParameterDescription input_parameter();

/// Reads the mesh of the parameter "input". Its topology may be anything: non-manifold, in several
/// components, with isolated vertices.
/// @throws MeshError when the file cannot be read or is malformed, for faces that name a vertex
/// twice
///         or one that does not exist, and for coordinates that are not finite
TriangleSoup read_input(const CheckedParameters& parameters);

/// The natural cubic spline through samples at equal distances: twice continuously differentiable,
/// without curvature at its ends, of least bending. It reproduces straight lines.
class NaturalSpline {
 public:
  /// @param samples values at 0, 1, 2, ...; at least two
  explicit NaturalSpline(std::vector<double> samples);

  /// The value at `interval` + `part`; that of the sample, exactly, where `part` is 0.
  /// @param interval below samples - 1
  /// @param part in [0, 1]
  double at(std::size_t interval, double part) const;

  /// The curve at `count` + 1 points at equal distances from the first sample to the last.
  std::vector<double> resampled(std::size_t count) const;

 private:
  std::vector<double> samples_;
  std::vector<double> curvature_;  // second derivative at each sample
};

}  // namespace geodesic
