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
  /// Words for solvers_named (corpus/solvers.h); empty: all but Description::by_name_only.
  std::vector<std::string> solvers = {};
  std::string corpus = "quick";          ///< a corpus of the manifest, or any name for `meshes`
  std::vector<std::string> meshes = {};  ///< names or files, in place of the whole corpus
  int sources = 3;                       ///< number of single sources of a mesh
  /// Words for name_of_source_set (corpus/sources.h). Each set is a further source of the meshes
  /// that have it.
  std::vector<std::string> source_sets = {};
  int repetitions = 3;      ///< timed repetitions of a cell
  std::uint64_t seed = 1;   ///< for the choice of sources
  int other_queries = 0;    ///< queries from other sources before a cell solves again
  int path_targets = 0;     ///< number of targets of measured paths, if the solver has paths
  int further_sources = 0;  ///< random sources, one after the other, after the mesh's first one
  double min_time = 0.05;   ///< minimum of a repetition in seconds
  /// Solver to verify by, or "brute force" where a closed form is not known; by default a solver of
  /// another kind.
  std::optional<std::string> reference = {};
  std::string vectors = "auto";  ///< instruction set (corpus/solvers.h)
  double time_limit = 3600;      ///< seconds for the process of a cell
  /// Memory limit of that process in bytes; by default what the machine has available.
  std::optional<std::uint64_t> memory_limit = {};
  /// By "solver/mesh": an outcome that is not a failure for this solver and mesh.
  std::map<std::string, Outcome> expected = {};
};

/// Reads a suite. Keys that the file leaves out keep the values above.
/// @throws HarnessError for anything against harness/suite.schema.json, such as an unknown key (the
///         message lists the known ones), and for a value out of range
Suite read_suite(const std::filesystem::path& file);

/// Like `read_suite`, for the content of a file.
/// @param name the file in messages
Suite parse_suite(const Json& json, const std::string& name);

/// @throws HarnessError that names the first value out of range
void check_suite(const Suite& suite);

/// harness/suites/default.json of the data folder (base/files.h).
std::filesystem::path default_suite();

/// The suite with that name in harness/suites, or else the default one.
Suite suite_of_corpus(const std::string& corpus);

// All keys, as a suite that read_suite can read; null for an empty value.
GEODESIC_JSON_MEMBERS(Suite, solvers, corpus, meshes, sources, source_sets, repetitions, seed,
                      other_queries, path_targets, further_sources, min_time, vectors, time_limit,
                      expected, reference, memory_limit)

}  // namespace geodesic::harness
