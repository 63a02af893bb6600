// The family CH as a solver; what its members differ in is a policy (policies.h).
#pragma once

#include <stdexcept>
#include <string>

#include "solvers/chen_han/propagation.h"
#include "solvers/chen_han/recorded.h"
#include "solvers/core/solver.h"

namespace geodesic::chen_han {

/// Needs Recorded<Policy>, which the file recorded.cpp of the solver's folder instantiates.
template <class Policy>
class ChenHan final : public Solver {
 public:
  ChenHan(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), propagation_(checked(mesh, description)) {}

 private:
  static const Mesh& checked(const Mesh& mesh, const Description& description) {
    if (mesh.vertex_count() <= kMaxVertices) return mesh;
    throw std::invalid_argument(description.name + ": supports at most " +
                                std::to_string(kMaxVertices) + " vertices");
  }

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) return propagation_.run(query, distances);
    Recorded<Policy>::solve(mesh(), query, distances, *recording);
  }

  Propagation<Policy, NoRecorder> propagation_;
};

}  // namespace geodesic::chen_han
