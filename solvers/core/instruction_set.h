// The vector instructions that solvers use.
//
// A solver may be compiled for several instruction sets, all of which give the same bits. When it
// is constructed, it selects the widest set that the processor has, or the one chosen here.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace geodesic {

enum class InstructionSet : std::uint8_t {
  plain,  ///< available on every processor of the architecture: SSE2 on x86-64
  avx2,
  avx512,  ///< the subsets F, BW, CD, DQ and VL
};
/// From the narrowest to the widest.
inline constexpr std::array kInstructionSets{InstructionSet::plain, InstructionSet::avx2,
                                             InstructionSet::avx512};

/// "plain", "avx2", "avx512"
std::string_view name_of(InstructionSet set);

/// The reason why this processor or build cannot run solvers with `set`; empty when it can.
std::string why_unavailable(InstructionSet set);

/// The widest set that both the processor and the build support.
InstructionSet widest_instruction_set();

/// Solvers constructed from now on use this set, as far as they are compiled for it, and never a
/// wider one; Solver::instruction_set returns the outcome. Applies to the whole process; may be
/// called and read from any thread.
/// @throws std::invalid_argument with the text of `why_unavailable`
void set_instruction_set(InstructionSet set);

/// The set chosen last, or the widest one.
InstructionSet instruction_set();

}  // namespace geodesic
