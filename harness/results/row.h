// Rows of result files: run.json and the files of single cells (results/README.md,
// run.schema.json).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/base/json.h"
#include "harness/corpus/outcome.h"
#include "harness/results/counters.h"

namespace geodesic {
GEODESIC_JSON_MEMBERS(Certificate, sources, mean_error, largest_error)
}

namespace geodesic::harness {

/// Wall time of the phases of a solve, in seconds; timer_overhead is in none of the others.
struct PhaseSeconds {
  double propagation = 0, trimming = 0, queue = 0, timer_overhead = 0;
};

GEODESIC_JSON_MEMBERS(PhaseSeconds, propagation, trimming, queue, timer_overhead)

/// Measurements of paths from the source to some targets. Times are in milliseconds, of the kind of
/// Row::solve_time, without preparation.
struct PathNumbers {
  std::size_t targets = 0;
  double alone_time = 0;    ///< mean of a query for one target, which stops there, and its path
  double first_time = 0;    ///< a solve for all vertices that remembers paths, and one path
  double further_time = 0;  ///< mean of each path after that
  /// Relative excess over the exact distance: maximum and mean over the paths that lead over the
  /// surface to their targets.
  double max_excess = 0, mean_excess = 0;
  std::size_t shortest = 0;     ///< number of these paths with an excess of at most 1e-9
  std::size_t off_surface = 0;  ///< number of paths with a piece that lies on no face
  std::size_t failed = 0;       ///< paths that the solver gave up, or that lead elsewhere
};

GEODESIC_JSON_MEMBERS(PathNumbers, targets, alone_time, first_time, further_time, max_excess,
                      mean_excess, shortest, off_surface, failed)

/// Mean times of a solve by one object from many sources, one after the other, in milliseconds, of
/// the kind of Row::solve_time, renewal included.
struct FurtherTimes {
  std::size_t sources = 0;
  double time = 0;       ///< of a solve for all vertices
  double pair_time = 0;  ///< of a solve that stops at one random vertex
};

GEODESIC_JSON_MEMBERS(FurtherTimes, sources, time, pair_time)

/// Errors of these solves: of all vertices, and of the vertex that a solve stops at. Means over the
/// sources of RelativeErrors::mean, and the largest error.
struct FurtherErrors {
  double mean = 0, max = 0, pair_mean = 0, pair_max = 0;
  std::string reference;  ///< the exact solver
};

GEODESIC_JSON_MEMBERS(FurtherErrors, mean, max, pair_mean, pair_max, reference)

/// One timed repetition of a cell, or the reason why the cell has none.
struct Row {
  std::string solver, mesh;
  std::string source = "0";                   ///< name of a SourceSet (corpus/sources.h)
  std::optional<std::string> program = {};    ///< name of the program, if a run has several
  std::optional<std::string> processor = {};  ///< of this row; in files, if not the context's
  int repetitions = 1, repetition_index = 0;
  int family_index = 0;  ///< index of the cell in its file
  int threads = 1;       ///< number of threads of the solver

  Outcome outcome = Outcome::ok;
  std::string error_message = {};  ///< one line; empty if the outcome is ok

  std::int64_t iterations = 0;         ///< solves in this repetition
  double real_time = 0, cpu_time = 0;  ///< of one solve, in milliseconds
  /// Disturbance (base/process.h) of the process that measured the row.
  std::optional<double> stolen_share = {}, involuntary_switches_per_s = {};
  std::optional<std::string> instruction_set = {};
  std::optional<std::string> timed = {};  ///< ExternalSolver::Times::of, if external
  /// CPU time in milliseconds; with several threads, wall time.
  std::optional<double> prepare_time = {}, renew_time = {}, mesh_time = {};
  std::optional<Certificate> certificate = {};  ///< Solver::certificate

  Counters counters = {};
  std::optional<PhaseSeconds> phase_seconds = {};
  std::optional<PathNumbers> paths = {};
  std::optional<FurtherTimes> further = {};
  std::optional<FurtherErrors> further_errors = {};  ///< of solvers that are not exact
  std::optional<std::int64_t> solver_peak_bytes = {}, process_peak_bytes = {};
  std::optional<std::uint64_t> unreachable_vertices = {};
  std::optional<std::string> recordings = {}, recordings_error = {};
  /// RelativeErrors (verify/distance_check.h).
  std::optional<double> max_relative_error = {}, mean_relative_error = {}, rms_relative_error = {},
                        p99_relative_error = {};
  std::optional<std::uint64_t> unreachable_mismatches = {};
  std::optional<std::string> reference = {};

  /// "<solver>/<mesh>/src:<source>"
  std::string name() const;
  bool ok() const { return outcome == Outcome::ok; }
  /// The published time: CPU time, or wall time if several threads share the work.
  double solve_time() const { return threads > 1 ? real_time : cpu_time; }
};

/// @see Row::name
std::string row_name(const std::string& solver, const std::string& mesh, const std::string& source);

/// A source in JSON: a number for a vertex, a name for a set.
Json source_in_json(const std::string& name);

/// Writes a row in the format of Google Benchmark. Empty members are left out.
void to_json(Json& json, const Row& row);
/// @throws Json::exception, HarnessError when the row does not fit results/run.schema.json
void from_json(const Json& json, Row& row);

/// Writes {"context": {..., "geodesic_bench": context}, "benchmarks": rows} completely or not at
/// all, with the present time as `finished` and a checksum.
/// @param benchmark_context Google Benchmark's own keys
void write_result_file(const std::filesystem::path& file, Json benchmark_context, Json context,
                       const std::vector<Row>& rows);

/// The rows of a result file, at least one. @throws HarnessError when it has none or is broken
std::vector<Row> rows_in(const Json& result_file);

/// Reads a file of write_result_file: at least one row. Each row gets the file's processor.
/// @throws HarnessError when the file cannot be read, has no row, or is not as it was written:
///         context.geodesic_bench.checksum is the SHA-256 of the file without that key, as compact
///         JSON
std::vector<Row> read_rows(const std::filesystem::path& file);

}  // namespace geodesic::harness
