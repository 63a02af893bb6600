#include "harness/corpus/manifest.h"

#include <glob.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/schema.h"
#include "meshes/mesh_file.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

// Checks the names in an entry: its source, and meshes or elevation grids before the entry.
void check_references(const Json& entry, const Json& sources, const std::set<std::string>& known) {
  if (entry.contains("path")) {
    const std::string path = entry["path"];
    const std::string source = path.substr(0, path.find('/'));
    if (!sources.contains(source)) throw HarnessError("path: there is no source '" + source + "'");
  }
  for (const Json& source : entry.value("sources", Json::array())) {
    if (source < entry["vertices"]) continue;
    throw HarnessError("sources: must be vertices of the mesh, not " + shown(source));
  }
  const Json inputs = entry.value("inputs", Json::object());
  for (const auto& [parameter, input] : inputs.items()) {
    const std::string place = "inputs: " + parameter + ": ";
    if (!known.contains(input)) {
      throw HarnessError(place + "there is no mesh '" + input.get<std::string>() +
                         "' before this one");
    }
    if (entry["parameters"].contains(parameter)) {
      throw HarnessError(place + "is one of the parameters, too");
    }
  }
}

// Checks the schema, and what no schema can express: that names are known and are used once.
void check_manifest(const Json& manifest) {
  static const Json schema = read_json(data_folder() / "datasets" / "manifest.schema.json");
  check_schema(manifest, schema);
  std::set<std::string> known, meshes, files;
  for (const std::string list : {"elevation_grids", "meshes"}) {
    for (const Json& entry : manifest[list]) {
      at_place(list + ": " + entry["name"].get<std::string>(), [&] {
        check_references(entry, manifest["sources"], known);
        if (!known.insert(entry["name"]).second) throw HarnessError("the name is used twice");
        if (!files.insert(entry["file"]).second) throw HarnessError("the file is used twice");
      });
      if (list == "meshes") meshes.insert(entry["name"]);
    }
  }
  for (const auto& [corpus, members] : manifest["corpora"].items()) {
    for (const std::string member : members) {
      at_place("corpora: " + corpus, [&] { named("mesh", meshes, member); });
    }
  }
}

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
                  .sha256 = mesh["sha256"],
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

// @tparam Iterator iterates over the entries of a folder
template <class Iterator>
std::vector<fs::path> files_in(const fs::path& folder, fs::directory_options options = {}) {
  try {
    std::vector<fs::path> files;
    for (const auto& entry : Iterator(folder, options)) files.push_back(entry.path());
    return files;
  } catch (const fs::filesystem_error& error) {
    throw HarnessError("cannot read folder '" + folder.string() + "': " + error.code().message());
  }
}

// The mesh files among some files, at least one, sorted by name.
// @param where the searched place, for the message: "in folder 'scans'"
std::vector<std::string> mesh_files(std::vector<fs::path> files, const std::string& where) {
  std::erase_if(files, [](const fs::path& file) {
    std::error_code unreadable;
    return !has_mesh_extension(file) || !fs::is_regular_file(file, unreadable);
  });
  if (files.empty()) throw HarnessError("no mesh file " + where + ": .obj, .off, .ply or .stl");
  for (const fs::path& file : files) {
    if (harmless(file.string()) == file.string()) continue;
    throw HarnessError(harmless(file.string()) +
                       ": the name has a control character, or bytes that are not UTF-8, which no "
                       "result file can hold: rename it");
  }
  std::ranges::sort(files);
  return {files.begin(), files.end()};
}

std::vector<fs::path> matches_of(const std::string& pattern) {
  glob_t found{};
  glob(pattern.c_str(), 0, nullptr, &found);
  std::vector<fs::path> files(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return files;
}

std::string fetch_script() { return (data_folder() / "datasets" / "fetch.py").string(); }

}  // namespace

Manifest::Manifest(const fs::path& file, const fs::path& cache)
    : Manifest(read_json(file, "a manifest, such as " + default_manifest().string()), file.string(),
               cache) {}

Manifest::Manifest(Json json, const std::string& name, const fs::path& cache)
    : json_(std::move(json)) {
  at_place(name, [&] { check_manifest(json_); });
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

std::vector<std::string> expand_meshes(const std::vector<std::string>& words) {
  std::vector<std::string> meshes;
  for (const std::string& word : words) {
    std::error_code unknown;
    const fs::file_status status = fs::status(word, unknown);
    const bool is_pattern = !fs::exists(status) && word.find_first_of("*?[") != std::string::npos;
    if (!is_pattern && !fs::is_directory(status)) {
      meshes.push_back(word);
      continue;
    }
    const std::vector<std::string> files =
        is_pattern ? mesh_files(matches_of(word), "matches '" + word + "'")
                   : mesh_files(files_in<fs::directory_iterator>(word), "in folder '" + word + "'");
    meshes.insert(meshes.end(), files.begin(), files.end());
  }
  return meshes;
}

std::vector<std::string> mesh_files_below(const fs::path& folder) {
  return mesh_files(files_in<fs::recursive_directory_iterator>(
                        folder, fs::directory_options::skip_permission_denied),
                    "in folder '" + folder.string() + "' or below it");
}

std::vector<std::string> names_below(const fs::path& folder,
                                     const std::vector<std::string>& files) {
  const auto name = [&](const std::string& file, bool with_extension) {
    fs::path relative = fs::path(file).lexically_relative(folder);
    if (!with_extension) relative.replace_extension();
    std::string words = relative.generic_string();
    std::ranges::replace(words, '/', '.');
    return words;
  };
  std::map<std::string, int> count;
  for (const std::string& file : files) ++count[name(file, false)];
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const std::string& file : files) names.push_back(name(file, count[name(file, false)] > 1));
  return names;
}

MeshEntry find_mesh(const std::string& file_or_name, const fs::path& manifest) {
  const fs::path file = file_or_name;
  std::error_code unknown;
  const fs::file_status status = fs::status(file, unknown);
  if (fs::is_regular_file(status)) {
    return {.name = harmless(file.stem().string()), .file = file, .kind = "file"};
  }
  if (fs::exists(status)) throw HarnessError("'" + file_or_name + "' is not a regular file");
  const auto cannot_open = [&] {
    const std::string why = unknown ? unknown.message() : "no such file";
    return HarnessError("cannot open '" + file_or_name + "': " + why);
  };
  if (file_or_name.find('/') != std::string::npos || has_mesh_extension(file)) throw cannot_open();
  const Manifest known(manifest, dataset_cache());
  const bool is_known =
      std::ranges::find(known.meshes(), file_or_name, &MeshEntry::name) != known.meshes().end();
  if (!is_known && file.has_extension()) throw cannot_open();
  MeshEntry entry = known.mesh(file_or_name);
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
         fetch_script() + words;
}

std::string how_to_get(const MeshEntry& mesh) { return how_to_get({&mesh, 1}); }

void check_sum(const MeshEntry& mesh, const std::string& sha256) {
  const bool is_known = mesh.sha256.find_first_not_of('0') != std::string::npos;
  if (!is_known || mesh.sha256 == sha256) return;
  throw HarnessError("mesh '" + mesh.name + "': " + mesh.file.string() + " has SHA-256 " + sha256 +
                     ", the manifest says " + mesh.sha256 + ": get its file with " +
                     fetch_script() + " " + mesh.name + ", or measure this one by its path");
}

}  // namespace geodesic::harness
