#include "harness/corpus/manifest.h"

#include <algorithm>
#include <cstdlib>
#include <set>

#include "harness/base/atomic_file.h"
#include "harness/base/error.h"
#include "harness/base/folders.h"
#include "harness/corpus/names.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

ParameterValue parse_value(const Json& value) {
  if (value.is_number()) return value.get<double>();
  return value.get<std::string>();
}

std::optional<Recipe> parse_recipe(const Json& mesh) {
  if (!mesh.contains("generator") || mesh.contains("inputs")) return std::nullopt;
  Recipe recipe{.generator = mesh["generator"].get<std::string>(), .parameters = {}};
  const Json parameters = mesh.value("parameters", Json::object());
  for (const auto& [name, value] : parameters.items()) {
    recipe.parameters.emplace(name, parse_value(value));
  }
  return recipe;
}

std::string checked_name(const char* kind, const Json& name) {
  check_name(kind, name.get<std::string>());
  return name;
}

MeshEntry parse_mesh(const Json& mesh, const fs::path& cache) {
  MeshEntry entry{.name = checked_name("mesh", mesh.at("name")),
                  .file = cache / checked_name("mesh file", mesh.at("file")),
                  .kind = mesh.at("kind").get<std::string>()};
  if (mesh.contains("thesis_model") && !mesh["thesis_model"].is_null()) {
    entry.thesis_model = mesh["thesis_model"].get<std::string>();
  }
  entry.stand_in = mesh.value("stand_in", false);
  entry.recipe = parse_recipe(mesh);
  return entry;
}

}  // namespace

Manifest::Manifest(const fs::path& file, const fs::path& cache)
    : Manifest(read_json(file, "a manifest, such as " + default_manifest().string()), file.string(),
               cache) {}

Manifest::Manifest(const Json& json, const std::string& name, const fs::path& cache) {
  std::string place = "not a manifest of meshes: ";
  try {
    const Json& meshes = json.at("meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      place = "meshes[" + std::to_string(i) + "]: ";
      meshes_.push_back(parse_mesh(meshes.at(i), cache));
    }
    check_names();
    place = "corpora: ";
    json.at("corpora").get_to(corpora_);
    for (const auto& [corpus, members] : corpora_) {
      place = "corpora/" + excerpt(corpus) + ": ";
      check_name("corpus", corpus);
      for (const std::string& member : members) mesh(member);
    }
  } catch (const Json::exception& error) {
    throw HarnessError(name + ": " + place + reason_of(error));
  } catch (const HarnessError& error) {
    throw HarnessError(name + ": " + place + error.what());
  }
}

void Manifest::check_names() const {
  std::set<std::string> names;
  for (const MeshEntry& mesh : meshes_) {
    if (!names.insert(mesh.name).second) {
      throw HarnessError("two meshes are named '" + mesh.name + "': rename one");
    }
  }
}

const MeshEntry& Manifest::mesh(std::string_view name) const {
  const auto at = std::find_if(meshes_.begin(), meshes_.end(),
                               [&](const MeshEntry& entry) { return entry.name == name; });
  if (at != meshes_.end()) return *at;
  std::vector<std::string> known;
  for (const MeshEntry& entry : meshes_) known.push_back(entry.name);
  throw HarnessError(unknown_name("mesh", name, known));
}

std::vector<MeshEntry> Manifest::corpus(const std::string& name) const {
  const auto at = corpora_.find(name);
  if (at == corpora_.end()) {
    std::vector<std::string> known;
    for (const auto& [other, members] : corpora_) known.push_back(other);
    throw HarnessError(unknown_name("corpus", name, known));
  }
  std::vector<MeshEntry> members;
  for (const std::string& member : at->second) members.push_back(mesh(member));
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
  if (fs::exists(status)) throw HarnessError("'" + file_or_name + "' is no regular file");
  if (file_or_name.find('/') != std::string::npos) {
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
