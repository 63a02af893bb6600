#include "solvers/core/instruction_set.h"

#define HWY_DISABLED_TARGETS HWY_AVX3_DL  // here it is AVX-512, as in the kernels
#include <hwy/targets.h>

#include <atomic>
#include <cstdint>
#include <stdexcept>

namespace geodesic {
namespace {

struct Traits {
  std::string_view name, shown;
  std::int64_t target;  // Highway's constant; 0: the static target where it is narrower than AVX2
};
constexpr Traits traits_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::plain:
      return {"plain", "plain", 0};
    case InstructionSet::avx2:
      return {"avx2", "AVX2", HWY_AVX2};
    default:
      return {"avx512", "AVX-512", HWY_AVX3};
  }
}

// Compiler flags such as -march=native compile everything for another set.
constexpr InstructionSet kStatic = HWY_STATIC_TARGET == HWY_AVX3   ? InstructionSet::avx512
                                   : HWY_STATIC_TARGET == HWY_AVX2 ? InstructionSet::avx2
                                                                   : InstructionSet::plain;

std::atomic<InstructionSet>& chosen() {
  static std::atomic<InstructionSet> set{widest_instruction_set()};
  return set;
}

}  // namespace

std::string_view name_of(InstructionSet set) { return traits_of(set).name; }

std::string why_unavailable(InstructionSet set) {
  const Traits traits = traits_of(set);
  const std::string shown(traits.shown);
  if (set < kStatic) {
    return "this build has no " + shown + " path: its compiler flags demand " +
           std::string(traits_of(kStatic).shown);
  }
  if (set == InstructionSet::plain) return "";
  if (set != kStatic && (HWY_TARGETS & traits.target) == 0) {
    return "this build has no " + shown + " path: its compiler or architecture lacks " + shown;
  }
  static const std::int64_t supported = hwy::SupportedTargets();
  return (supported & traits.target) != 0 ? "" : "this processor has no " + shown;
}

InstructionSet widest_instruction_set() {
  InstructionSet widest = kStatic;
  for (const InstructionSet set : kInstructionSets) {
    if (why_unavailable(set).empty()) widest = set;
  }
  return widest;
}

void set_instruction_set(InstructionSet set) {
  const std::string why = why_unavailable(set);
  if (!why.empty()) throw std::invalid_argument(why);
  chosen() = set;
}

InstructionSet instruction_set() { return chosen(); }

}  // namespace geodesic
