#include "harness/corpus/manifest.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "harness/base/error.h"
#include "harness/base/files.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

std::optional<Recipe> recipe_of(const Json& mesh) {
  if (!mesh.contains("generator") || mesh.contains("inputs")) return std::nullopt;
  Recipe recipe{.generator = mesh["generator"], .parameters = {}};
  for (const auto& [name, value] : mesh["parameters"].items()) {
    recipe.parameters.emplace(
        name, value.is_number() ? ParameterValue(value.get<double>()) : value.get<std::string>());
  }
  return recipe;
}

MeshEntry entry_of(const Json& mesh, const fs::path& cache) {
  MeshEntry entry{.name = mesh["name"],
                  .file = cache / mesh["file"].get<std::string>(),
                  .kind = mesh["kind"],
                  .vertices = mesh["vertices"],
                  .faces = mesh["faces"],
                  .stand_in = mesh.value("stand_in", false),
                  .recipe = recipe_of(mesh),
                  .why = mesh["why"],
                  .sources = mesh.value("sources", std::vector<Index>()),
                  .reports = mesh.value("reports", std::vector<std::string>())};
  if (mesh.contains("thesis_model")) entry.thesis_model = mesh["thesis_model"];
  return entry;
}

}  // namespace

Manifest::Manifest(const fs::path& file, const fs::path& cache)
    : Manifest(read_json(file, "a manifest, such as " + default_manifest().string()), file.string(),
               cache) {}

Manifest::Manifest(Json json, const std::string& name, const fs::path& cache)
    : json_(std::move(json)) {
  try {
    check_manifest(json_);
  } catch (const HarnessError& error) {
    throw HarnessError(name + ": " + error.what());
  }
  for (const Json& mesh : json_["meshes"]) meshes_.push_back(entry_of(mesh, cache));
  json_["corpora"].get_to(corpora_);
}

const MeshEntry& Manifest::mesh(std::string_view name) const {
  return named("mesh", meshes_, name, &MeshEntry::name);
}

std::vector<MeshEntry> Manifest::corpus(const std::string& name) const {
  std::vector<MeshEntry> members;
  for (const std::string& member :
       named("corpus", corpora_, name, &Corpora::value_type::first).second) {
    members.push_back(mesh(member));
  }
  return members;
}

fs::path default_manifest() { return data_folder() / "datasets" / "manifest.json"; }

fs::path dataset_cache() {
  const char* folder = std::getenv("GEODESIC_DATASETS");
  if (folder != nullptr && *folder != '\0') return folder;
  return data_folder() / "datasets" / "cache";
}

MeshEntry find_mesh(const std::string& file_or_name, const fs::path& manifest) {
  const fs::path file = file_or_name;
  std::error_code unknown;
  const fs::file_status status = fs::status(file, unknown);
  if (fs::is_regular_file(status)) {
    return {.name = harmless(file.stem().string()), .file = file, .kind = "file"};
  }
  if (fs::exists(status)) throw HarnessError("'" + file_or_name + "' is not a regular file");
  const std::string extension = file.extension().string();
  const bool is_path = file_or_name.find('/') != std::string::npos || extension == ".obj" ||
                       extension == ".off" || extension == ".ply" || extension == ".stl";
  if (is_path) {
    throw HarnessError("there is no file '" + file_or_name +
                       "': " + (unknown ? unknown.message() : "check the path"));
  }
  const MeshEntry entry = Manifest(manifest, dataset_cache()).mesh(file_or_name);
  if (!entry.available()) throw HarnessError(how_to_get(entry));
  return entry;
}

std::string how_to_get(std::span<const MeshEntry> meshes) {
  const bool one = meshes.size() == 1;
  std::string quoted, words;
  for (const MeshEntry& mesh : meshes) {
    quoted += (quoted.empty() ? "'" : ", '") + mesh.name + "'";
    words += ' ' + mesh.name;
  }
  return (one ? "mesh " : "meshes ") + quoted + (one ? " is" : " are") +
         " not in the dataset cache (" + meshes.front().file.parent_path().string() + "): run " +
         (data_folder() / "datasets" / "fetch.py").string() + words;
}

std::string how_to_get(const MeshEntry& mesh) { return how_to_get({&mesh, 1}); }

}  // namespace geodesic::harness
