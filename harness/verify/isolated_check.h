// Properties checked in a process of their own, so that neither a crash nor an endless loop of a
// solver ends the verification.
#pragma once

#include <filesystem>

#include "harness/verify/property.h"

namespace geodesic::harness {

enum class CheckOutcome : std::uint8_t {
  holds,
  not_claimed,  ///< does not concern the solver
  not_known,    ///< there were no right distances to compare with
  wrong,
  crashed,
  timed_out
};

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

/// The side that waits.
class IsolatedCheck {
 public:
  /// @param vectors instructions to solve with (corpus/solvers.h)
  /// @param time_limit seconds that a property may take
  /// @throws HarnessError when there is no place for temporary files
  IsolatedCheck(const Description& solver, std::string vectors, double time_limit);
  ~IsolatedCheck();
  IsolatedCheck(const IsolatedCheck&) = delete;
  IsolatedCheck& operator=(const IsolatedCheck&) = delete;

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
  std::filesystem::path folder_;  // of temporary files
};

/// The side of the process. @param task JSON, from the other side
/// @throws what the reader or the disk does
void run_isolated_check(const std::string& task);

}  // namespace geodesic::harness
