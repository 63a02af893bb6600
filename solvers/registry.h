// Solvers by name. A solver registers itself with one object at namespace scope:
//
//   const RegisterSolver<Dijkstra> registered{{.name = "dijkstra", ...}};
//
// where `Dijkstra` is constructible from (const Mesh&, const Description&).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/solver.h"

namespace geodesic {

using SolverFactory =
    std::function<std::unique_ptr<Solver>(const Mesh& mesh, const Description& description)>;

/// Adds a solver. @throws std::logic_error when the name is taken.
void register_solver(Description description, SolverFactory factory);

/// Descriptions of all registered solvers, by name.
std::vector<const Description*> registered_solvers();

/// @return null when no solver has that name
const Description* find_solver(std::string_view name);

/// Prepares a solver for a mesh, which must outlive it.
/// @throws std::invalid_argument for an unknown name, listing the known ones
std::unique_ptr<Solver> make_solver(std::string_view name, const Mesh& mesh);

/// Registers S when it is constructed, as an object at namespace scope.
template <class S>
struct RegisterSolver {
  explicit RegisterSolver(Description description) {
    register_solver(std::move(description), [](const Mesh& mesh, const Description& d) {
      return std::make_unique<S>(mesh, d);
    });
  }
};

}  // namespace geodesic
