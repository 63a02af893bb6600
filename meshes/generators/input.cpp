#include "meshes/generators/input.h"

#include <algorithm>
#include <string>

#include "meshes/mesh_file.h"
#include "solvers/core/geometry.h"

namespace geodesic {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
  throw MeshError(file + ": " + what + "; make a usable mesh of it first: generate clean --input " +
                  file);
}

void require_usable(const TriangleSoup& soup, const std::string& file) {
  for (Index f = 0; f < soup.triangles.size(); ++f) {
    const auto& [a, b, c] = soup.triangles[f];
    if (std::max({a, b, c}) >= soup.positions.size()) {
      refuse(file, "face " + std::to_string(f) + " names a vertex that is not there");
    }
    if (a == b || b == c || c == a) {
      refuse(file, "face " + std::to_string(f) + " names a vertex twice");
    }
  }
  for (Index v = 0; v < soup.positions.size(); ++v) {
    if (!is_finite(soup.positions[v])) {
      refuse(file, "vertex " + std::to_string(v) + " is not finite");
    }
  }
}

}  // namespace

ParameterDescription input_parameter() {
  return file_parameter("input", "the mesh to start from, OBJ, OFF, PLY or STL");
}

TriangleSoup read_input(const CheckedParameters& parameters) {
  const std::string& file = parameters.file("input");
  TriangleSoup soup = read_mesh(file).soup;
  require_usable(soup, file);
  return soup;
}

}  // namespace geodesic
