#include "meshes/avoid.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace geodesic {
namespace {

// @param kind, kinds "vertex", "vertices"
void check(const std::vector<Index>& numbers, const std::optional<std::size_t>& flags,
           std::size_t count, const std::string& kind, const std::string& kinds) {
  const std::string of_mesh = std::to_string(count) + " " + kinds;
  if (flags && *flags != count) {
    throw std::invalid_argument("the mask of avoided " + kinds + " has " + std::to_string(*flags) +
                                " flags, but the mesh has " + of_mesh);
  }
  const auto outside = std::ranges::find_if(numbers, [&](Index i) { return i >= count; });
  if (outside != numbers.end()) {
    throw std::invalid_argument("avoided " + kind + " " + std::to_string(*outside) +
                                " is not in the mesh of " + of_mesh);
  }
  if (!flags && numbers.size() > 2 && std::ranges::all_of(numbers, [](Index i) { return i < 2; })) {
    throw std::invalid_argument("the list of avoided " + kinds +
                                " has only the numbers 0 and 1, and repeats them: it must name " +
                                kinds + "; only a mask of booleans has a flag for each of them");
  }
}

}  // namespace

void leave_out(TriangleSoup& soup, const Avoided& avoided) {
  const std::size_t vertices = soup.positions.size();
  check(avoided.vertices, avoided.vertex_flags, vertices, "vertex", "vertices");
  check(avoided.faces, avoided.face_flags, soup.triangles.size(), "face", "faces");
  if (avoided.vertices.empty() && avoided.faces.empty()) return;

  std::vector<bool> is_avoided(vertices, false);
  for (const Index v : avoided.vertices) {
    is_avoided[soup.joined_to.empty() ? v : soup.joined_to[v]] = true;
  }
  const auto before = std::ranges::count(soup.left_out, true);
  soup.left_out.resize(soup.triangles.size(), false);
  for (const Index f : avoided.faces) soup.left_out[f] = true;
  for (Index f = 0; f < soup.triangles.size(); ++f) {
    if (std::ranges::any_of(soup.triangles[f],
                            [&](Index v) { return v < vertices && is_avoided[v]; })) {
      soup.left_out[f] = true;
    }
  }
  const auto after = std::ranges::count(soup.left_out, true);
  if (after > before && static_cast<std::size_t>(after) == soup.triangles.size()) {
    throw std::invalid_argument("no face is left: all of them are avoided");
  }
}

}  // namespace geodesic
