#include "harness/verify/random_check.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <mutex>
#include <optional>
#include <set>

#include "harness/base/available_memory.h"
#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/base/status_line.h"
#include "harness/corpus/solvers.h"
#include "meshes/threads.h"

namespace geodesic::harness {

/// A check of one property of one solver on a mesh.
struct RandomAsk {
  std::uint64_t mesh = 0;
  std::uint64_t number = 0;  // of the check on this mesh, from 0
  std::string solver = {}, property = {};
};
GEODESIC_JSON_MEMBERS(RandomAsk, mesh, number, solver, property)

struct RandomTask {
  std::vector<std::string> solvers;
  std::string vectors;
  std::uint64_t seed = 0, first = 0, end = 0;  // numbers of meshes
  std::uint64_t skip = 0;                      // checks to skip on the first mesh
  std::vector<std::string> given_up = {};      // solvers that are not checked any more
  double time_limit = 0;
  std::string log_file, scratch;
};
GEODESIC_JSON_MEMBERS(RandomTask, solvers, vectors, seed, first, end, skip, given_up, time_limit,
                      log_file, scratch)

namespace {

// Properties to check on a random mesh. Those that need no right distances come last.
constexpr const char* kProperties[] = {kDistancesProperty,
                                       "sources-in-faces-and-on-edges-equal-inserted-vertices",
                                       "targets-in-faces-and-on-edges-equal-inserted-vertices",
                                       "paths-begin-in-faces-and-on-edges-too"};
constexpr std::uint64_t kChunk = 100;  // meshes per process

// Logs every step as a line of JSON, so that RandomCheck knows where the process ended:
// {"kind": of the mesh, "resumed": whether an earlier process began it}, {"not_checked": solver},
// {"ask": RandomAsk}, {"reference": its name, or "" when it has answered},
// {"result": CheckResult, "largest": error}.
class RandomProcess {
 public:
  explicit RandomProcess(const RandomTask& task) : task_(task), log_(task.log_file) {
    for (const std::string& name : task.solvers) solvers_.push_back(&solver_named(name));
    LocalReference::watch = [this](const std::string& name) { write({{"reference", name}}); };
  }

  void run() {
    for (std::uint64_t mesh = task_.first; mesh < task_.end; ++mesh) examine(mesh);
    LocalReference::watch = nullptr;
  }

 private:
  void examine(std::uint64_t mesh) {
    const Case given = random_mesh_case(task_.seed, mesh, task_.scratch);
    const std::uint64_t skip = mesh == task_.first ? task_.skip : 0;
    write({{"kind", kind_of(given.build())}, {"resumed", skip > 0}});
    std::uint64_t number = 0;
    for (const char* name : kProperties) {
      const Property& property = property_named(name);
      for (const Description* solver : solvers_) {
        if (!unclaimed(property, *solver).empty() || too_large(given, *solver)) continue;
        const RandomAsk ask{mesh, number++, solver->name, name};
        if (ask.number < skip) continue;
        if (std::ranges::count(task_.given_up, solver->name) > 0) {
          write({{"not_checked", solver->name}});
          continue;
        }
        write({{"ask", ask}});
        check(property, *solver, given);
      }
    }
  }

  void check(const Property& property, const Description& solver, const Case& given) {
    CheckResult result{.outcome = CheckOutcome::holds};
    double largest = 0;
    alarm(static_cast<unsigned>(std::ceil(std::min(task_.time_limit, 1e9))));
    try {
      if (const Finding finding = check_case(property, solver, given, &largest)) {
        result = {.outcome = CheckOutcome::wrong,
                  .what = finding->what,
                  .kind = finding->kind,
                  .query = finding->query};
      }
    } catch (const NothingCompared& error) {
      result = {.outcome = CheckOutcome::not_claimed, .what = error.what()};
    } catch (const NoReference& error) {
      result = {.outcome = CheckOutcome::not_known, .what = error.what()};
    }
    alarm(0);
    write({{"result", result}, {"largest", largest}});
  }

  // Messages of solvers may not be UTF-8.
  void write(const Json& line) {
    log_ << line.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
  }

  const RandomTask& task_;
  std::ofstream log_;
  std::vector<const Description*> solvers_;
};

// Starts the processes and reads their logs.
class RandomCheck {
 public:
  RandomCheck(const std::vector<const Description*>& solvers, const RandomMeshes& meshes,
              const std::string& vectors, double time_limit,
              const std::function<void(RandomFailure)>& failed, RandomTally& tally)
      : meshes_(meshes), failed_(failed), progress_(meshes.count, "meshes"), tally_(tally) {
    task_.vectors = vectors;
    task_.seed = meshes.seed;
    task_.time_limit = time_limit;
    for (const Description* solver : solvers) task_.solvers.push_back(solver->name);
  }

  void run() {
    const std::uint64_t chunks = (meshes_.count + kChunk - 1) / kChunk;
    do_in_threads(chunks, meshes_.jobs, [this]() -> Worker {
      return [this, scratch = std::make_shared<ScratchFolder>()](std::size_t chunk) {
        const std::uint64_t begin = chunk * kChunk, end = std::min(begin + kChunk, meshes_.count);
        check(meshes_.first + begin, meshes_.first + end, *scratch);
        progress_.ended(end - begin);
      };
    });
  }

 private:
  void check(std::uint64_t first, std::uint64_t end, const ScratchFolder& scratch) {
    RandomTask task = task_;
    task.first = first;
    task.end = end;
    task.scratch = scratch.path();
    task.log_file = scratch / "log.jsonl";
    for (;;) {
      {
        const std::lock_guard lock(mutex_);
        task.given_up.assign(given_up_.begin(), given_up_.end());
      }
      const Ended ended = run_process(task);
      const std::lock_guard lock(mutex_);
      const std::optional<RandomAsk> died_in = read(task.log_file);
      if (!died_in && ended.succeeded()) return;
      if (!died_in) throw HarnessError("check-random " + ended.describe());
      ended_in(*died_in, ended);
      task.first = died_in->mesh;
      task.skip = died_in->number + 1;
    }
  }

  Ended run_process(const RandomTask& task) {
    try {
      return run_geodesic_bench({"check-random", Json(task).dump()}, [] {},
                                {.memory_bytes = available_memory() / meshes_.jobs});
    } catch (const Interrupted&) {
      const std::lock_guard lock(mutex_);
      read(task.log_file);
      throw;
    }
  }

  // @return the last check, if it has no result
  std::optional<RandomAsk> read(const std::string& log_file) {
    std::optional<RandomAsk> asked;
    std::ifstream log(log_file);
    for (std::string text; std::getline(log, text);) {
      const Json line = Json::parse(text, nullptr, /*allow_exceptions=*/false);
      if (line.is_discarded()) break;  // the last line of a process that was killed
      if (line.contains("kind")) {
        kind_ = line["kind"].get<std::size_t>();
        if (!line["resumed"].get<bool>()) ++tally_.meshes.at(kind_);
      } else if (line.contains("not_checked")) {
        ++tally_.solvers[line["not_checked"].get<std::string>()].not_checked;
      } else if (line.contains("ask")) {
        asked = line["ask"].get<RandomAsk>();
        reference_.clear();
      } else if (line.contains("reference")) {
        reference_ = line["reference"].get<std::string>();
      } else if (asked) {
        take(*asked, line["result"].get<CheckResult>());
        double& largest = tally_.solvers[asked->solver].largest_error.at(kind_);
        largest = std::max(largest, line.value("largest", 0.0));
        asked.reset();
      }
    }
    return asked;
  }

  void ended_in(const RandomAsk& ask, const Ended& ended) {
    const bool timed_out = ended.crashed && ended.code == SIGALRM;
    CheckResult result = without_result(ended, timed_out, task_.time_limit);
    if (!reference_.empty()) result.outcome = CheckOutcome::not_known;
    if (timed_out && reference_.empty() && ++timed_out_[ask.solver] >= kMostTimedOut) {
      given_up_.insert(ask.solver);
    }
    take(ask, result);
  }

  void take(const RandomAsk& ask, CheckResult result) {
    RandomTally::OfSolver& of = tally_.solvers[ask.solver];
    if (result.outcome == CheckOutcome::not_known) {
      ++of.not_known;
    } else if (result.outcome == CheckOutcome::holds) {
      ++of.hold;
    } else if (result.failed()) {
      ++of.failed;
      progress_.clear();
      failed_(
          {ask.mesh, &solver_named(ask.solver), &property_named(ask.property), std::move(result)});
    }
  }

  const RandomMeshes& meshes_;
  const std::function<void(RandomFailure)>& failed_;
  RandomTask task_;
  CountLine progress_;
  std::mutex mutex_;  // guards all members below
  RandomTally& tally_;
  std::size_t kind_ = 0;   // of the current mesh of a log
  std::string reference_;  // that is computing there; empty: none
  std::map<std::string, int> timed_out_;
  std::set<std::string> given_up_;
};

}  // namespace

Case random_mesh_case(std::uint64_t seed, std::uint64_t number,
                      const std::filesystem::path& scratch) {
  RandomCase made = random_case(seed, number, scratch);
  return {.mesh = made.recipe,
          .soup = std::move(made.soup),
          .queries = {made.query},
          .tolerance = {.least = made.least_distance}};
}

void check_on_random_meshes(const std::vector<const Description*>& solvers,
                            const RandomMeshes& meshes, const std::string& vectors,
                            double time_limit, const std::function<void(RandomFailure)>& failed,
                            RandomTally& tally) {
  RandomCheck(solvers, meshes, vectors, time_limit, failed, tally).run();
}

void run_random_check(const std::string& task_json) {
  const auto task = Json::parse(task_json).get<RandomTask>();
  set_instruction_set(instruction_set_named(task.vectors));
  RandomProcess(task).run();
}

}  // namespace geodesic::harness
