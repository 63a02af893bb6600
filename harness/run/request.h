// The options of a run. The command `run` fills them in; request.json stores them (resume.h).
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "harness/corpus/suite.h"
#include "harness/run/shards.h"

namespace geodesic::harness {

/// The cells that write recordings for figures.
enum class Recordings {
  none,
  automatic,  ///< the first source of each mesh of 1,000 to 250,000 vertices
  all,
};

/// "none", "auto" or "all". @throws HarnessError for any other word
Recordings recordings_named(const std::string& word);
void to_json(Json& json, Recordings choice);
void from_json(const Json& json, Recordings& choice);

/// Another build of geodesic-bench, which a run measures in place of this one.
struct Program {
  std::string name;
  std::filesystem::path file;
  Json facts = {};  ///< for context.geodesic_bench.programs; of a run that has started
};
GEODESIC_JSON_MEMBERS(Program, name, file)

struct RunRequest {
  Suite suite = {};
  std::filesystem::path manifest = {};
  std::vector<std::string> benchmark_flags = {};
  Recordings recordings = Recordings::automatic;
  bool frames = false;  ///< recordings hold the wavefront at every step
  bool repair = false;  ///< repair meshes with defects
  /// Folder with the mesh files of the suite. Files whose meshes cannot be solved are skipped,
  /// without a failure.
  std::optional<std::filesystem::path> folder = {};
  bool interleave = false;              ///< run every repetition in a separate process
  std::vector<Program> programs = {};   ///< measured in place of this one; none, or two or more
  std::vector<std::string> cells = {};  ///< names of the rows to measure; empty: all
  std::optional<Shard> shard = {};      ///< only this part of the run

  // The members below do not change the results.
  std::optional<std::filesystem::path> out = {};  ///< default: `results/runs/<UTC time>-<corpus>`
  /// References computed at a time; no cell is timed meanwhile.
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::string command = {};  ///< the command line, for the record
  bool of_script = false;    ///< a script started the run, and names the command that resumes it
  std::optional<std::filesystem::path> resume = {};  ///< folder of the run to resume
  bool accept_changes = false;                       ///< resume even if the request has changed

  // Of a run that has started, resumed or not (identify, resume.h).
  Json identity = {};                     ///< all that affects the results, at the last start
  std::string started = {};               ///< in the format of utc_now
  std::vector<Json> environments = {};    ///< of each start that had another one (environment.h)
  std::vector<std::string> changes = {};  ///< accepted since then
};

// The members that affect the results.
GEODESIC_JSON_MEMBERS(RunRequest, suite, manifest, recordings, frames, benchmark_flags, repair,
                      folder, interleave, programs, cells, shard)

}  // namespace geodesic::harness
