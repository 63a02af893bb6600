// Saves the smallest case on which a property fails, with the command that reproduces it.
#pragma once

#include <filesystem>
#include <set>

#include "harness/verify/isolated_check.h"

namespace geodesic::harness {

/// A property and the case on which it failed.
struct FailedProperty {
  const Property* property;
  std::string name;  ///< of the property, and of the mesh if it is a user's
  bool own;          ///< whether the case is one of the property's own
  Case given;
  CheckResult result;
};

/// Prints the failures of one call, for debugging.
class FailureReport {
 public:
  /// @param folder for meshes; made when the first mesh is saved
  /// @param seconds to spend on making a case smaller; with 0 no mesh is saved
  FailureReport(std::filesystem::path folder, double seconds)
      : folder_(std::move(folder)), seconds_(seconds) {}

  /// Shrinks the case, writes it, checks whether it still fails when it is read back, and prints
  /// the file, the command that reproduces the failure, and its explanation. The case is not shrunk
  /// if the property holds on its own meshes only.
  /// @throws HarnessError when the file cannot be written
  void show(const IsolatedCheck& check, const FailedProperty& failed);

 private:
  std::filesystem::path unused_file(const FailedProperty& failed);

  std::filesystem::path folder_;
  double seconds_;
  std::set<std::filesystem::path> written_;
};

}  // namespace geodesic::harness
