// The corpus as data: datasets/manifest.json (datasets/README.md describes it) and the cache that
// its meshes lie in.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "harness/base/json.h"
#include "meshes/generators/generators.h"

namespace geodesic::harness {

/// What makes a mesh out of nothing but numbers.
struct Recipe {
  std::string generator;
  GeneratorParameters parameters;
};

struct MeshEntry {
  std::string name;
  std::filesystem::path file;  ///< where it is, or would be, in the cache
  std::string kind;  ///< "generated", "downloaded", "package", or "file" when given by its path
  std::size_t vertices = 0, faces = 0;           ///< of the manifest's meshes; of other files 0
  std::optional<std::string> thesis_model = {};  ///< its row in the thesis's tables
  bool stand_in = false;                         ///< stands for that model without being it
  std::optional<Recipe> recipe = {};      ///< of a generated mesh that is made from no other file
  std::string why = {};                   ///< it is in the corpus; one line
  std::vector<Index> sources = {};        ///< to solve from; empty: chosen by the seed
  std::vector<std::string> reports = {};  ///< of users of other codes on such a mesh: addresses

  bool available() const {
    std::error_code unreadable;
    return std::filesystem::is_regular_file(file, unreadable);
  }
};

/// Names of meshes by the name of the corpus.
using Corpora = std::map<std::string, std::vector<std::string>>;

class Manifest {
 public:
  /// @throws HarnessError when the file cannot be read or says something it must not
  Manifest(const std::filesystem::path& file, const std::filesystem::path& cache);
  /// As the other one on a file's content.
  /// @param name what messages call the file
  Manifest(Json json, const std::string& name, const std::filesystem::path& cache);

  /// As in the file.
  const Json& json() const { return json_; }
  const std::vector<MeshEntry>& meshes() const { return meshes_; }
  const Corpora& corpora() const { return corpora_; }

  /// @throws HarnessError for an unknown name, listing the known ones
  const MeshEntry& mesh(std::string_view name) const;
  std::vector<MeshEntry> corpus(const std::string& name) const;

 private:
  Json json_;
  std::vector<MeshEntry> meshes_;
  Corpora corpora_;
};

/// datasets/manifest.json of the data folder (folders.h).
std::filesystem::path default_manifest();

/// $GEODESIC_DATASETS, by default datasets/cache in the data folder.
std::filesystem::path dataset_cache();

/// What users write for several meshes, as files and names of the manifest: a folder stands for the
/// mesh files in it, a pattern of the shell (scans/*.ply) for the mesh files it matches, in the
/// order of their names; other words stay as they are.
/// @throws HarnessError for a folder without mesh files and for a pattern that matches none
std::vector<std::string> expand_meshes(const std::vector<std::string>& words);

/// All mesh files in a folder and in those below it, links to folders apart, in the order of their
/// paths. @throws HarnessError for a folder without one
std::vector<std::string> mesh_files_below(const std::filesystem::path& folder);

/// Names of files below a folder: `set/cube.obj` is "set.cube". Where that names two of them, both
/// keep their extension.
std::vector<std::string> names_below(const std::filesystem::path& folder,
                                     const std::vector<std::string>& files);

/// A mesh that a user names: the path of a file, or a name of the manifest, which is read only in
/// the second case. @throws HarnessError when it is neither, or not in the cache
MeshEntry find_mesh(const std::string& file_or_name, const std::filesystem::path& manifest);

/// One line: that the meshes, at least one, are not in the cache, and how to get them there.
std::string how_to_get(std::span<const MeshEntry> meshes);
std::string how_to_get(const MeshEntry& mesh);

}  // namespace geodesic::harness
