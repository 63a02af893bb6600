// A suite: solvers x meshes x sources x repetitions, as a file and as flags.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "harness/corpus/outcome.h"

namespace geodesic::harness {

struct Suite {
  /// As of solvers_named (corpus/solvers.h); empty: all but Description::by_name_only.
  std::vector<std::string> solvers = {};
  std::string corpus = "quick";          ///< a corpus of the manifest; of `meshes` any name
  std::vector<std::string> meshes = {};  ///< names or files, in place of the whole corpus
  int sources = 3;                       ///< single ones, a mesh
  /// As of name_of_source_set (corpus/sources.h): each is a further source of each mesh that has
  /// it.
  std::vector<std::string> source_sets = {};
  int repetitions = 3;     ///< timed, a cell
  std::uint64_t seed = 1;  ///< of the choice of sources
  int other_queries = 0;   ///< from other sources, after which a cell solves again
  int path_targets = 0;    ///< to which paths are measured, of solvers that have paths
  double min_time = 0.05;  ///< seconds, minimum of a repetition
  /// Solver to verify by, or "brute force" where a closed form is not known; by default a solver of
  /// another kind.
  std::optional<std::string> reference = {};
  std::string vectors = "auto";  ///< instruction set (corpus/solvers.h)
  double time_limit = 3600;      ///< seconds for the process of a cell
  /// Bytes for that process; by default what the machine has available.
  std::optional<std::uint64_t> memory_limit = {};
  /// By "solver/mesh": an outcome that is not a failure there.
  std::map<std::string, Outcome> expected = {};
};

/// Reads a suite; keys that the file leaves out keep the values above.
/// @throws HarnessError for what harness/suite.schema.json does not have, such as an unknown key
///         (listing the known ones), and for a value out of range
Suite read_suite(const std::filesystem::path& file);

/// As `read_suite` on a file's content.
/// @param name what messages call the file
Suite parse_suite(const Json& json, const std::string& name);

/// @throws HarnessError naming the first value out of range
void check_suite(const Suite& suite);

/// harness/suites/default.json of the data folder (folders.h).
std::filesystem::path default_suite();

/// The suite of that name in harness/suites, or else the default one.
Suite suite_of_corpus(const std::string& corpus);

// All keys, as a suite that read_suite takes; null where there is no value.
GEODESIC_JSON_MEMBERS(Suite, solvers, corpus, meshes, sources, source_sets, repetitions, seed,
                      other_queries, path_targets, min_time, vectors, time_limit, expected,
                      reference, memory_limit)

}  // namespace geodesic::harness
