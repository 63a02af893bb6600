// The sources and options of this build. build_info.cmake writes the .cpp file at every build, so
// that it is also correct after a commit.
#pragma once

#include <optional>
#include <string>

namespace geodesic::harness {

struct BuildInfo {
  std::string version;           ///< version of the project: "0.1.0"
  std::string revision;          ///< git hash, "unknown" outside a git checkout
  std::optional<bool> modified;  ///< whether files differ from that revision; empty when unknown
  std::string compiler;          ///< "GNU 12.2.0"
  std::string compiler_flags;
  std::string build_type;
  std::string libraries;       ///< "benchmark 1.7.1, CGAL 5.5.1"
  std::string source_folder;   ///< the checkout that was built
  std::string installed_data;  ///< relative to the folder of the installed program
};

const BuildInfo& build_info();

}  // namespace geodesic::harness
