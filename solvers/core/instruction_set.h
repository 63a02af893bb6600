// Which vector instructions solvers run with.
//
// A solver may be compiled for several instruction sets, all of which give the same bits. It takes
// the widest one that the processor has, or the one chosen here, when it is constructed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace geodesic {

enum class InstructionSet : std::uint8_t {
  plain,  ///< what every processor of the architecture has: SSE2 on x86-64
  avx2,
  avx512,  ///< its parts F, BW, CD, DQ and VL
};
/// From the narrowest one on.
inline constexpr std::array kInstructionSets{InstructionSet::plain, InstructionSet::avx2,
                                             InstructionSet::avx512};

/// "plain", "avx2", "avx512"
std::string_view name_of(InstructionSet set);

/// What this processor or this build lacks to run solvers with it; empty when nothing.
std::string why_unavailable(InstructionSet set);

/// The widest one that the processor and the build have.
InstructionSet widest_instruction_set();

/// Solvers constructed from now on use this one, as far as they are compiled for it, and never a
/// wider one; Solver::instruction_set is the outcome. For the whole process; may be called
/// and read from any thread.
/// @throws std::invalid_argument saying `why_unavailable`
void set_instruction_set(InstructionSet set);

/// The one set last, or the widest one.
InstructionSet instruction_set();

}  // namespace geodesic
