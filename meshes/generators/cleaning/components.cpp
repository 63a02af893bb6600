#include <algorithm>

#include "meshes/disjoint_sets.h"
#include "meshes/generators/cleaning/steps.h"

namespace geodesic {

std::vector<RepairAction> keep_largest_component(TriangleSoup& soup) {
  DisjointSets components(soup.positions.size());
  for (const Triangle& face : soup.triangles) {
    components.join(face[0], face[1]);
    components.join(face[0], face[2]);
  }
  std::vector<std::size_t> sizes(soup.positions.size(), 0);
  for (const Triangle& face : soup.triangles) ++sizes[components.find(face[0])];
  const std::size_t greatest = *std::max_element(sizes.begin(), sizes.end());
  const auto found = std::find_if(
      soup.triangles.begin(), soup.triangles.end(),
      [&](const Triangle& face) { return sizes[components.find(face[0])] == greatest; });
  if (found == soup.triangles.end()) return {};
  const Index largest = components.find((*found)[0]);
  const auto dropped = static_cast<std::size_t>(
      std::count_if(sizes.begin(), sizes.end(), [](std::size_t size) { return size > 0; }) - 1);
  std::erase_if(soup.triangles,
                [&](const Triangle& face) { return components.find(face[0]) != largest; });
  if (dropped == 0) return {};
  return {{"dropped_components", "smaller components dropped", dropped}};
}

}  // namespace geodesic
