#include <array>

#include "meshes/generators/families.h"
#include "meshes/generators/known_distances.h"
#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

/// The lattice points on the surface of a box of a x b x c unit cells, numbered layer by layer in
/// z: the whole of the first and last layer, the border of those between.
class BoxSurface {
 public:
  BoxSurface(Index a, Index b, Index c) : size_{a, b, c} {
    check_face_count(4 * (1.0 * a * b + 1.0 * b * c + 1.0 * c * a));
  }

  Index vertex(const std::array<Index, 3>& point) const {
    const auto [x, y, z] = point;
    const auto [a, b, c] = size_;
    if (z == 0) return y * (a + 1) + x;
    const Index first_of_layer = layer() + (z - 1) * border();
    return z == c ? first_of_layer + y * (a + 1) + x : first_of_layer + along_border(x, y);
  }

  template <typename Visit>
  void for_each_point(Visit visit) const {
    const auto [a, b, c] = size_;
    for (Index z = 0; z <= c; ++z)
      for (Index y = 0; y <= b; ++y) {
        const bool inside = 0 < z && z < c && 0 < y && y < b;
        for (Index x = 0; x <= a; x += inside ? a : 1) visit(std::array<Index, 3>{x, y, z});
      }
  }

  const std::array<Index, 3>& size() const { return size_; }

 private:
  Index layer() const { return (size_[0] + 1) * (size_[1] + 1); }
  Index border() const { return 2 * (size_[0] + size_[1]); }
  /// Border points of a layer in the order of for_each_point.
  Index along_border(Index x, Index y) const {
    const auto [a, b, c] = size_;
    if (y == 0) return x;
    const Index first_of_row = a + 1 + 2 * (y - 1);
    return y == b ? first_of_row + x : first_of_row + (x == 0 ? 0 : 1);
  }

  std::array<Index, 3> size_;
};

/// Adds the side with normal +`axis` or -`axis`.
void add_side(TriangleSoup& soup, const BoxSurface& box, std::size_t axis, bool positive,
              Diagonal diagonal) {
  // Right-handed (u, v, axis) for the positive side, mirrored for the negative one.
  const std::size_t u = (axis + (positive ? 1 : 2)) % 3, v = (axis + (positive ? 2 : 1)) % 3;
  const Sheet sheet{.columns = box.size()[u], .rows = box.size()[v], .diagonal = diagonal};
  const auto vertex_of = [&](Index id) {
    std::array<Index, 3> point;
    point[axis] = positive ? box.size()[axis] : 0;
    point[u] = id % sheet.vertex_columns();
    point[v] = id / sheet.vertex_columns();
    return box.vertex(point);
  };
  for (const Triangle& face : sheet_faces(sheet))
    soup.triangles.push_back({vertex_of(face[0]), vertex_of(face[1]), vertex_of(face[2])});
}

TriangleSoup make_box(const CheckedParameters& parameters) {
  const BoxSurface box(parameters.integer("x-cells"), parameters.integer("y-cells"),
                       parameters.integer("z-cells"));
  const double spacing = parameters.real("spacing");
  TriangleSoup soup;
  box.for_each_point([&](const std::array<Index, 3>& point) {
    soup.positions.push_back({point[0] * spacing, point[1] * spacing, point[2] * spacing});
  });
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool positive : {false, true})
      add_side(soup, box, axis, positive, diagonal_of(parameters));
  return soup;
}

}  // namespace

Family box() {
  return {{.name = "box",
           .description = "closed box from the origin, of square cells; a cube when all three "
                          "counts are equal; 2 (xy + yz + zx) + 2 vertices",
           .closed_form = "on one side |a - b|; on adjacent sides the least over the unfoldings "
                          "across the shared edge and around its two ends; on opposite sides the "
                          "least over the twelve unfoldings across one or two sides between",
           .parameters = {integer_parameter("x-cells", 16, 1, 10000, "cells along x"),
                          integer_parameter("y-cells", 16, 1, 10000, "cells along y"),
                          integer_parameter("z-cells", 16, 1, 10000, "cells along z"),
                          real_parameter("spacing", 1, 1e-6, 1e6, "side of a cell"),
                          diagonal_parameter()}},
          make_box,
          box_distances};
}

}  // namespace geodesic
