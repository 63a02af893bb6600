// Which vertices a mesh is solved from, the same for every solver: single ones that a seed chooses,
// and sets of them, each of which is one query.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/core/query.h"

namespace geodesic::harness {

/// Chooses distinct source vertices, never one that no face has: vertex 0 first where it can be,
/// then a random boundary vertex where there is one, then random ones. Fewer sources are a prefix
/// of more.
/// @param mesh the mesh's name, so that meshes of one size get different vertices
/// @param count at least 1
/// @return count vertices, or all that there are
std::vector<Index> choose_sources(const TriangleSoup& soup, std::string_view mesh, int count,
                                  std::uint64_t seed);

/// All distances from the nearest of some vertices.
Query query_from(const std::vector<Index>& vertices);

/// What one query starts from.
struct SourceSet {
  std::string name;             ///< of a single vertex its number
  std::vector<Index> vertices;  ///< at least one

  bool is_single() const;
  Query query() const { return query_from(vertices); }
};

SourceSet single_source(Index vertex);

inline constexpr Index kMostRandomSources = 1'000'000'000;

/// The forms of sets, for help and messages.
inline constexpr const char* kSourceSetForms =
    "random:N (N vertices chosen by the seed), boundary, components (a vertex of each), or a file "
    "of vertices";

/// What a set is called: as it is written, or as its file without folder and extension.
/// @throws HarnessError for a word of none of these forms
std::string name_of_source_set(const std::string& word);

/// @param word as of `name_of_source_set`
/// @param mesh,seed as of `choose_sources`
/// @return nothing where the mesh has no such vertex
/// @throws HarnessError for a file that has anything but vertices of the mesh
std::optional<SourceSet> find_source_set(const std::string& word, const TriangleSoup& soup,
                                         std::string_view mesh, std::uint64_t seed);

/// The vertices of a file of points, as `solve --sources-file` takes it.
/// @throws HarnessError for anything but vertices
std::vector<Index> read_source_vertices(const std::filesystem::path& file);

/// Writes such a file. @throws CannotWrite
void write_source_vertices(const std::filesystem::path& file, const std::vector<Index>& vertices);

/// Vertices far from each other: equal steps of the mesh's own order, which follows the surface,
/// over those that are reached.
/// @param first comes first, by its external number as all of these; it is reached
/// @param distances by external number, infinite where nothing is reached
/// @return count vertices, fewer where fewer are reached
std::vector<Index> spread_vertices(const Mesh& mesh, Index first, std::size_t count,
                                   std::span<const double> distances);

}  // namespace geodesic::harness
