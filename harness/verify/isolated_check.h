// Checks properties in separate processes, so that neither a crash nor an endless loop of a solver
// ends the verification.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "harness/base/json.h"
#include "harness/base/scratch_folder.h"
#include "harness/verify/property.h"

namespace geodesic {

GEODESIC_JSON_MEMBERS(SurfacePoint, vertex, face, weights)
GEODESIC_JSON_MEMBERS(Source, at, distance)
GEODESIC_JSON_MEMBERS(Query, sources, limit, targets, stop_at_targets)

}  // namespace geodesic

namespace geodesic::harness {

/// Results of a check, each worse than those before it.
enum class CheckOutcome : std::uint8_t {
  not_claimed,  ///< the property does not concern the solver, or has nothing to compare
  holds,
  not_known,  ///< no right distances to compare with
  wrong,
  crashed,
  timed_out
};

/// Number of timed-out checks after which a solver is not checked any more.
inline constexpr int kMostTimedOut = 3;

struct CheckResult {
  CheckOutcome outcome = CheckOutcome::not_claimed;
  std::string what = {};    ///< one line; empty when the property holds
  std::string kind = {};    ///< Violation::kind of a failure
  std::size_t at_case = 0;  ///< index of the property's own case that was checked last
  Query query = {};         ///< with the wrong answer; without sources when no single query has one
  double largest_error = 0;  ///< of exact distances on a mesh that is not the property's own
  std::vector<std::string> explanation = {};  ///< lines

  bool failed() const { return outcome >= CheckOutcome::wrong; }
  bool fails_like(const CheckResult& other) const {
    return failed() && outcome == other.outcome && kind == other.kind;
  }
};
GEODESIC_JSON_MEMBERS(CheckResult, outcome, what, kind, at_case, query, largest_error, explanation)

/// A random mesh (meshes/oracles/random_case.h).
struct RandomNumber {
  std::uint64_t seed = 0, number = 0;

  bool operator==(const RandomNumber&) const = default;
};
GEODESIC_JSON_MEMBERS(RandomNumber, seed, number)

/// A check of one property of one solver: on a random mesh, on the case of a file (saved_case.h),
/// or on the property's own cases until one fails.
struct Ask {
  std::string solver, property;
  std::optional<RandomNumber> random = {};
  std::string file = {};
  double seconds = kInfinity;  ///< time limit
  bool explain = false;        ///< whether a failure on the case of a file is explained (explain.h)
};
GEODESIC_JSON_MEMBERS(Ask, solver, property, random, file, seconds, explain)

/// The random mesh, as a case.
/// @param scratch as for random_case
Case random_mesh_case(const RandomNumber& of, const std::filesystem::path& scratch);

/// Makes checks in order, in a process that is started again after a check that ended it.
/// @param vectors name of the instruction set to solve with (corpus/solvers.h)
/// @param memory_bytes limit of the process
/// @param ended called with the index and the result of each check, once the process has ended; the
///        last argument is the kind of the random mesh
/// @param wanted called for each check before a process is started; one that is not wanted is left
/// @throws HarnessError when no process can be started
/// @throws Interrupted, after `ended` has been called for the checks that were made
void check_apart(const std::vector<Ask>& asks, const std::string& vectors,
                 const ScratchFolder& scratch, std::uint64_t memory_bytes,
                 const std::function<bool(const Ask&)>& wanted,
                 const std::function<void(std::size_t, CheckResult, std::size_t)>& ended);

/// Checks one solver, one property at a time.
class IsolatedCheck {
 public:
  /// @param solver must outlive this
  /// @param vectors name of the instruction set to solve with (corpus/solvers.h)
  /// @param time_limit seconds per property
  /// @throws HarnessError when there is no place for temporary files
  IsolatedCheck(const Description& solver, std::string vectors, double time_limit)
      : solver_(solver), vectors_(std::move(vectors)), time_limit_(time_limit) {}

  const Description& solver() const { return solver_; }
  const std::string& vectors() const { return vectors_; }
  double time_limit() const { return time_limit_; }

  /// Checks the property's own cases until one fails. @throws HarnessError when no process can be
  /// started
  CheckResult on_own_cases(const Property& property) const;

  /// Checks another case, whose mesh has at least one face.
  /// @param seconds replaces the time limit when it is less
  /// @param explain whether to explain a failure
  CheckResult on_case(const Property& property, const Case& given, double seconds = kInfinity,
                      bool explain = false) const;

 private:
  CheckResult result_of(const Ask& ask) const;

  const Description& solver_;
  std::string vectors_;
  double time_limit_;
  ScratchFolder folder_;
};

}  // namespace geodesic::harness
