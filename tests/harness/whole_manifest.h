// Completes the manifests of tests, which name only the keys that matter to the test.
#pragma once

#include <string>

#include "harness/base/json.h"

namespace geodesic::harness {

/// The manifest `text` with every required key. Missing keys get an arbitrary valid value.
inline std::string whole_manifest(const std::string& text) {
  using nlohmann::json;
  const std::string sha256(64, '0');
  const json common{{"sha256", sha256},
                    {"vertices", 1},
                    {"faces", 1},
                    {"genus", 0},
                    {"boundary_loops", 0},
                    {"components", 1},
                    {"tags", json::array()},
                    {"licence", "-"},
                    {"credit", "-"},
                    {"why", "-"}};
  const json by_kind{{"generated", {{"generator", "grid"}, {"parameters", json::object()}}},
                     {"downloaded", {{"path", "site/file"}, {"upstream_sha256", sha256}}}};
  json whole = json::parse(R"({"schema_version": 1, "elevation_grids": [],
      "sources": {"site": {"base": "https://x/", "homepage": "-", "revision": "-"}}})");
  whole.update(json::parse(text));
  for (json& mesh : whole["meshes"]) {
    json complete = common;
    complete.update(by_kind.value(mesh.value("kind", ""), json::object()));
    complete.update(mesh);
    mesh = complete;
  }
  return whole.dump();
}

}  // namespace geodesic::harness
