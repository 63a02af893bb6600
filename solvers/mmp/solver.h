// The family MMP as a solver; what its members differ in is a policy (policies.h).
#pragma once

#include "solvers/core/solver.h"
#include "solvers/mmp/propagation.h"
#include "solvers/mmp/recorded.h"

namespace geodesic::mmp {

/// Needs Recorded<Policy>, which the file recorded.cpp of the solver's folder instantiates.
template <class Policy>
class Mmp final : public Solver {
 public:
  Mmp(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), propagation_(mesh) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording != nullptr && recording->what != Record::windows) {
      return Recorded<Policy>::solve(mesh(), query, distances, *recording);
    }
    propagation_.run(query, distances, recording != nullptr ? Keep::all : Keep::wavefront);
    if constexpr (Policy::Layout::kBothSides) {
      if (recording != nullptr) hand_over_windows(*recording->read_windows);
    }
  }

  void hand_over_windows(const ReadWindows& read) const {
    read([this](Index h, std::vector<Window>& windows) { propagation_.copy_windows(h, windows); });
  }

  Propagation<Policy, NoRecorder> propagation_;
};

}  // namespace geodesic::mmp
