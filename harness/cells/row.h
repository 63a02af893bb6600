// Rows of result files, and the files of single cells.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/json.h"
#include "solvers/core/geometry.h"

namespace geodesic::harness {

namespace outcome {
inline constexpr const char* kOk = "ok";
inline constexpr const char* kWrongAnswer = "wrong answer";
inline constexpr const char* kUnsupported = "unsupported";
inline constexpr const char* kCrashed = "crashed";
inline constexpr const char* kError = "error";
}  // namespace outcome

/// "<solver>/<mesh>/src:<vertex>", the name of a row
std::string row_name(const std::string& solver, const std::string& mesh, Index source);

/// The row of a cell that has no time, in the shape that Google Benchmark gives a failed one: times
/// and iterations are 0 and mean nothing.
/// @param why becomes one line
Json error_row(const std::string& solver, const std::string& mesh, Index source,
               const char* outcome, std::string why);

/// Writes {"context": {..., "geodesic_bench": context}, "benchmarks": rows}, whole or not at all.
/// The finishing time is added here.
/// @param more keys beside these two
void write_result_file(const std::filesystem::path& file, Json benchmark_context, Json context,
                       const std::vector<Json>& rows, const Json& more = Json::object());

}  // namespace geodesic::harness
