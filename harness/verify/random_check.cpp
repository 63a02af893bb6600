#include "harness/verify/random_check.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <set>

#include "harness/base/control_groups.h"
#include "harness/base/status_line.h"
#include "harness/corpus/solvers.h"
#include "meshes/threads.h"

namespace geodesic::harness {
namespace {

// Properties to check on a random mesh. Those that need no right distances come last.
constexpr const char* kProperties[] = {kDistancesProperty,
                                       "sources-in-faces-and-on-edges-equal-inserted-vertices",
                                       "targets-in-faces-and-on-edges-equal-inserted-vertices",
                                       "paths-begin-in-faces-and-on-edges-too"};
constexpr std::uint64_t kChunk = 100;  // meshes per process

class RandomCheck {
 public:
  RandomCheck(const std::vector<const Description*>& solvers, const RandomMeshes& meshes,
              const std::string& vectors, double time_limit,
              const std::function<void(RandomFailure)>& failed, RandomTally& tally)
      : solvers_(solvers),
        meshes_(meshes),
        vectors_(vectors),
        time_limit_(time_limit),
        failed_(failed),
        progress_(meshes.count, "meshes"),
        tally_(tally) {}

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
  std::vector<Ask> checks_on(std::uint64_t mesh) const {
    std::vector<Ask> asks;
    for (const char* name : kProperties) {
      for (const Description* solver : solvers_) {
        if (!unclaimed(property_named(name), *solver).empty()) continue;
        asks.push_back({.solver = solver->name,
                        .property = name,
                        .random = RandomNumber{meshes_.seed, mesh},
                        .seconds = time_limit_});
      }
    }
    return asks;
  }

  void check(std::uint64_t first, std::uint64_t end, const ScratchFolder& scratch) {
    std::vector<Ask> asks;
    for (std::uint64_t mesh = first; mesh < end; ++mesh) {
      std::ranges::copy(checks_on(mesh), std::back_inserter(asks));
    }
    std::uint64_t counted = first;  // the next mesh that is not counted yet
    check_apart(
        asks, vectors_, scratch, available_memory() / meshes_.jobs,
        [this](const Ask& ask) { return wants(ask); },
        [&](std::size_t i, const CheckResult& result, std::size_t kind) {
          const std::lock_guard lock(mutex_);
          if (asks[i].random->number >= counted) {
            counted = asks[i].random->number + 1;
            ++tally_.meshes.at(kind);
          }
          take(asks[i], result, kind);
        });
  }

  // A solver that never ends would take the time limit for every mesh.
  bool wants(const Ask& ask) {
    const std::lock_guard lock(mutex_);
    if (timed_out_[ask.solver] < kMostTimedOut) return true;
    ++tally_.solvers[ask.solver].not_checked;
    return false;
  }

  void take(const Ask& ask, const CheckResult& result, std::size_t kind) {
    RandomTally::OfSolver& of = tally_.solvers[ask.solver];
    of.largest_error.at(kind) = std::max(of.largest_error.at(kind), result.largest_error);
    if (result.outcome == CheckOutcome::timed_out) ++timed_out_[ask.solver];
    if (result.outcome == CheckOutcome::not_known) {
      ++of.not_known;
    } else if (result.outcome == CheckOutcome::holds) {
      ++of.hold;
    } else if (result.failed()) {
      ++of.failed;
      progress_.clear();
      failed_(
          {ask.random->number, &solver_named(ask.solver), &property_named(ask.property), result});
    }
  }

  const std::vector<const Description*>& solvers_;
  const RandomMeshes& meshes_;
  const std::string& vectors_;
  const double time_limit_;
  const std::function<void(RandomFailure)>& failed_;
  CountLine progress_;
  std::mutex mutex_;  // guards all members below
  RandomTally& tally_;
  std::map<std::string, int> timed_out_;
};

}  // namespace

void check_on_random_meshes(const std::vector<const Description*>& solvers,
                            const RandomMeshes& meshes, const std::string& vectors,
                            double time_limit, const std::function<void(RandomFailure)>& failed,
                            RandomTally& tally) {
  RandomCheck(solvers, meshes, vectors, time_limit, failed, tally).run();
}

}  // namespace geodesic::harness
