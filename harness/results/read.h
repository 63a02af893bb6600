// Result files as they are compared and exported: by cells.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "harness/base/json.h"

namespace geodesic::harness {

/// One solver on one mesh from one source: its repetitions, or the one row that says why it failed.
struct CellResult {
  std::string name;  ///< "<solver>/<mesh>/src:<vertex>"
  std::string solver;
  std::string mesh;
  std::string outcome;     ///< "ok", or what went wrong
  std::string message;     ///< one line, empty when it is ok
  std::vector<Json> rows;  ///< at least one

  bool ok() const;
  /// A number of every repetition; empty when the cell failed. "cpu_time" (ms, above 0) is in every
  /// row of a cell that is ok; it, integer_counters and "solver_peak_bytes" are known to be
  /// numbers.
  std::vector<double> values(const std::string& key) const;
};

/// Keys of the context without which times, or instructions, mean something else.
inline constexpr std::array kComparedKeys{"processor", "compiler", "compiler_flags", "build_type"};

struct ResultFile {
  std::filesystem::path file;
  Json context;  ///< Google Benchmark's keys, and ours in "geodesic_bench": texts at kComparedKeys
                 ///< and "corpus", and "meshes", each with a name and a sha256
  std::vector<CellResult> cells;

  const Json& ours() const { return context.at("geodesic_bench"); }
};

/// @param path a result file, or a run folder with run.json in it
/// @throws HarnessError when it cannot be read or is no result file of this program
ResultFile read_result_file(const std::filesystem::path& path);

/// As `read_result_file` on a file's content.
/// @param file what messages call it
ResultFile parse_result_file(const Json& json, const std::filesystem::path& file);

}  // namespace geodesic::harness
