// Solvers and instruction sets as users name them, and the meshes that solvers can do.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/core/instruction_set.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// "mmp", "avtp?lambda=32". @throws HarnessError for an unknown name or parameter, listing the
/// known ones, and for a value out of range
const Description& solver_named(const std::string& name);

/// Those of a list, whose words may hold several separated by commas. A number after a comma is a
/// further value of the parameter before it, the last of its solver: "avtp?lambda=8,16" is two
/// solvers, "avtp?threads=2&lambda=8,16" too. @throws as solver_named
std::vector<const Description*> solvers_named(const std::vector<std::string>& words);

/// A cell's name, "<solver>/<mesh>" with anything behind it, with the canonical name of its solver;
/// unchanged where no such solver is registered. @throws as solver_named
std::string canonical_cell(const std::string& cell);

/// In the order of Exactness.
inline constexpr std::array<std::string_view, 4> kExactnessNames{"exact", "bounded", "upper_bound",
                                                                 "unbounded"};

constexpr std::string_view exactness_name(Exactness exactness) {
  return kExactnessNames[static_cast<std::size_t>(exactness)];
}

/// The same for readers, a bound as a number: "within 0.01", "upper bound".
std::string shown_exactness(const Description& solver);

/// Why the solver declares that it cannot do this mesh; empty when it can.
std::string unsupported(const Description& solver, const Mesh& mesh);

/// Measured times of solves of a scan of 50,000 vertices, that of the fastest solver being 1, by
/// the solver's name without parameters: harness/relative_times.json of the data folder. A solver
/// that is not in it is of unknown speed.
using RelativeTimes = std::map<std::string, double, std::less<>>;
const RelativeTimes& relative_times();

/// 0 when it is not known.
double relative_time(const Description& solver, const RelativeTimes& times = relative_times());

/// The widest that the processor and the build have.
inline constexpr const char* kAutoVectors = "auto";

/// @param word "auto" or the name of an instruction set
/// @throws HarnessError for another word, or saying what the processor or the build lacks
InstructionSet instruction_set_named(const std::string& word);

}  // namespace geodesic::harness
