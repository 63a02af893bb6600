#include "harness/commands/rank.h"

#include <algorithm>
#include <memory>

#include "harness/base/error.h"
#include "harness/corpus/manifest.h"
#include "harness/rank/measure.h"

namespace geodesic::harness {
namespace {

struct RankFlags {
  RankRequest request = {.suite = {.sources = 1, .repetitions = 1},
                         .manifest = default_manifest(),
                         .out = {},
                         .command = {}};
  std::string solver;
  std::vector<std::string> against;
};

void check_rivals(const std::string& solver, const std::vector<std::string>& rivals) {
  for (auto rival = rivals.begin(); rival != rivals.end(); ++rival) {
    if (*rival == solver) {
      throw HarnessError("'" + solver +
                         "' cannot be ranked against itself: leave it out of --against");
    }
    if (std::find(rivals.begin(), rival, *rival) != rival) {
      throw HarnessError("--against names '" + *rival + "' twice");
    }
  }
}

}  // namespace

void add_rank_command(CLI::App& app, const std::string& command_line) {
  const auto flags = std::make_shared<RankFlags>();
  flags->request.command = command_line;
  Suite& suite = flags->request.suite;
  CLI::App* command = app.add_subcommand(
      "rank", "A solver against others: exactness, paired times, counters, memory");
  const auto option = [&](const std::string& name, auto& value, const std::string& help) {
    return command->add_option(name, value, help);
  };
  option("--solver", flags->solver, "the solver to rank")->required()->type_name("NAME");
  option("--against", flags->against, "its rivals, separated by commas")
      ->required()
      ->delimiter(',')
      ->type_name("NAMES");
  option("--corpus", suite.corpus, "a corpus of the manifest")->capture_default_str();
  option("--meshes", suite.meshes, "names of the manifest or files, in place of a corpus")
      ->delimiter(',');
  option("--sources", suite.sources, "source vertices a mesh")->capture_default_str();
  option("--pairs", flags->request.pairs, "times that each rival is timed beside it on a source")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  option("--seed", suite.seed, "of the choice of sources")->capture_default_str();
  option("--min-time", suite.min_time, "least seconds that a time is taken over")
      ->capture_default_str();
  option("--reference", suite.reference, "exact solver to verify others by");
  option("--vectors", suite.vectors, "instructions to solve with: auto, plain or avx2")
      ->capture_default_str();
  option("--out", flags->request.out, "folder to write to (results/ranks/<UTC time>-<solver>)");
  option("--manifest", flags->request.manifest, "list of meshes and corpora")
      ->capture_default_str();
  command->add_flag("!--no-figure", flags->request.figure, "tables only");
  command->callback([flags] {
    check_rivals(flags->solver, flags->against);
    Suite& ranked = flags->request.suite;
    ranked.solvers = flags->against;
    ranked.solvers.insert(ranked.solvers.begin(), flags->solver);
    const RunResult result = measure_ranking(flags->request);
    if (result != RunResult::ok) throw CLI::RuntimeError(static_cast<int>(result));
  });
}

}  // namespace geodesic::harness
