// What a manifest may contain. datasets/manifest.schema.json states the same for editors, and
// tests/datasets/test_manifest.py holds the two against each other.
#include <algorithm>
#include <functional>
#include <set>

#include "harness/base/error.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/names.h"

namespace geodesic::harness {
namespace {

using Rule = std::function<void(const Json& value)>;

struct Key {
  std::string name;
  Rule rule;
  bool required = true;
};

// Puts the place in front of the action's errors: "mesh horse: sha256: ...".
template <class Action>
void at_place(const std::string& place, const Action& action) {
  try {
    action();
  } catch (const HarnessError& error) {
    throw HarnessError(excerpt(place) + ": " + error.what());
  }
}

void must_be(bool holds, const std::string& what, const Json& value) {
  if (!holds) throw HarnessError("must be " + what + ", not " + shown(value));
}

const std::string& text_of(const Json& value) {
  must_be(value.is_string() && value != "", "text", value);
  const std::string& text = value.get_ref<const std::string&>();
  must_be(harmless(text) == text, "text without control characters", value);
  return text;
}

void is_text(const Json& value) { text_of(value); }

void is_count(const Json& value) {
  must_be(value.is_number_unsigned(), "an integer of at least 0", value);
}

void is_count_or_null(const Json& value) {
  if (!value.is_null()) is_count(value);
}

void is_flag(const Json& value) { must_be(value.is_boolean(), "true or false", value); }

void is_sha256(const Json& value) {
  const std::string& text = text_of(value);
  const bool fits = text.size() == 64 && text.find_first_not_of("0123456789abcdef") == text.npos;
  must_be(fits, "64 hexadecimal digits in lower case", value);
}

void is_name(const Json& value) { check_name("name", text_of(value)); }

Rule one_of(std::vector<std::string> words) {
  return [words](const Json& value) {
    const bool known = value.is_string() && std::ranges::find(words, text_of(value)) != words.end();
    must_be(known, "one of " + join(words), value);
  };
}

// The name of a file, without folders.
Rule file_with(std::vector<std::string> endings) {
  return [endings](const Json& value) {
    const std::string& name = text_of(value);
    check_name("file name", name);
    const bool fits = std::ranges::any_of(
        endings, [&](const std::string& ending) { return name.ends_with(ending); });
    must_be(fits, "a name that ends in " + join(endings), value);
  };
}

void check_parts(std::string_view path) {
  for (std::size_t slash; (slash = path.find('/')) != path.npos; path.remove_prefix(slash + 1)) {
    check_name("name in a path", path.substr(0, slash));
  }
  check_name("name in a path", path);
}

void is_path(const Json& value) {
  const std::string& path = text_of(value);
  must_be(path.find('/') != path.npos, "a path that begins with the name of a source", value);
  check_parts(path);
}

void is_base(const Json& value) {
  const std::string& text = text_of(value);
  const bool fits = text.starts_with("https://") && text.ends_with('/');
  must_be(fits, "an https:// address that ends in '/'", value);
}

// npm takes a slash without a scope for a repository.
void is_package_name(const Json& value) {
  const std::string& name = text_of(value);
  const bool has_scope = name[0] == '@';
  must_be(std::ranges::count(name, '/') == (has_scope ? 1 : 0), "'name' or '@scope/name'", value);
  check_parts(std::string_view(name).substr(has_scope ? 1 : 0));
}

void is_version(const Json& value) {
  std::string text = text_of(value);
  std::ranges::replace(text, '+', '.');
  check_name("version", text);
  must_be(text[0] >= '0' && text[0] <= '9', "a version such as 1.2.3", value);
}

// An object with these keys only.
Rule object_of(std::vector<Key> keys) {
  return [keys](const Json& object) {
    must_be(object.is_object(), "an object", object);
    for (const auto& [name, value] : object.items()) {
      if (std::ranges::find(keys, name, &Key::name) != keys.end()) continue;
      std::vector<std::string> known;
      for (const Key& key : keys) known.push_back(key.name);
      throw HarnessError(unknown_name("key", name, known));
    }
    for (const Key& key : keys) {
      if (object.contains(key.name)) {
        at_place(key.name, [&] { key.rule(object[key.name]); });
      } else if (key.required) {
        throw HarnessError("key '" + key.name + "' is missing");
      }
    }
  };
}

// An object whose keys are names of the manifest's own choice.
Rule by_name(const Rule& rule) {
  return [rule](const Json& object) {
    must_be(object.is_object(), "an object", object);
    for (const auto& [name, value] : object.items()) {
      check_name("name", name);
      at_place(name, [&, &each = value] { rule(each); });
    }
  };
}

// What one of the other rules holds for, and not empty.
Rule filled(const Rule& rule) {
  return [rule](const Json& value) {
    rule(value);
    if (value.empty()) throw HarnessError("must not be empty");
  };
}

Rule list_of(const Rule& rule) {
  return [rule](const Json& list) {
    must_be(list.is_array(), "a list", list);
    for (const Json& value : list) rule(value);
  };
}

void is_address(const Json& value) {
  must_be(text_of(value).starts_with("https://"), "an https:// address", value);
}

void is_list_of_names(const Json& list) {
  must_be(list.is_array(), "a list", list);
  std::set<std::string> seen;
  for (const Json& value : list) {
    is_name(value);
    if (!seen.insert(value).second) throw HarnessError(shown(value) + " is listed twice");
  }
}

void is_source(const Json& source) {
  object_of({{"base", is_base}, {"homepage", is_text}, {"revision", is_text}})(source);
}

void is_package(const Json& package) {
  std::vector<Key> keys{
      {"manager", one_of({"npm", "python"})}, {"name", is_package_name}, {"file", is_text}};
  // Of a Python package, the installed version is used.
  if (!package.is_object() || package.value("manager", Json()) != "python") {
    keys.push_back({"version", is_version});
  }
  object_of(keys)(package);
}

void is_parameter(const Json& value) {
  if (!value.is_number()) is_text(value);
}

// What meshes and elevation grids have in common, what their kind adds, and `keys`.
void check_entry(const Json& entry, const std::vector<std::string>& kinds, std::vector<Key> keys) {
  must_be(entry.is_object(), "an object", entry);
  const Json kind = entry.value("kind", Json());
  at_place("kind", [&] { one_of(kinds)(kind); });
  const bool of_others = kind != "generated" || entry.contains("inputs");
  keys.insert(keys.end(), {{"name", is_name},
                           {"kind", is_text},
                           {"sha256", is_sha256},
                           {"why", is_text},
                           {"licence", is_text, of_others},
                           {"credit", is_text, of_others}});
  if (kind == "generated") {
    keys.insert(keys.end(), {{"generator", is_name},
                             {"parameters", by_name(is_parameter)},
                             {"inputs", filled(by_name(is_name)), false}});
  } else {
    keys.push_back(kind == "package" ? Key{"package", is_package} : Key{"path", is_path});
    keys.insert(keys.end(), {{"upstream_sha256", is_sha256}, {"archive_member", is_text, false}});
  }
  object_of(keys)(entry);
}

void is_mesh(const Json& entry) {
  const bool has_model =
      entry.is_object() && (entry.contains("thesis_model") || entry.contains("stand_in"));
  check_entry(entry, {"generated", "downloaded", "package"},
              {{"file", file_with({".obj", ".off", ".ply", ".stl"})},
               {"vertices", is_count},
               {"faces", is_count},
               {"genus", is_count_or_null},
               {"boundary_loops", is_count},
               {"components", is_count},
               {"tags", is_list_of_names},
               {"sources", filled(list_of(is_count)), false},
               {"reports", filled(list_of(is_address)), false},
               {"thesis_model",
                one_of({"knot", "horse", "bunny", "hand", "rocker arm", "lucy", "asian dragon",
                        "cervino terrain"}),
                has_model},
               {"stand_in", is_flag, has_model}});
  for (const Json& source : entry.value("sources", Json::array())) {
    const bool exists = source < entry["vertices"];
    at_place("sources", [&] { must_be(exists, "vertices of the mesh", source); });
  }
}

void is_elevation_grid(const Json& entry) {
  check_entry(entry, {"downloaded", "package"}, {{"file", file_with({".npy"})}});
}

// The place of an entry is its name, where it has one.
Rule entries(const Rule& rule) {
  return [rule](const Json& list) {
    must_be(list.is_array(), "a list", list);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Json name = list[i].is_object() ? list[i].value("name", Json()) : Json();
      at_place(name.is_string() ? name.get<std::string>() : std::to_string(i),
               [&] { rule(list[i]); });
    }
  };
}

// What an entry names: its source, and meshes or elevation grids before it.
void check_references(const Json& entry, const Json& sources, const std::set<std::string>& known) {
  if (entry.contains("path")) {
    const std::string path = entry["path"];
    const std::string source = path.substr(0, path.find('/'));
    if (!sources.contains(source)) throw HarnessError("path: there is no source '" + source + "'");
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

}  // namespace

void check_manifest(const Json& manifest) {
  object_of({{"$schema", is_text, false},
             {"schema_version", [](const Json& value) { must_be(value == 1, "1", value); }},
             {"sources", by_name(is_source)},
             {"corpora", by_name(filled(is_list_of_names))},
             {"meshes", entries(is_mesh)},
             {"elevation_grids", entries(is_elevation_grid)}})(manifest);
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

}  // namespace geodesic::harness
