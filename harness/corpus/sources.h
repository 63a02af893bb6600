// The source vertices of a mesh, the same for every solver: single vertices that a seed chooses,
// and sets of vertices. Each set is one query.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/core/query.h"

namespace geodesic::harness {

/// Chooses distinct source vertices among the vertices of faces. Vertex 0 is first if possible,
/// then a random boundary vertex if there is one, then random vertices. Fewer sources are a prefix
/// of more.
/// @param mesh the mesh's name, so that meshes of one size get different vertices
/// @param count at least 1
/// @return count vertices, or all if there are fewer
std::vector<Index> choose_sources(const TriangleSoup& soup, std::string_view mesh, int count,
                                  std::uint64_t seed);

/// A query for all distances from the nearest of some vertices.
Query query_from(const std::vector<Index>& vertices);

/// The sources of one query.
struct SourceSet {
  std::string name;             ///< number of a single vertex, otherwise name of the set
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

/// The name of a set: the word itself, or the name of its file without folder and extension.
/// @throws HarnessError for a word in none of these forms
std::string name_of_source_set(const std::string& word);

/// @param word as in `name_of_source_set`
/// @param mesh,seed as in `choose_sources`
/// @return nothing if the mesh has no such vertex
/// @throws HarnessError for a file that has anything but vertices of the mesh
std::optional<SourceSet> find_source_set(const std::string& word, const TriangleSoup& soup,
                                         std::string_view mesh, std::uint64_t seed);

/// Reads the vertices of a file of points in the format of `solve --sources-file`.
/// @throws HarnessError for anything but vertices
std::vector<Index> read_source_vertices(const std::filesystem::path& file);

/// Writes vertices to a file for `read_source_vertices`. @throws CannotWrite
void write_source_vertices(const std::filesystem::path& file, const std::vector<Index>& vertices);

/// Vertices far from each other: equal steps through the reached vertices in the mesh's internal
/// order, which follows the surface. All vertices here have external numbers.
/// @param first the first of the result; it must be reached
/// @param distances by external number, infinite for vertices that are not reached
/// @return count vertices, or all reached ones if there are fewer
std::vector<Index> spread_vertices(const Mesh& mesh, Index first, std::size_t count,
                                   std::span<const double> distances);

}  // namespace geodesic::harness
