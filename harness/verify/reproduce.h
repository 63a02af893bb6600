// The smallest case on which a property fails, as a mesh in a file and a command.
#pragma once

#include <filesystem>
#include <set>

#include "harness/verify/isolated_check.h"

namespace geodesic::harness {

/// What failed, and on what.
struct FailedProperty {
  const Property* property;
  std::string name;  ///< of the property, with the mesh if it is a user's
  bool own;          ///< whether the case is one of the property's own
  Case given;
  CheckResult result;
};

/// Prints failures of one call for the person who debugs the solver.
class FailureReport {
 public:
  /// @param folder for meshes; made when the first one is saved
  /// @param seconds to spend on making a case smaller; 0 saves none
  FailureReport(std::filesystem::path folder, double seconds)
      : folder_(std::move(folder)), seconds_(seconds) {}

  /// Shrinks the case, writes it, checks whether it still fails when it is read back, and prints
  /// the file, the command that makes it fail again, and what explains it. A case of a property
  /// that holds on its own meshes only is written as it is.
  /// @throws HarnessError when the file cannot be written
  void show(const IsolatedCheck& check, const FailedProperty& failed);

 private:
  std::filesystem::path unused_file(const FailedProperty& failed);

  std::filesystem::path folder_;
  double seconds_;
  std::set<std::filesystem::path> written_;
};

}  // namespace geodesic::harness
