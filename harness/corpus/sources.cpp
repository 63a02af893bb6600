#include "harness/corpus/sources.h"

#include <algorithm>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/corpus/points.h"
#include "meshes/connectivity.h"
#include "meshes/random.h"
#include "solvers/core/number_text.h"

namespace geodesic::harness {
namespace {

// Fowler, Noll, Vo: FNV-1a with 64 bits.
std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

std::vector<Index> flagged(const std::vector<bool>& flags) {
  std::vector<Index> vertices;
  for (Index v = 0; v < flags.size(); ++v) {
    if (flags[v]) vertices.push_back(v);
  }
  return vertices;
}

std::vector<Index> vertices_of_faces(const TriangleSoup& soup) {
  return flagged(used_vertices(soup.triangles, soup.positions.size()));
}

constexpr std::string_view kRandom = "random:", kBoundary = "boundary", kComponents = "components";

// The first vertex of each component.
std::vector<Index> one_of_each_component(const TriangleSoup& soup) {
  const std::vector<bool> usable(soup.triangles.size(), true);
  std::vector<Index> vertices;
  DisjointSets components = join_vertices(soup.triangles, usable, soup.positions.size());
  for (const Index v : vertices_of_faces(soup)) {
    if (components.find(v) == v) vertices.push_back(v);
  }
  return vertices;
}

std::vector<Index> vertices_in_file(const std::string& file, const TriangleSoup& soup) {
  std::vector<Index> vertices = read_source_vertices(file);
  for (const Index v : vertices) {
    if (v >= soup.positions.size()) {
      throw HarnessError("the set of sources '" + file + "' has vertex " + std::to_string(v) +
                         ", and the mesh has " + std::to_string(soup.positions.size()));
    }
  }
  return vertices;
}

}  // namespace

bool SourceSet::is_single() const { return number_in<Index>(name).has_value(); }

Query query_from(const std::vector<Index>& vertices) {
  Query query;
  for (const Index v : vertices) query.sources.push_back({.at = v});
  return query;
}

SourceSet single_source(Index vertex) { return {std::to_string(vertex), {vertex}}; }

std::string name_of_source_set(const std::string& word) {
  if (word == kBoundary || word == kComponents) return word;
  if (word.starts_with(kRandom)) {
    const std::optional<Index> count =
        number_in<Index>(std::string_view(word).substr(kRandom.size()));
    if (count.value_or(0) > 0 && *count < kMostRandomSources) return word;
  } else if (std::filesystem::is_regular_file(word)) {
    std::string name = std::filesystem::path(word).stem().string();
    check_name("name of a set of sources", name);
    if (!number_in<Index>(name)) return name;
    throw HarnessError("the file " + excerpt(word) +
                       " has the name of a vertex: a set of sources is called as its file");
  }
  throw HarnessError("no set of sources: " + excerpt(word) + "; give " + kSourceSetForms);
}

std::optional<SourceSet> find_source_set(const std::string& word, const TriangleSoup& soup,
                                         std::string_view mesh, std::uint64_t seed) {
  SourceSet set{.name = name_of_source_set(word), .vertices = {}};
  if (word == kBoundary) {
    set.vertices = flagged(boundary_vertices(soup));
  } else if (word == kComponents) {
    set.vertices = one_of_each_component(soup);
  } else if (word.starts_with(kRandom)) {
    const Index count = number_in<Index>(std::string_view(word).substr(kRandom.size())).value();
    set.vertices = choose_sources(soup, mesh, static_cast<int>(count), seed);
  } else {
    set.vertices = vertices_in_file(word, soup);
  }
  if (set.vertices.empty()) return std::nullopt;
  return set;
}

std::vector<Index> read_source_vertices(const std::filesystem::path& file) {
  const std::string flag = "set of sources";
  std::vector<Index> vertices;
  for (const WrittenPoint& point : read_points(file, flag)) {
    if (point.kind != WrittenPoint::Kind::vertex || point.initial) {
      throw HarnessError(point.text + ": a set of a run has vertices only");
    }
    vertices.push_back(point.elements[0]);
  }
  return vertices;
}

void write_source_vertices(const std::filesystem::path& file, const std::vector<Index>& vertices) {
  write_bytes(file, Json(vertices).dump() + '\n');
}

std::vector<Index> choose_sources(const TriangleSoup& soup, std::string_view mesh, int count,
                                  std::uint64_t seed) {
  std::vector<Index> candidates = vertices_of_faces(soup);
  const std::size_t wanted = std::min(static_cast<std::size_t>(count), candidates.size());
  SplitMix64 random(seed ^ hash(mesh));
  std::size_t chosen = !candidates.empty() && candidates.front() == 0 ? 1 : 0;
  // Fisher-Yates for as many candidates as are needed, after the `chosen` ones: first among the
  // boundary vertices, so that one of them is the next source, then among all.
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

std::vector<Index> spread_vertices(const Mesh& mesh, Index first, std::size_t count,
                                   std::span<const double> distances) {
  std::vector<Index> reached;  // in the mesh's internal order
  std::size_t at = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index given = mesh.numbers().external_vertex(v);
    if (given == first) at = reached.size();
    if (distances[given] < kInfinity) reached.push_back(given);
  }
  count = std::min(count, reached.size());
  std::vector<Index> spread;
  for (std::size_t i = 0; i < count; ++i) {
    spread.push_back(reached[(at + i * reached.size() / count) % reached.size()]);
  }
  return spread;
}

}  // namespace geodesic::harness
