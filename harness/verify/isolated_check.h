// Properties checked in a process of their own, so that neither a crash nor an endless loop of a
// solver ends the verification.
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

enum class CheckOutcome : std::uint8_t {
  holds,
  not_claimed,  ///< does not concern the solver
  not_known,    ///< there were no right distances to compare with
  wrong,
  crashed,
  timed_out
};

/// So many checks of a solver may not end; then it is asked no more.
inline constexpr int kMostTimedOut = 3;

struct CheckResult {
  CheckOutcome outcome = CheckOutcome::crashed;  ///< until the process says something else
  std::string what = {};                         ///< one line; empty when the property holds
  std::string kind = {};                         ///< of a failure, as Violation::kind
  std::size_t at_case = 0;  ///< of the property's own cases, the one checked last
  Query query = {};         ///< answered wrongly; without sources when no single one was
  std::vector<std::string> explanation = {};  ///< lines

  bool failed() const { return outcome >= CheckOutcome::wrong; }
  bool fails_like(const CheckResult& other) const {
    return failed() && outcome == other.outcome && kind == other.kind;
  }
};

GEODESIC_JSON_MEMBERS(CheckResult, outcome, what, kind, at_case, query, explanation)

/// Of a process that ended, or was ended, before its check did.
/// @param seconds that it had
CheckResult without_result(const Ended& ended, bool timed_out, double seconds);

/// The side that waits.
class IsolatedCheck {
 public:
  /// @param solver must outlive this
  /// @param vectors instructions to solve with (corpus/solvers.h)
  /// @param time_limit seconds that a property may take
  /// @throws HarnessError when there is no place for temporary files
  IsolatedCheck(const Description& solver, std::string vectors, double time_limit)
      : solver_(solver), vectors_(std::move(vectors)), time_limit_(time_limit) {}

  const Description& solver() const { return solver_; }
  const std::string& vectors() const { return vectors_; }
  double time_limit() const { return time_limit_; }

  /// On the property's own cases, until one fails. @throws HarnessError when no process can be
  /// started
  CheckResult on_own_cases(const Property& property) const;

  /// On another case, which has a face.
  /// @param seconds in place of the time limit, when it is less
  /// @param explain whether a failure is explained (explain.h)
  CheckResult on_case(const Property& property, const Case& given, double seconds = kInfinity,
                      bool explain = false) const;

 private:
  const Description& solver_;
  std::string vectors_;
  double time_limit_;
  ScratchFolder folder_;
};

/// The side of the process. @param task JSON, from the other side
/// @throws what the reader or the disk does
void run_isolated_check(const std::string& task);

}  // namespace geodesic::harness
