#include "meshes/generators/sectors.h"

#include "meshes/generators/sheet.h"

namespace geodesic {
namespace {

/// Id of the first vertex of ring r >= 1.
Index first_of_ring(Index sectors, Index r) { return 1 + sectors * (r * (r - 1) / 2); }

/// Vertex k of sector i in ring r, k = r being the first of the next sector.
Index fan_vertex(Index sectors, Index r, Index i, Index k) {
  return r == 0 ? 0 : first_of_ring(sectors, r) + (i * r + k) % (sectors * r);
}

}  // namespace

TriangleSoup sector_fan(const std::vector<Vec3>& directions, Index rings) {
  const auto sectors = static_cast<Index>(directions.size());
  check_face_count(1.0 * sectors * rings * rings);
  TriangleSoup soup;
  soup.positions.push_back({0, 0, 0});
  for (Index r = 1; r <= rings; ++r)
    for (Index i = 0; i < sectors; ++i)
      for (Index k = 0; k < r; ++k) {
        Vec3 point;
        for (std::size_t axis = 0; axis < 3; ++axis)
          point[axis] =
              ((r - k) * directions[i][axis] + k * directions[(i + 1) % sectors][axis]) / rings;
        soup.positions.push_back(point);
      }
  for (Index r = 1; r <= rings; ++r)
    for (Index i = 0; i < sectors; ++i)
      for (Index k = 0; k < r; ++k) {
        const Index inner = fan_vertex(sectors, r - 1, i, k);
        const Index outer = fan_vertex(sectors, r, i, k + 1);
        soup.triangles.push_back({inner, fan_vertex(sectors, r, i, k), outer});
        if (k + 1 < r)
          soup.triangles.push_back({inner, outer, fan_vertex(sectors, r - 1, i, k + 1)});
      }
  return soup;
}

}  // namespace geodesic
