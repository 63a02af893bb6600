// The smallest case on which a property fails, as a mesh in a file and a command.
#pragma once

#include <filesystem>

#include "harness/verify/examine.h"

namespace geodesic::conformance {

struct Smallest {
  Case given;
  std::filesystem::path file;        ///< empty for a mesh without faces, which no file holds
  std::vector<std::string> command;  ///< arguments of this program that make it fail again
  bool repeated = false;             ///< whether they did, with the mesh as it was read back
  Report report;                     ///< of the smallest case, explained
};

/// Shrinks a case, writes it, and sees whether it still fails when it is read back. A case of a
/// property that says something about its own meshes only is written as it is.
/// @param failed by this case
/// @param own whether the case is one of the property's own
/// @param file to write; its folder is made
/// @param seconds to spend on making it smaller
/// @throws HarnessError when the file cannot be written
Smallest save_smallest(const Examiner& examiner, const Property& property, const Case& given,
                       const Report& failed, bool own, const std::filesystem::path& file,
                       double seconds);

}  // namespace geodesic::conformance
