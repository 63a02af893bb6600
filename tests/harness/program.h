// Runs geodesic-bench as a user would.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/harness/temporary_folder.h"

namespace geodesic::harness {

struct Output {
  int code;
  std::string out;
  std::string err;
};

/// A test with two tiny meshes in a manifest of its own: "hill" (open terrain, one isolated vertex)
/// and "tetrahedron"; "absent" is in the manifest and not in the cache.
class ProgramTest : public TemporaryFolder {
 protected:
  ProgramTest();

  /// @param arguments the manifest is added to them
  Output run(const std::string& program, std::vector<std::string> arguments) const;
  /// As `run`, for arguments that take no manifest.
  Output run_plainly(const std::string& program, const std::vector<std::string>& arguments) const;

  /// Any exact solver of the program without a limit of size.
  std::string exact_solver() const;
  nlohmann::json read_json(const std::filesystem::path& file) const;

  std::filesystem::path manifest_;
};

}  // namespace geodesic::harness
