#include "harness/corpus/sources.h"

#include <algorithm>

#include "meshes/random.h"

namespace geodesic::harness {
namespace {

constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15;  // meshes/random.h

// Fowler, Noll, Vo: FNV-1a with 64 bits.
std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

std::vector<Index> vertices_of_faces(const TriangleSoup& soup) {
  std::vector<bool> used(soup.positions.size(), false);
  for (const Triangle& triangle : soup.triangles) {
    for (const Index v : triangle) used[v] = true;
  }
  std::vector<Index> vertices;
  for (Index v = 0; v < used.size(); ++v) {
    if (used[v]) vertices.push_back(v);
  }
  return vertices;
}

/// Whether each vertex lies on an edge that has no opposite half-edge.
std::vector<bool> on_boundary(const TriangleSoup& soup) {
  std::vector<std::pair<Index, Index>> half_edges;
  half_edges.reserve(3 * soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles)
    half_edges.insert(half_edges.end(), {{a, b}, {b, c}, {c, a}});
  std::sort(half_edges.begin(), half_edges.end());
  std::vector<bool> boundary(soup.positions.size(), false);
  for (const auto& [from, to] : half_edges) {
    if (std::binary_search(half_edges.begin(), half_edges.end(), std::pair(to, from))) continue;
    boundary[from] = boundary[to] = true;
  }
  return boundary;
}

}  // namespace

std::vector<Index> choose_sources(const TriangleSoup& soup, std::string_view mesh, int count,
                                  std::uint64_t seed) {
  std::vector<Index> candidates = vertices_of_faces(soup);
  const std::size_t wanted = std::min(static_cast<std::size_t>(count), candidates.size());
  std::uint64_t state = seed ^ hash(mesh);
  std::size_t chosen = !candidates.empty() && candidates.front() == 0 ? 1 : 0;
  // Fisher-Yates, as far as it is needed, of what `chosen` leaves: first of the boundary vertices,
  // so that one of them is the next source, then of all.
  const auto take_one_of_first = [&](std::size_t many) {
    std::swap(candidates[chosen], candidates[chosen + split_mix(state) % many]);
    state += kSplitMixStep;
    ++chosen;
  };
  if (chosen < wanted) {
    const std::vector<bool> boundary = on_boundary(soup);
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
