// Solvers and instruction sets by name, and the meshes that a solver supports.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/core/instruction_set.h"
#include "solvers/core/solver.h"

namespace geodesic::harness {

/// Finds "mmp" or "avtp?lambda=32". @throws HarnessError for an unknown name or parameter (the
/// message lists the known ones), and for a value out of range
const Description& solver_named(const std::string& name);

/// The solvers of a list. A word may hold several names separated by commas. A number after a comma
/// is another value of the last parameter before it: "avtp?lambda=8,16" names two solvers, and so
/// does "avtp?threads=2&lambda=8,16". @throws as solver_named
std::vector<const Description*> solvers_named(const std::vector<std::string>& words);

/// The name of a cell, "<solver>/<mesh>" with any end, with the canonical name of its solver.
/// Unchanged if no such solver is registered. @throws as solver_named
std::string canonical_cell(const std::string& cell);

/// Names in the order of Exactness.
inline constexpr std::array<std::string_view, 4> kExactnessNames{"exact", "bounded", "upper_bound",
                                                                 "unbounded"};

constexpr std::string_view exactness_name(Exactness exactness) {
  return kExactnessNames[static_cast<std::size_t>(exactness)];
}

/// The exactness in words, with a bound as a number: "within 0.01", "upper bound".
std::string shown_exactness(const Description& solver);

/// Why the declared abilities of the solver exclude this mesh; empty if they do not.
std::string unsupported(const Description& solver, const Mesh& mesh);

/// Solve times relative to the fastest solver, measured on a scan of 50,000 vertices, by the
/// solver's name without parameters: harness/relative_times.json of the data folder. The speed of a
/// solver that is not in the file is unknown.
using RelativeTimes = std::map<std::string, double, std::less<>>;
const RelativeTimes& relative_times();

/// 0 if it is unknown.
double relative_time(const Description& solver, const RelativeTimes& times = relative_times());

/// Stands for the widest instruction set that the processor and the build have.
inline constexpr const char* kAutoVectors = "auto";

/// @param word "auto" or the name of an instruction set
/// @throws HarnessError for another word, and for a set that the processor or the build lacks
InstructionSet instruction_set_named(const std::string& word);

}  // namespace geodesic::harness
