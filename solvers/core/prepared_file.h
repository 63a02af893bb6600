// Files of preparations: what a solver has prepared for a mesh, to be read in place of preparing
// again.
//
// A file has a line with the format's number, and then arrays as they lie in memory: the order of
// bytes, the solver's name, the sum of the mesh, those of the solver, and the sum of all of them.
#pragma once

#include <istream>
#include <memory>
#include <ostream>
#include <string>

#include "solvers/core/solver.h"

namespace geodesic {

/// Writes the preparation of a solver.
/// @throws std::invalid_argument for a solver without Abilities::saves
void save_prepared(const Solver& solver, std::ostream& to);

/// The name of the solver that was saved. @throws std::invalid_argument as read_prepared
std::string name_in_prepared(std::istream& from);

/// Reads a solver whose preparation was saved. Its name is that of the solver that was saved.
/// @param mesh must outlive the solver
/// @throws std::invalid_argument when this is no such file, was written for another mesh or by
///         another format, names a solver that this program lacks, or is not as it was written
std::unique_ptr<Solver> read_prepared(const Mesh& mesh, std::istream& from);

}  // namespace geodesic
