// The corpus as data: datasets/manifest.json (datasets/README.md describes it), and the cache for
// its meshes.
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

/// A generator and its parameters, for a mesh that is made from numbers alone.
struct Recipe {
  std::string generator;
  GeneratorParameters parameters;
};

struct MeshEntry {
  std::string name;
  std::filesystem::path file;  ///< where it is, or would be, in the cache
  std::string kind;  ///< "generated", "downloaded", "package", or "file" when given by its path
  std::string sha256 = {};  ///< from the manifest: of the file; zeros or empty: not known
  std::size_t vertices = 0, faces = 0;           ///< from the manifest; 0 for other files
  std::optional<std::string> thesis_model = {};  ///< its row in the thesis's tables
  bool stand_in = false;                         ///< replaces that model, but is another mesh
  std::optional<Recipe> recipe = {};             ///< of a generated mesh that needs no other file
  std::string why = {};                          ///< reason to be in the corpus; one line
  std::vector<Index> sources = {};        ///< vertices to solve from; empty: the seed chooses
  std::vector<std::string> reports = {};  ///< addresses of reports by users of other codes

  bool available() const {
    std::error_code unreadable;
    return std::filesystem::is_regular_file(file, unreadable);
  }
};

/// Mesh names by corpus name.
using Corpora = std::map<std::string, std::vector<std::string>>;

class Manifest {
 public:
  /// @throws HarnessError when the file cannot be read or is not a valid manifest
  Manifest(const std::filesystem::path& file, const std::filesystem::path& cache);
  /// Like the other constructor, for the content of a file.
  /// @param name the file in messages
  Manifest(Json json, const std::string& name, const std::filesystem::path& cache);

  /// The content of the file.
  const Json& json() const { return json_; }
  const std::vector<MeshEntry>& meshes() const { return meshes_; }
  const Corpora& corpora() const { return corpora_; }

  /// @throws HarnessError for an unknown name; the message lists the known ones
  const MeshEntry& mesh(std::string_view name) const;
  std::vector<MeshEntry> corpus(const std::string& name) const;

 private:
  Json json_;
  std::vector<MeshEntry> meshes_;
  Corpora corpora_;
};

/// datasets/manifest.json in the data folder (base/files.h).
std::filesystem::path default_manifest();

/// $GEODESIC_DATASETS, by default datasets/cache in the data folder.
std::filesystem::path dataset_cache();

/// Expands the words for several meshes into files and names of the manifest. A folder stands for
/// its mesh files, a pattern of the shell (scans/*.ply) for the mesh files that match, sorted by
/// name. Other words stay as they are.
/// @throws HarnessError for a folder without mesh files and for a pattern without matches
std::vector<std::string> expand_meshes(const std::vector<std::string>& words);

/// All mesh files in a folder and the folders below it, sorted by path. Links to folders are not
/// followed. @throws HarnessError for a folder without mesh files
std::vector<std::string> mesh_files_below(const std::filesystem::path& folder);

/// Names for files below a folder: `set/cube.obj` is "set.cube". If two files would have the same
/// name, both keep their extension.
std::vector<std::string> names_below(const std::filesystem::path& folder,
                                     const std::vector<std::string>& files);

/// Finds a mesh by the path of a file or by its name in the manifest, which is read only in the
/// second case. @throws HarnessError when it is neither, or is not in the cache
MeshEntry find_mesh(const std::string& file_or_name, const std::filesystem::path& manifest);

/// One line: the meshes, at least one, are not in the cache, and how to get them.
std::string how_to_get(std::span<const MeshEntry> meshes);
std::string how_to_get(const MeshEntry& mesh);

/// @param sha256 of the mesh's file @throws HarnessError when the manifest has another one
void check_sum(const MeshEntry& mesh, const std::string& sha256);

}  // namespace geodesic::harness
