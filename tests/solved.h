// Solves with a solver that is given by its name.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "solvers/core/registry.h"

namespace geodesic {

/// The distances of all vertices.
inline std::vector<double> distances_by(std::string_view solver, const Mesh& mesh,
                                        const Query& query, Recording* recording = nullptr) {
  std::vector<double> distances(mesh.vertex_count());
  make_solver(solver, mesh)->solve(query, distances, recording);
  return distances;
}

/// The number of windows that the solve propagates.
inline std::uint64_t propagated_by(std::string_view solver, const Mesh& mesh, const Query& query) {
  Recording recording;
  distances_by(solver, mesh, query, &recording);
  return recording.window_propagations.value();
}

}  // namespace geodesic
