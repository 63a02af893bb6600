// Runs geodesic-bench as a user would.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/harness/expect_words.h"
#include "tests/harness/temporary_folder.h"

namespace geodesic::harness {

/// The program, and words that come before all others.
struct Program {
  Program(const char* its_file, std::vector<std::string> its_words = {})
      : file(its_file), words(std::move(its_words)) {}
  std::string file;
  std::vector<std::string> words;
};

/// With solvers that fail in every way that a run must survive (faulty_solvers.cpp), as a
/// plug-in.
inline const Program kFaultyProgram(PROGRAM, {"--plugin", FAULTY_SOLVERS});

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
  Output run(const Program& program, std::vector<std::string> arguments) const;
  /// As `run`, for arguments that take no manifest.
  Output run_plainly(const Program& program, const std::vector<std::string>& arguments) const;

  /// Any exact solver of the program without a limit of size.
  std::string exact_solver() const;
  nlohmann::json read_json(const std::filesystem::path& file) const;

  std::filesystem::path manifest_;
};

}  // namespace geodesic::harness
