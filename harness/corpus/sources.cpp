#include "harness/corpus/sources.h"

#include <algorithm>

namespace geodesic::harness {
namespace {

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

}  // namespace

std::uint64_t SplitMix64::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

std::vector<Index> choose_sources(const TriangleSoup& soup, std::string_view mesh, int count,
                                  std::uint64_t seed) {
  std::vector<Index> candidates = vertices_of_faces(soup);
  const std::size_t wanted = std::min(static_cast<std::size_t>(count), candidates.size());
  SplitMix64 random(seed ^ hash(mesh));
  // Fisher-Yates, as far as it is needed; vertex 0 keeps its place at the front.
  std::size_t chosen = !candidates.empty() && candidates.front() == 0 ? 1 : 0;
  for (; chosen < wanted; ++chosen) {
    std::swap(candidates[chosen],
              candidates[chosen + random.next() % (candidates.size() - chosen)]);
  }
  candidates.resize(wanted);
  return candidates;
}

}  // namespace geodesic::harness
