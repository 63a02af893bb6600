// Runs geodesic-bench as a user would.
#pragma once

#include <string>
#include <vector>

#include "harness/base/json.h"
#include "tests/harness/expect_words.h"
#include "tests/harness/temporary_folder.h"

namespace geodesic::harness {

/// A program file and the words that come first on its command line.
struct Program {
  Program(const char* its_file, std::vector<std::string> its_words = {})
      : file(its_file), words(std::move(its_words)) {}
  std::string file;
  std::vector<std::string> words;
};

/// The program with a plug-in of solvers that fail in every way that a run must survive
/// (faulty_solvers.cpp).
inline const Program kFaultyProgram(PROGRAM, {"--plugin", FAULTY_SOLVERS});

struct Output {
  int code;
  std::string out;
  std::string err;
};

/// A test with its own manifest of two tiny meshes: "hill" (open terrain, one isolated vertex) and
/// "tetrahedron". A third mesh, "absent", is in the manifest but not in the cache.
class ProgramTest : public TemporaryFolder {
 protected:
  ProgramTest();

  /// @param arguments without the manifest, which is added
  Output run(const Program& program, std::vector<std::string> arguments) const;
  /// Same as `run`, for commands without a manifest.
  Output run_plainly(const Program& program, const std::vector<std::string>& arguments) const;

  /// The name of any exact solver of the program that has no limit of mesh size.
  std::string exact_solver() const;
  nlohmann::json read_json(const std::filesystem::path& file) const;

  std::filesystem::path manifest_;
};

}  // namespace geodesic::harness
