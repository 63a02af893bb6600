// Which cells of a run leave recordings for pictures.
#pragma once

#include <string>

#include "harness/cells/plan.h"

namespace geodesic::harness {

enum class Pictured {
  none,
  automatic,  ///< of each mesh of reasonable size the first source, exact solvers only
  all,
};

inline constexpr Index kLeastPictured = 1000;    ///< vertices: a wavefront needs some to show
inline constexpr Index kMostPictured = 250'000;  ///< files grow with the mesh

/// "none", "auto" or "all". @throws HarnessError for any other word
Pictured pictured_named(const std::string& word);

/// The reverse.
std::string name_of(Pictured wish);

bool is_pictured(const Cell& cell, Pictured wish);

}  // namespace geodesic::harness
