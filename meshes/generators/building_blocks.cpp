#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "meshes/connectivity.h"
#include "meshes/generators/families.h"
#include "meshes/mesh_file.h"

namespace geodesic {
namespace {

/// 1 - x^2 / (k (k+1)) * (1 - x^2 / ((k+2) (k+3)) * (...)): the Taylor series of the cosine for
/// k = 1, of sin(x) / x for k = 2. Twenty factors reach 1e-20 for |x| <= pi / 4.
double nested_series(double x, int k) {
  double sum = 1;
  for (int i = k + 18; i >= k; i -= 2) sum = 1 - sum * (x * x) / (i * (i + 1));
  return sum;
}

}  // namespace

CirclePoint circle_point(double turns) {
  const double fraction = turns - std::floor(turns);
  const double quarter = std::floor(4 * fraction + 0.5);
  // The difference is exact (Sterbenz) and within an eighth of a turn of a coordinate axis.
  const double x = (fraction - quarter / 4) * kTwoPi;
  const double cosine = nested_series(x, 1);
  const double sine = x * nested_series(x, 2);
  switch (static_cast<int>(quarter) % 4) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

std::vector<CirclePoint> regular_polygon(Index n) {
  std::vector<CirclePoint> corners(n);
  for (Index i = 0; i < n; ++i) corners[i] = circle_point(static_cast<double>(i) / n);
  return corners;
}

ParameterDescription diagonal_parameter(ParameterValue default_value) {
  ParameterDescription parameter =
      choice_parameter("diagonal", {"alternating", "forward", "backward"},
                       "which way each square cell is split into two triangles");
  parameter.default_value = std::move(default_value);
  return parameter;
}

Diagonal diagonal_of(const CheckedParameters& parameters) {
  const std::string& word = parameters.text("diagonal");
  if (word == "forward") return Diagonal::forward;
  return word == "backward" ? Diagonal::backward : Diagonal::alternating;
}

Sheet sheet_of(const CheckedParameters& parameters, std::string_view columns,
               std::string_view rows) {
  return {.columns = parameters.integer(columns),
          .rows = parameters.integer(rows),
          .diagonal = diagonal_of(parameters)};
}

void check_face_count(double faces) {
  if (3 * faces >= static_cast<double>(kNone)) {
    throw std::invalid_argument("mesh of " + ParameterValue(faces).text() +
                                " faces is too large, at most 1431655764 can be numbered");
  }
}

std::vector<Triangle> sheet_faces(const Sheet& sheet, const CellFilter& keeps) {
  check_face_count(2.0 * sheet.columns * sheet.rows);
  std::vector<Triangle> faces;
  faces.reserve(std::size_t{2} * sheet.columns * sheet.rows);
  const Index width = sheet.vertex_columns();
  for (Index j = 0; j < sheet.rows; ++j) {
    const Index lower = j * width;
    const Index upper = (j + 1) % sheet.vertex_rows() * width;
    for (Index i = 0; i < sheet.columns; ++i) {
      if (keeps && !keeps(i, j)) continue;
      const Index right = i + 1 == width ? 0 : i + 1;
      const Index a = lower + i, b = lower + right, c = upper + right, d = upper + i;
      const bool forward = sheet.diagonal == Diagonal::forward ||
                           (sheet.diagonal == Diagonal::alternating && (i + j) % 2 == 0);
      faces.push_back(forward ? Triangle{a, b, c} : Triangle{a, b, d});
      faces.push_back(forward ? Triangle{a, c, d} : Triangle{b, c, d});
    }
  }
  return faces;
}

void drop_isolated_vertices(TriangleSoup& soup) {
  const std::vector<bool> used = used_vertices(soup.triangles, soup.positions.size());
  std::vector<Index> renumbered(used.size());
  Index kept = 0;
  for (Index v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    soup.positions[kept] = soup.positions[v];
    renumbered[v] = kept++;
  }
  soup.positions.resize(kept);
  for (Triangle& face : soup.triangles) {
    for (Index& v : face) v = renumbered[v];
  }
}

ParameterDescription input_parameter() {
  return file_parameter("input", "the mesh to start from, OBJ, OFF, PLY or STL");
}

TriangleSoup read_input(const CheckedParameters& parameters) {
  const std::string& file = parameters.text("input");
  TriangleSoup soup = read_mesh_file(file).soup;
  const auto refuse = [&](const std::string& element, Index id, const std::string& what) {
    throw MeshError(file + ": " + element + " " + std::to_string(id) + " " + what +
                    "; clean the mesh first: generate clean --input " + file);
  };
  for (Index f = 0; f < soup.triangles.size(); ++f) {
    if (std::ranges::max(soup.triangles[f]) >= soup.positions.size()) {
      refuse("face", f, "names a vertex that does not exist");
    }
    if (names_a_vertex_twice(soup.triangles[f])) {
      refuse("face", f, "has fewer than three different vertices");
    }
  }
  for (Index v = 0; v < soup.positions.size(); ++v) {
    if (!is_finite(soup.positions[v])) refuse("vertex", v, "is not finite");
  }
  return soup;
}

}  // namespace geodesic
