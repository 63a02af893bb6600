#include "harness/commands/commands.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/commands/values.h"
#include "harness/corpus/manifest.h"
#include "harness/corpus/sources.h"
#include "harness/run/cell.h"
#include "harness/run/resume.h"
#include "harness/run/run.h"

namespace geodesic::harness {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExamples = R"(
Examples:
  geodesic-bench run --solvers mmp,ich --meshes scans/,horse
  geodesic-bench run --solvers 'edge-based,steiner?points=1,3,7' --meshes horse
  geodesic-bench run --corpus quick --repetitions 9 --out results/runs/mine)";

// Parses "head=build/release/geodesic-bench".
Program program_of(const std::string& word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) throw HarnessError("--program " + word + ": not NAME=PATH");
  return {word.substr(0, equals), fs::absolute(word.substr(equals + 1))};
}

// Splits the words into a suite and flags of Google Benchmark.
void read_words(const std::vector<std::string>& words, RunRequest& request) {
  std::string suite;
  request.benchmark_flags.clear();
  for (const std::string& word : words) {
    if (word.starts_with("--")) {
      request.benchmark_flags.push_back(word);
    } else if (suite.empty()) {
      suite = word;
    } else {
      throw HarnessError("a run takes one suite, not both '" + suite + "' and '" + word + "'");
    }
  }
  if (!suite.empty()) request.suite = read_suite(suite);
}

// Makes paths absolute. Results then depend neither on the current folder nor on later files.
void make_absolute(RunRequest& request) {
  request.suite.meshes = expand_meshes(request.suite.meshes);
  for (std::string& mesh : request.suite.meshes) {
    if (fs::is_regular_file(mesh)) mesh = fs::absolute(mesh).string();
  }
  for (std::string& set : request.suite.source_sets) {
    if (fs::is_regular_file(set)) set = fs::absolute(set).string();
  }
  request.manifest = fs::absolute(request.manifest);
}

// The corpus name for a folder: raw-meshes for "scans/raw meshes".
std::string as_corpus_name(const fs::path& folder) {
  const fs::path last = folder.has_filename() ? folder.filename() : folder.parent_path().filename();
  std::string name = last.string().substr(0, 100);
  std::ranges::replace_if(
      name, [](char c) { return !is_plain(c); }, '-');
  return name.empty() || std::ispunct(static_cast<unsigned char>(name[0])) ? "folder" : name;
}

// Options take effect in the order in which they are added here: each changes the request.
void add_request_options(CLI::App& command, RunRequest& request, bool& plan_only) {
  Suite& suite = request.suite;
  const auto option = [&](const std::string& name, auto& value, const std::string& help) {
    return command.add_option(name, value, help);
  };
  const auto call = [&](const std::string& name, const auto& use, const std::string& help) {
    return command.add_option_function<std::string>(name, use, help);
  };
  call(
      "--resume", [&](const std::string& folder) { request = saved_request(folder); },
      "continue the interrupted run in this folder, with its options")
      ->type_name("DIR");
  const CLI::Option* const suite_option =
      command
          .add_option_function<std::vector<std::string>>(
              "suite", [&](const auto& words) { read_words(words, request); },
              "suite in JSON (harness/suites/default.json); after --, flags of Google Benchmark")
          ->type_name("[SUITE.json] [-- --benchmark_...]");
  call(
      "--corpus",
      [&, suite_option](const std::string& corpus) {
        if (suite_option->empty() && !request.resume) suite = suite_of_corpus(corpus);
        suite.corpus = corpus;
        suite.meshes.clear();  // removes those of the suite
      },
      "corpus of the manifest; a suite of the same name in harness/suites gives its options")
      ->type_name("NAME");
  command
      .add_option_function<std::vector<std::string>>(
          "--meshes",
          [&](const auto& meshes) {
            suite.meshes = meshes;
            suite.corpus = "chosen";
          },
          "mesh files, folders, patterns such as 'scans/*.ply', or names of the manifest, in place "
          "of a corpus")
      ->delimiter(',')
      ->excludes("--corpus")
      ->type_name("NAMES");
  option("--solvers", suite.solvers,
         "solvers to measure (default: all but those that run only when named); a number after a "
         "comma is a further value of the parameter before it")
      ->delimiter(',')
      ->type_name("NAMES");
  option("--cells", request.cells, "only these cells, named as rows: mmp/horse/src:0,...")
      ->delimiter(',')
      ->type_name("NAMES");
  call(
      "--folder",
      [&](const std::string& folder) {
        request.folder = fs::absolute(folder).lexically_normal();
        suite.meshes = mesh_files_below(*request.folder);
        suite.corpus = as_corpus_name(*request.folder);
      },
      "every mesh file in this folder and below it, in place of a corpus; meshes that cannot be "
      "solved are skipped with a reason, or repaired with --repair")
      ->excludes("--meshes")
      ->excludes("--corpus")
      ->type_name("DIR");
  call(
      "--shard", [&](const std::string& word) { request.shard = shard_named(word); },
      "only part K of N: some sources of some meshes, with all solvers; `merge` joins the parts")
      ->type_name("K/N");
  option("--sources", suite.sources, "number of source vertices of each mesh");
  option("--source-sets", suite.source_sets,
         std::string("sets of sources of each mesh; each set is solved in one query: ") +
             kSourceSetForms)
      ->delimiter(',')
      ->type_name("SETS");
  option("--path-targets", suite.path_targets,
         "number of targets of the measured paths, for solvers that have paths (default 0)")
      ->check(CLI::NonNegativeNumber);
  option(
      "--further-sources", suite.further_sources,
      "number of random vertices that each solver then solves from, one after the other, on each "
      "mesh (default 0)")
      ->check(CLI::NonNegativeNumber);
  option("--repetitions", suite.repetitions, "number of timed repetitions of each cell");
  option("--seed", suite.seed, "seed of the choice of source vertices");
  option("--min-time", suite.min_time, "minimum duration of a repetition in seconds");
  option("--reference", suite.reference, "exact solver to verify the others with, or 'brute force'")
      ->type_name("NAME");
  option("--time-limit", suite.time_limit, "seconds after which a cell is stopped (default 3600)");
  option("--memory-limit", suite.memory_limit,
         "memory limit of a cell in bytes, or as 500M, 8G (default: 90% of what is available)")
      ->transform(CLI::Validator(CLI::AsSizeValue(false)).description(""))
      ->type_name("SIZE");
  option("--vectors", suite.vectors, "instruction set of the solvers: auto, plain, avx2 or avx512")
      ->type_name("SET");
  call(
      "--recordings", [&](const std::string& word) { request.recordings = recordings_named(word); },
      "cells that record the wavefront, or inexact distances, for figures: none, all, or auto "
      "(default: the first source of each mesh of 1,000 to 250,000 vertices)")
      ->type_name("WHICH");
  command.add_flag("--frames", request.frames,
                   "record the wavefront at 64 steps, for the moving pictures of `view`");
  command.add_flag("--repair", request.repair, "repair meshes that have defects");
  command.add_flag("--interleave", request.interleave,
                   "run each repetition in a process of its own, alternating between the solvers "
                   "of a mesh and source: their times can be compared in pairs");
  command
      .add_option_function<std::vector<std::string>>(
          "--program",
          [&](const auto& words) {
            request.programs.clear();
            for (const std::string& word : words) request.programs.push_back(program_of(word));
          },
          "build of geodesic-bench to measure instead of this one; give two or more: they "
          "alternate like solvers (implies --interleave)")
      ->allow_extra_args(false)
      ->type_name("NAME=PATH");
  option("--threads", request.threads,
         "reference distances to compute at a time (default: one a processor); solves are timed "
         "one by one")
      ->check(from_to(1, 1024));
  option("--out", request.out, "folder to write to (default: results/runs/<UTC time>-<corpus>)")
      ->type_name("DIR");
  option("--manifest", request.manifest, "list of meshes and corpora")->type_name("FILE");
  command.add_flag("--plan", plan_only, "print how much there is to measure, as JSON, and stop");
  command.add_flag("--accept-changes", request.accept_changes,
                   "resume although the program, an option or a mesh has changed");
}

/// The command that results have: of the script that started this program, if it names its own.
void set_command(RunRequest& request, const std::string& command_line) {
  const char* script = std::getenv("GEODESIC_COMMAND");
  request.of_script = script != nullptr && *script != '\0';
  request.command = request.of_script ? script : command_line;
}

}  // namespace

void add_run_command(CLI::App& app, const std::string& command_line) {
  const auto request = std::make_shared<RunRequest>();
  request->manifest = default_manifest();
  CLI::App* command = app.add_subcommand("run", "Measure solvers on meshes");
  const auto plan_only = std::make_shared<bool>(false);
  add_request_options(*command, *request, *plan_only);
  command->footer(kExamples);
  command->preparse_callback([request, command_line](std::size_t) {
    set_command(*request, command_line);
    require_text(request->command);
    request->suite = read_suite(default_suite());
  });
  command->callback([request, plan_only, command_line] {
    if (request->accept_changes && !request->resume) {
      throw HarnessError("--accept-changes is for a run that is resumed: give --resume DIR");
    }
    if (request->resume && request->out) {
      throw HarnessError("--resume names the folder already: leave out --out");
    }
    if (request->shard && !request->cells.empty()) {
      throw HarnessError(
          "--shard and --cells both choose a part of the run: leave out one of them");
    }
    if (request->resume) load_plugins_of(*request->resume);
    set_command(*request, command_line);
    make_absolute(*request);
    if (*plan_only) {
      check_suite(request->suite);
      std::cout << outline(*request).dump(2) << std::endl;
      return;
    }
    const RunResult result = run(*request);
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
