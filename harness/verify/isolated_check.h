// Checks properties in a separate process, so that neither a crash nor an endless loop of a solver
// ends the verification.
#pragma once

#include <filesystem>

#include "harness/base/json.h"
#include "harness/base/process.h"
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
  CheckOutcome outcome = CheckOutcome::crashed;  ///< until the process writes another
  std::string what = {};                         ///< one line; empty when the property holds
  std::string kind = {};                         ///< Violation::kind of a failure
  std::size_t at_case = 0;  ///< index of the property's own case that was checked last
  Query query = {};         ///< with the wrong answer; without sources when no single query has one
  std::vector<std::string> explanation = {};  ///< lines

  bool failed() const { return outcome >= CheckOutcome::wrong; }
  bool fails_like(const CheckResult& other) const {
    return failed() && outcome == other.outcome && kind == other.kind;
  }
};

GEODESIC_JSON_MEMBERS(CheckResult, outcome, what, kind, at_case, query, explanation)

/// The result of a check whose process ended, or was ended, before the check.
/// @param seconds time limit of the process
CheckResult without_result(const Ended& ended, bool timed_out, double seconds);

/// Starts the process of each check and waits for its result.
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
  /// @param explain whether to explain a failure (explain.h)
  CheckResult on_case(const Property& property, const Case& given, double seconds = kInfinity,
                      bool explain = false) const;

 private:
  const Description& solver_;
  std::string vectors_;
  double time_limit_;
  ScratchFolder folder_;
};

/// Checks a property in the process that IsolatedCheck started. @param task JSON written by it
/// @throws the exceptions of reading the mesh file and of writing the result file
void run_isolated_check(const std::string& task);

}  // namespace geodesic::harness
