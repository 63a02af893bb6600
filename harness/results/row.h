// Rows of result files, and the files of single cells.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "harness/results/outcome.h"
#include "solvers/core/geometry.h"

namespace geodesic::harness {

/// "<solver>/<mesh>/src:<vertex>", the name of a row
std::string row_name(const std::string& solver, const std::string& mesh, Index source);

/// The row of a cell that has no time, in the shape that Google Benchmark gives a failed one: times
/// and iterations are 0 and mean nothing.
/// @param why becomes one line
Json error_row(const std::string& solver, const std::string& mesh, Index source,
               const char* outcome, std::string why);

/// Writes {"context": {..., "geodesic_bench": context}, "benchmarks": rows}, whole or not at all.
/// The finishing time and the file's own checksum are added here.
/// @param more keys beside these two
void write_result_file(const std::filesystem::path& file, Json benchmark_context, Json context,
                       const std::vector<Json>& rows, const Json& more = Json::object());

/// Whether a result file is as it was written: context.geodesic_bench.checksum is the SHA-256 of
/// the file without that key, as compact JSON.
bool is_intact(Json result_file);

}  // namespace geodesic::harness
