// The smallest case on which a property fails, as a mesh in a file and a command.
#pragma once

#include <filesystem>

#include "harness/verify/isolated_check.h"

namespace geodesic::harness {

/// What failed, and on what.
struct FailedProperty {
  const Property* property;
  std::string name;  ///< of the property, with the mesh if it is a user's
  bool own;          ///< whether the case is one of the property's own
  Case given;
  CheckResult result;
};

struct Reproduction {
  Case given;
  std::filesystem::path file;        ///< empty for a mesh without faces, which no file holds
  std::vector<std::string> command;  ///< arguments of this program that make it fail again
  bool repeated = false;             ///< whether they did, with the mesh as it was read back
  CheckResult result;                ///< of the smallest case, explained
};

/// Shrinks the case, writes it, and checks whether it still fails when it is read back. A case of a
/// property that holds on its own meshes only is written as it is.
/// @param file to write; its folder is made
/// @param seconds to spend on making it smaller
/// @throws HarnessError when the file cannot be written
Reproduction save_smallest(const IsolatedCheck& check, const FailedProperty& failed,
                           const std::filesystem::path& file, double seconds);

}  // namespace geodesic::harness
