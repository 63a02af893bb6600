// Solvers by name. A solver registers itself with one object at namespace scope:
//
//   const RegisterSolver<Dijkstra> registered{{.name = "dijkstra", ...}};
//
// where `Dijkstra` is constructible from (const Mesh&, const Description&). If it is also
// constructible from (const Mesh&, const Description&, PreparedReader&), the third argument is what
// its `save` wrote, and Abilities::saves is set.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "solvers/core/contract.h"
#include "solvers/core/solver.h"

/// Adds a solver that was compiled against `contract` (contract.h). The other arguments are read
/// only if `contract` is the registry's own. Plug-ins of any version call this function: its
/// signature never changes.
/// @param description geodesic::Description, moved from
/// @param factory geodesic::SolverFactory, moved from
/// @throws std::logic_error when it is refused, except within collect_registrations
extern "C" void geodesic_register_solver(const char* contract, void* description, void* factory);

namespace geodesic {

/// @param saved null, or what Solver::save wrote
using SolverFactory = std::function<std::unique_ptr<Solver>(
    const Mesh& mesh, const Description& description, PreparedReader* saved)>;

/// Adds a solver.
/// @throws std::logic_error when the name is taken or a parameter is described wrongly
void register_solver(Description description, SolverFactory factory);

/// The solvers that registered themselves while libraries were loaded.
struct Registrations {
  std::vector<std::string> added;    ///< names of solvers
  std::vector<std::string> refused;  ///< the reasons, one sentence per solver
};

/// Calls `load`, which may load shared libraries. Solvers in them that cannot be added are listed
/// as refused, since no exception can leave the loading of a library.
Registrations collect_registrations(const std::function<void()>& load);

/// Returns the descriptions of all registered solvers, sorted by name.
std::vector<const Description*> registered_solvers();

/// Returns a solver by its name, with values for parameters that are not at their default: "mmp",
/// "avtp?lambda=32&threads=2". The description of a configured solver has one canonical name
/// (defaults left out, parameters in the order of their description, numbers in their shortest
/// form) and one address, which stays valid. Threads may call it at the same time.
/// @return null when no solver has that name
/// @throws std::invalid_argument naming the solver, for an unknown parameter or a value out of
///        range
const Description* find_solver(std::string_view name);

/// As find_solver. @throws std::invalid_argument for an unknown name too, listing the known ones
const Description& solver_named(std::string_view name);

/// The part of a name before the parameters: "avtp" of "avtp?lambda=32".
std::string_view base_name(std::string_view name);

/// Prepares a solver for a mesh. The mesh must outlive the solver.
/// @param name as in solver_named, whose exceptions it throws
/// @param saved null to prepare; or what Solver::save wrote, of a solver of this name on this mesh
/// @throws std::invalid_argument for a mesh that the solver does not support, and for saved data
///         that is not as it was written
std::unique_ptr<Solver> make_solver(std::string_view name, const Mesh& mesh,
                                    PreparedReader* saved = nullptr);

/// Registers S when it is constructed at namespace scope.
/// @tparam by_name_only whether the solver runs only when it is named, whatever it declares
template <class S, bool by_name_only>
struct SolverRegistration {
  explicit SolverRegistration(Description description) {
    constexpr bool saves =
        std::is_constructible_v<S, const Mesh&, const Description&, PreparedReader&>;
    description.by_name_only |= by_name_only;
    description.abilities.saves = saves;
    SolverFactory factory = [](const Mesh& mesh, const Description& d, PreparedReader* saved) {
      if constexpr (saves) {
        if (saved != nullptr) return std::make_unique<S>(mesh, d, *saved);
      }
      return std::make_unique<S>(mesh, d);
    };
    geodesic_register_solver(compiled_contract().c_str(), &description, &factory);
  }
};

// RegisterSolver, as geodesic_add_solver chooses (solvers/CMakeLists.txt). A program contains files
// of both kinds, so that each has a name of its own.
#ifdef GEODESIC_BY_NAME_ONLY
inline namespace registered_by_name {
template <class S>
using RegisterSolver = SolverRegistration<S, true>;
}
#else
inline namespace registered_to_run {
template <class S>
using RegisterSolver = SolverRegistration<S, false>;
}
#endif

}  // namespace geodesic
