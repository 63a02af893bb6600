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
#include <utility>
#include <vector>

#include "solvers/core/contract.h"
#include "solvers/core/solver.h"

/// Adds a solver that was compiled against `contract` (contract.h), and looks at nothing else if
/// that is not the registry's own. What crosses over from a plug-in of any version comes this way:
/// the signature never changes.
/// @param description geodesic::Description, moved from
/// @param factory geodesic::SolverFactory, moved from
/// @throws std::logic_error when it is refused, unless somebody collects (collect_registrations)
extern "C" void geodesic_register_solver(const char* contract, void* description, void* factory);

namespace geodesic {

using SolverFactory =
    std::function<std::unique_ptr<Solver>(const Mesh& mesh, const Description& description)>;

/// Adds a solver. @throws std::logic_error when the name is taken.
void register_solver(Description description, SolverFactory factory);

/// What became of the solvers that registered themselves.
struct Registrations {
  std::vector<std::string> added;    ///< names
  std::vector<std::string> refused;  ///< why, a sentence each
};

/// Calls `load`, which may load shared libraries. Solvers in them that cannot be added are refused
/// in the result: an exception could not leave the loading of a library.
Registrations collect_registrations(const std::function<void()>& load);

/// Descriptions of all registered solvers, by name.
std::vector<const Description*> registered_solvers();

/// @return null when no solver has that name
const Description* find_solver(std::string_view name);

/// Prepares a solver for a mesh, which must outlive it. Whatever the mesh's unit of length is, the
/// solver works in one in which squares and fourth powers of lengths stay within range
/// (core/unit.h).
/// @throws std::invalid_argument for an unknown name, listing the known ones
std::unique_ptr<Solver> make_solver(std::string_view name, const Mesh& mesh);

/// Registers S when it is constructed, as an object at namespace scope.
template <class S>
struct RegisterSolver {
  explicit RegisterSolver(Description description) {
    SolverFactory factory = [](const Mesh& mesh, const Description& d) {
      return std::make_unique<S>(mesh, d);
    };
    geodesic_register_solver(contract_compiled_against().c_str(), &description, &factory);
  }
};

}  // namespace geodesic
