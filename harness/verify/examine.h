// A solver examined in a process of its own, so that neither a crash nor an endless loop ends the
// examination.
#pragma once

#include <filesystem>

#include "harness/verify/property.h"
#include "harness/verify/spec.h"

namespace geodesic::conformance {

/// The process's side: checks case by case until one fails. @throws what the reader or the disk
/// does
void run_examination(const ExaminationSpec& spec);

/// The other side.
class Examiner {
 public:
  /// @param vectors instructions to solve with (corpus/vectors.h)
  /// @param time_limit seconds that a property may take
  /// @throws HarnessError when there is no place for temporary files
  Examiner(const Description& solver, std::string vectors, double time_limit);
  ~Examiner();
  Examiner(const Examiner&) = delete;
  Examiner& operator=(const Examiner&) = delete;

  const Description& solver() const { return solver_; }
  const std::string& vectors() const { return vectors_; }
  double time_limit() const { return time_limit_; }

  /// On the property's own cases. @throws HarnessError when no process can be started
  Report examine(const Property& property) const;

  /// On another case, which needs a face.
  /// @param seconds in place of the time limit, when it is less
  Report examine(const Property& property, const Case& given, double seconds = kInfinity) const;

  /// As above; a failure is explained.
  Report explain(const Property& property, const Case& given) const;

  /// On a mesh in a file.
  Report examine_file(const Property& property, const std::filesystem::path& mesh,
                      const std::vector<Query>& queries) const;

 private:
  Report run(ExaminationSpec spec, double seconds) const;
  ExaminationSpec on_file(const Property& property, const std::filesystem::path& mesh,
                          const std::vector<Query>& queries) const;
  ExaminationSpec on_case(const Property& property, const Case& given) const;

  const Description& solver_;
  std::string vectors_;
  double time_limit_;
  std::filesystem::path folder_;  // of temporary files
};

}  // namespace geodesic::conformance
