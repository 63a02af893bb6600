#include "harness/commands/run.h"

#include <memory>

#include "harness/cells/cell.h"
#include "harness/cells/run.h"
#include "harness/corpus/manifest.h"
#include "harness/error.h"

namespace geodesic::harness {
namespace {

struct RunFlags {
  std::vector<std::string> words;  // the suite, and Google Benchmark's flags after --
  std::optional<std::string> corpus;
  std::optional<std::vector<std::string>> solvers, meshes;
  std::optional<int> sources, repetitions;
  std::optional<std::uint64_t> seed;
  std::optional<double> min_time;
  std::string recordings = "auto";
  unsigned threads = 1;
  std::optional<std::string> reference, vectors, out;
  std::string manifest = default_manifest().string();
};

template <class T>
void override_with(const std::optional<T>& flag, T& value) {
  if (flag) value = *flag;
}

RunRequest request_of(const RunFlags& flags, const std::string& command) {
  RunRequest request{.suite = {},
                     .manifest = flags.manifest,
                     .out = flags.out,
                     .benchmark_flags = {},
                     .pictured = pictured_named(flags.recordings),
                     .threads = flags.threads,
                     .command = command};
  std::string suite_file;
  for (const std::string& word : flags.words) {
    if (word.starts_with("--")) {
      request.benchmark_flags.push_back(word);
    } else if (suite_file.empty()) {
      suite_file = word;
    } else {
      throw HarnessError("a run takes one suite, not both '" + suite_file + "' and '" + word + "'");
    }
  }
  Suite& suite = request.suite;
  suite = read_suite(suite_file.empty() ? default_suite() : std::filesystem::path(suite_file));
  if (flags.corpus) suite.meshes.clear();  // a corpus named here replaces the suite's meshes
  override_with(flags.corpus, suite.corpus);
  override_with(flags.solvers, suite.solvers);
  override_with(flags.meshes, suite.meshes);
  override_with(flags.sources, suite.sources);
  override_with(flags.repetitions, suite.repetitions);
  override_with(flags.seed, suite.seed);
  override_with(flags.min_time, suite.min_time);
  override_with(flags.vectors, suite.vectors);
  if (flags.reference) suite.reference = flags.reference;
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
  option("--recordings", flags->recordings,
         "cells that leave the wavefront and the distances for figures: none, auto (the first "
         "source of each mesh of 1,000 to 250,000 vertices, exact solvers) or all")
      ->capture_default_str();
  option("--threads", flags->threads,
         "reference distances to compute at a time; solvers are timed one by one")
      ->check(CLI::Range(1, 1024));
  option("--vectors", flags->vectors, "instructions to solve with: auto, plain or avx2");
  option("--out", flags->out, "folder of the run (results/runs/<UTC time>-<corpus>)");
  option("--manifest", flags->manifest, "list of meshes and corpora")->capture_default_str();
  run_command->callback([flags, command_line] {
    const RunResult result = run(request_of(*flags, command_line));
    if (result != RunResult::ok) throw CLI::RuntimeError(static_cast<int>(result));
  });
}

void add_cell_commands(CLI::App& app) {
  const auto spec = std::make_shared<std::string>();
  const auto add = [&](const std::string& name, const std::function<void(const Json&)>& work) {
    CLI::App* command = app.add_subcommand(name, "")->group("");
    command->add_option("spec", *spec)->required();
    command->callback([spec, work] { work(Json::parse(*spec)); });
  };
  add("cell", [](const Json& json) { run_cell(json.get<CellSpec>()); });
  add("reference", [](const Json& json) { run_reference(json.get<ReferenceSpec>()); });
}

}  // namespace geodesic::harness
