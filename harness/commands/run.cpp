#include "harness/commands/run.h"

#include <memory>

#include "harness/base/error.h"
#include "harness/cells/cell.h"
#include "harness/cells/ending.h"
#include "harness/cells/run.h"
#include "harness/corpus/manifest.h"

namespace geodesic::harness {
namespace {

struct RunFlags {
  std::vector<std::string> words;  // the suite, and Google Benchmark's flags after --
  std::optional<std::string> corpus;
  std::optional<std::vector<std::string>> solvers, meshes;
  std::optional<int> sources, repetitions;
  std::optional<std::uint64_t> seed;
  std::optional<double> min_time;
  std::optional<double> time_limit;
  std::optional<std::uint64_t> memory_limit;
  std::optional<std::string> recordings;
  unsigned threads = 1;
  std::optional<std::string> reference, vectors, out, manifest, resume;
  bool accept_changes = false, interleave = false;
  std::vector<std::string> programs, cells;
};

// "head=build/release/geodesic-bench"
ProgramFile program_of(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) throw HarnessError("--program " + word + ": not NAME=PATH");
  return {word.substr(0, equals), std::filesystem::absolute(word.substr(equals + 1))};
}

template <class T>
void override_with(const std::optional<T>& flag, T& value) {
  if (flag) value = *flag;
}

// Results do not change with the folder that one happens to stand in.
void make_absolute(RunRequest& request) {
  for (std::string& mesh : request.suite.meshes) {
    if (std::filesystem::is_regular_file(mesh)) mesh = std::filesystem::absolute(mesh).string();
  }
  request.manifest = std::filesystem::absolute(request.manifest);
}

// What the flags change: the default suite, or the run that is gone on with.
RunRequest starting_point(const RunFlags& flags) {
  if (!flags.resume) {
    RunRequest fresh;
    fresh.manifest = default_manifest();
    fresh.out = flags.out;
    return fresh;
  }
  if (flags.out) throw HarnessError("--resume names the folder already: leave out --out");
  return saved_request(*flags.resume).request;
}

RunRequest request_of(const RunFlags& flags, const std::string& command) {
  RunRequest request = starting_point(flags);
  request.threads = flags.threads;
  request.accept_changes = flags.accept_changes;
  request.command = command;
  std::vector<std::string> benchmark_flags;
  std::string suite_file;
  for (const std::string& word : flags.words) {
    if (word.starts_with("--")) {
      benchmark_flags.push_back(word);
    } else if (suite_file.empty()) {
      suite_file = word;
    } else {
      throw HarnessError("a run takes one suite, not both '" + suite_file + "' and '" + word + "'");
    }
  }
  if (!benchmark_flags.empty()) request.benchmark_flags = benchmark_flags;
  if (flags.recordings) request.pictured = pictured_named(*flags.recordings);
  if (flags.manifest) request.manifest = *flags.manifest;
  Suite& suite = request.suite;
  if (!suite_file.empty()) {
    suite = read_suite(suite_file);
  } else if (!flags.resume) {
    suite = read_suite(default_suite());
  }
  if (flags.corpus) suite.meshes.clear();  // a corpus named here replaces the suite's meshes
  override_with(flags.corpus, suite.corpus);
  override_with(flags.solvers, suite.solvers);
  override_with(flags.meshes, suite.meshes);
  override_with(flags.sources, suite.sources);
  override_with(flags.repetitions, suite.repetitions);
  override_with(flags.seed, suite.seed);
  override_with(flags.min_time, suite.min_time);
  override_with(flags.vectors, suite.vectors);
  override_with(flags.time_limit, suite.time_limit);
  if (flags.memory_limit) suite.memory_limit = flags.memory_limit;
  if (flags.reference) suite.reference = flags.reference;
  request.interleave |= flags.interleave;
  if (!flags.programs.empty()) {
    request.programs.clear();
    for (const std::string& word : flags.programs) request.programs.push_back(program_of(word));
  }
  if (!flags.cells.empty()) request.cells = flags.cells;
  make_absolute(request);
  return request;
}

}  // namespace

void add_run_command(CLI::App& app, const std::string& command_line) {
  const auto flags = std::make_shared<RunFlags>();
  CLI::App* run_command = app.add_subcommand("run", "Measure solvers on meshes, by a suite");
  run_command
      ->add_option("suite", flags->words,
                   "suite in JSON (harness/suites/default.json); after --, flags of Google "
                   "Benchmark")
      ->type_name("[SUITE.json] [-- --benchmark_...]");
  const auto option = [&](const std::string& name, auto& value, const std::string& help) {
    return run_command->add_option(name, value, help);
  };
  option("--corpus", flags->corpus, "a corpus of the manifest")->type_name("NAME");
  option("--solvers", flags->solvers,
         "names, separated by commas (default: those that list says always run)")
      ->delimiter(',');
  option("--meshes", flags->meshes, "names of the manifest or files, separated by commas")
      ->delimiter(',');
  option("--sources", flags->sources, "source vertices a mesh");
  option("--repetitions", flags->repetitions, "timed repetitions a cell");
  option("--seed", flags->seed, "of the choice of sources");
  option("--min-time", flags->min_time, "least seconds of a repetition");
  option("--reference", flags->reference, "exact solver to verify others by");
  option("--time-limit", flags->time_limit, "seconds that a cell may take (3600)");
  option("--memory-limit", flags->memory_limit,
         "memory that a cell may have, in bytes or as 500M, 8G (nine tenths of what is available)")
      ->transform(CLI::AsSizeValue(false))
      ->type_name("SIZE");
  option("--recordings", flags->recordings,
         "cells that leave the wavefront and the distances for figures: none, auto (default: the "
         "first source of each mesh of 1,000 to 250,000 vertices, exact solvers) or all");
  option("--threads", flags->threads,
         "reference distances to compute at a time; solvers are timed one by one")
      ->check(CLI::Range(1, 1024));
  run_command->add_flag("--interleave", flags->interleave,
                        "run every repetition in a process of its own, and alternate the solvers "
                        "of a mesh and source, so that their times can be compared in pairs");
  option("--program", flags->programs,
         "measure the solvers of this build of geodesic-bench; given two times or more, the "
         "builds alternate as solvers do (implies --interleave)")
      ->allow_extra_args(false)
      ->type_name("NAME=PATH");
  option("--cells", flags->cells,
         "only these cells, by the names of their rows: mmp/horse/src:0,ich/horse/src:0")
      ->delimiter(',')
      ->type_name("NAMES");
  option("--vectors", flags->vectors, "instructions to solve with: auto, plain or avx2");
  option("--out", flags->out, "folder of the run (results/runs/<UTC time>-<corpus>)");
  option("--resume", flags->resume,
         "folder of a run that was interrupted: measure what is missing, by the options it had")
      ->type_name("DIR");
  run_command->add_flag("--accept-changes", flags->accept_changes,
                        "resume though the program, an option or a mesh has changed");
  option("--manifest", flags->manifest,
         "list of meshes and corpora (" + default_manifest().string() + ")");
  run_command->callback([flags, command_line] {
    if (flags->accept_changes && !flags->resume) {
      throw HarnessError("--accept-changes is for a run that is gone on with: give --resume DIR");
    }
    const RunResult result = run(request_of(*flags, command_line));
    if (result != RunResult::ok) throw CLI::RuntimeError(static_cast<int>(result));
  });
}

void add_cell_commands(CLI::App& app) {
  const auto spec = std::make_shared<std::string>();
  const auto add = [&](const std::string& name, const std::function<void(const Json&)>& work) {
    CLI::App* command = app.add_subcommand(name, "")->group("");
    command->add_option("spec", *spec)->required();
    command->callback([spec, work] {
      const int code = exit_code_of([&] { work(Json::parse(*spec)); });
      if (code != 0) throw CLI::RuntimeError(code);
    });
  };
  add("cell", [](const Json& json) { run_cell(json.get<CellSpec>()); });
  add("reference", [](const Json& json) { run_reference(json.get<ReferenceSpec>()); });
}

}  // namespace geodesic::harness
