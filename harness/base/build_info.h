// What this program was built from and how. The .cpp is written at every build (build_info.cmake),
// so that it is right after a commit too.
#pragma once

#include <optional>
#include <string>

namespace geodesic::harness {

struct BuildInfo {
  std::string version;           ///< of the project: "0.1.0"
  std::string revision;          ///< git hash, "unknown" outside a git checkout
  std::optional<bool> modified;  ///< files differ from that revision; empty when unknown
  std::string compiler;          ///< "GNU 12.2.0"
  std::string compiler_flags;
  std::string build_type;
  std::string source_folder;   ///< the checkout that was built
  std::string installed_data;  ///< as seen from the folder that the program is installed into
};

const BuildInfo& build_info();

}  // namespace geodesic::harness
