// Instruction sets as users name them: --vectors auto|plain|avx2.
#pragma once

#include <string>

#include "solvers/core/instruction_set.h"

namespace geodesic::harness {

/// The widest that the processor and the build have.
inline constexpr const char* kAutoVectors = "auto";

/// @param word "auto" or the name of an instruction set
/// @throws HarnessError for another word, or saying what the processor or the build lacks
InstructionSet instruction_set_named(const std::string& word);

}  // namespace geodesic::harness
