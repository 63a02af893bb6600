// Transforms a mesh into one that is difficult for solvers: other units, far from the origin, cut
// open, in several parts, pinched, with isolated vertices.
#include <algorithm>
#include <string>
#include <utility>

#include "meshes/connectivity.h"
#include "meshes/generators/families.h"

namespace geodesic {
namespace {

/// Removes the first faces, and vertices that then are isolated.
void drop_first_faces(TriangleSoup& soup, Index count) {
  const auto dropped = std::min<std::size_t>(count, soup.triangles.size());
  if (dropped == 0) return;
  soup.triangles.erase(soup.triangles.begin(),
                       soup.triangles.begin() + static_cast<std::ptrdiff_t>(dropped));
  drop_isolated_vertices(soup);
}

/// Gives every face its own three vertices.
void separate_faces(TriangleSoup& soup) {
  std::vector<Vec3> corners;
  for (Triangle& face : soup.triangles) {
    for (Index& v : face) {
      corners.push_back(soup.positions[v]);
      v = static_cast<Index>(corners.size() - 1);
    }
  }
  soup.positions = std::move(corners);
}

/// Adds the mesh reflected at its vertex 0, the only vertex of both parts.
void pinch(TriangleSoup& soup) {
  const auto count = static_cast<Index>(soup.positions.size());
  const std::size_t faces = soup.triangles.size();
  const Vec3 twice = scale(2, soup.positions[0]);
  for (Index v = 1; v < count; ++v) soup.positions.push_back(subtract(twice, soup.positions[v]));
  const auto image = [&](Index v) { return v == 0 ? 0 : count - 1 + v; };
  for (std::size_t f = 0; f < faces; ++f) {
    const auto [a, b, c] = soup.triangles[f];
    soup.triangles.push_back({image(a), image(b), image(c)});
  }
}

/// Adds copies next to each other along x, separated by the width of the mesh.
void repeat(TriangleSoup& soup, Index copies) {
  check_face_count(1.0 * static_cast<double>(soup.triangles.size()) * copies);
  const TriangleSoup first = soup;
  const Box box = box_around(first.positions);
  const double step = 2 * (box.high[0] - box.low[0]);
  for (Index copy = 1; copy < copies; ++copy) {
    TriangleSoup moved = first;
    for (Vec3& p : moved.positions) p[0] += copy * step;
    soup = side_by_side(std::move(soup), moved);
  }
}

/// Adds vertices without faces, above the mesh.
void add_isolated(TriangleSoup& soup, Index count) {
  const Box box = box_around(soup.positions);
  const double step = 2 * box.half_extent();
  for (Index i = 1; i <= count; ++i) soup.positions.push_back(add(box.high, {0, 0, i * step}));
}

TriangleSoup make_transform(const CheckedParameters& parameters) {
  TriangleSoup soup = read_input(parameters);
  drop_first_faces(soup, parameters.integer("without"));
  if (parameters.text("vertices") == "own") separate_faces(soup);
  if (parameters.text("pinched") == "yes") pinch(soup);
  repeat(soup, parameters.integer("copies"));
  add_isolated(soup, parameters.integer("isolated"));
  const double factor = parameters.real("scale"), shift = parameters.real("shift");
  for (Vec3& p : soup.positions) p = add(scale(factor, p), {shift, shift, shift});
  return soup;
}

}  // namespace

Family transform() {
  return {
      {.name = "transform",
       .description = "a mesh in another unit and place, cut open, in parts, pinched: what the "
                      "parameters name, in the order in which they are listed",
       .parameters =
           {input_parameter(),
            integer_parameter("without", 0, 0, kNone - 1, "faces left out, from the first"),
            choice_parameter("vertices", {"shared", "own"},
                             "whether faces share them, or each has three of its own"),
            choice_parameter("pinched", {"no", "yes"},
                             "whether the mesh is joined, at its vertex 0 alone, to its image "
                             "in that point"),
            integer_parameter("copies", 1, 1, 100000, "side by side along x"),
            integer_parameter("isolated", 0, 0, 100000, "vertices of no face, added at the end"),
            real_parameter("scale", 1, 1e-100, 1e100, "factor of all coordinates"),
            real_parameter("shift", 0, -1e100, 1e100, "added to all coordinates after scaling")}},
      make_transform};
}

}  // namespace geodesic
