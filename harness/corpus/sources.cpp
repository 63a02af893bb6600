#include "harness/corpus/sources.h"

#include <algorithm>

#include "meshes/connectivity.h"
#include "meshes/random.h"

namespace geodesic::harness {
namespace {

// Fowler, Noll, Vo: FNV-1a with 64 bits.
std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

std::vector<Index> vertices_of_faces(const TriangleSoup& soup) {
  const std::vector<bool> used = used_vertices(soup.triangles, soup.positions.size());
  std::vector<Index> vertices;
  for (Index v = 0; v < used.size(); ++v) {
    if (used[v]) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace

std::vector<Index> choose_sources(const TriangleSoup& soup, std::string_view mesh, int count,
                                  std::uint64_t seed) {
  std::vector<Index> candidates = vertices_of_faces(soup);
  const std::size_t wanted = std::min(static_cast<std::size_t>(count), candidates.size());
  SplitMix64 random(seed ^ hash(mesh));
  std::size_t chosen = !candidates.empty() && candidates.front() == 0 ? 1 : 0;
  // Fisher-Yates, as far as it is needed, of what `chosen` leaves: first of the boundary vertices,
  // so that one of them is the next source, then of all.
  const auto take_one_of_first = [&](std::size_t many) {
    std::swap(candidates[chosen], candidates[chosen + random.next() % many]);
    ++chosen;
  };
  if (chosen < wanted) {
    const std::vector<bool> boundary = boundary_vertices(soup);
    const auto rest = candidates.begin() + static_cast<std::ptrdiff_t>(chosen);
    const auto inner =
        std::stable_partition(rest, candidates.end(), [&](Index v) { return boundary[v]; });
    if (inner != rest) take_one_of_first(static_cast<std::size_t>(inner - rest));
  }
  while (chosen < wanted) take_one_of_first(candidates.size() - chosen);
  candidates.resize(wanted);
  return candidates;
}

}  // namespace geodesic::harness
