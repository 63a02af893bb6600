#include "solvers/core/instruction_set.h"

#include <hwy/targets.h>

#include <atomic>
#include <stdexcept>

namespace geodesic {
namespace {

// Compiler flags such as -march=native make AVX2 what everything is compiled for.
constexpr bool kOnlyAvx2 = HWY_STATIC_TARGET == HWY_AVX2 || HWY_STATIC_TARGET == HWY_AVX3 ||
                           HWY_STATIC_TARGET == HWY_AVX3_DL;
constexpr bool kBuiltForAvx2 = kOnlyAvx2 || (HWY_TARGETS & HWY_AVX2) != 0;

bool processor_has_avx2() {
  static const bool has = (hwy::SupportedTargets() & HWY_AVX2) != 0;
  return has;
}

std::atomic<InstructionSet>& chosen() {
  static std::atomic<InstructionSet> set{widest_instruction_set()};
  return set;
}

}  // namespace

std::string_view name_of(InstructionSet set) {
  return set == InstructionSet::avx2 ? "avx2" : "plain";
}

std::string why_unavailable(InstructionSet set) {
  if (set == InstructionSet::plain) {
    return kOnlyAvx2 ? "this build has no plain path: its compiler flags demand AVX2" : "";
  }
  if (!kBuiltForAvx2) return "this build has no AVX2 path: its compiler or architecture lacks AVX2";
  return processor_has_avx2() ? "" : "this processor has no AVX2";
}

InstructionSet widest_instruction_set() {
  return why_unavailable(InstructionSet::avx2).empty() ? InstructionSet::avx2
                                                       : InstructionSet::plain;
}

void set_instruction_set(InstructionSet set) {
  const std::string why = why_unavailable(set);
  if (!why.empty()) throw std::invalid_argument(why);
  chosen() = set;
}

InstructionSet instruction_set() { return chosen(); }

}  // namespace geodesic
