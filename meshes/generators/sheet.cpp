#include "meshes/generators/sheet.h"

#include <stdexcept>

namespace geodesic {

ParameterDescription diagonal_parameter(ParameterValue default_value) {
  ParameterDescription parameter =
      choice_parameter("diagonal", {"alternating", "forward", "backward"},
                       "which way each square cell is split into two triangles");
  parameter.default_value = std::move(default_value);
  return parameter;
}

Diagonal diagonal_of(const CheckedParameters& parameters) {
  const std::string& word = parameters.choice("diagonal");
  if (word == "forward") return Diagonal::forward;
  return word == "backward" ? Diagonal::backward : Diagonal::alternating;
}

void check_face_count(double faces) {
  if (3 * faces >= static_cast<double>(kNone))
    throw std::invalid_argument("mesh of " + ParameterValue(faces).text() +
                                " faces is too large, at most 1431655764 can be numbered");
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
  std::vector<Index> renumbered(soup.positions.size(), kNone);
  for (const Triangle& face : soup.triangles)
    for (const Index v : face) renumbered[v] = 0;
  Index kept = 0;
  for (Index v = 0; v < renumbered.size(); ++v) {
    if (renumbered[v] == kNone) continue;
    soup.positions[kept] = soup.positions[v];
    renumbered[v] = kept++;
  }
  soup.positions.resize(kept);
  for (Triangle& face : soup.triangles)
    for (Index& v : face) v = renumbered[v];
}

}  // namespace geodesic
