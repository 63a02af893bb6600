// How a cell can end.
#pragma once

#include <array>
#include <string_view>

#include "harness/base/error.h"

namespace geodesic::harness {

/// `outcome` of a row (results/README.md).
enum class Outcome {
  ok,
  wrong_answer,
  unsupported,
  out_of_memory,
  time_out,
  crashed,
  error,
  skipped,  ///< after a failure from another source of solver and mesh
};

/// In the order of Outcome.
inline constexpr std::array<std::string_view, 8> kOutcomeNames{
    "ok",       "wrong answer", "unsupported", "out of memory",
    "time-out", "crashed",      "error",       "skipped"};

/// What a suite may declare as expected of a cell.
inline constexpr std::array kExpectable{Outcome::unsupported, Outcome::out_of_memory,
                                        Outcome::time_out, Outcome::crashed, Outcome::error};

constexpr std::string_view name_of(Outcome outcome) {
  return kOutcomeNames[static_cast<std::size_t>(outcome)];
}

/// @throws HarnessError for a word that is not an outcome
inline Outcome outcome_named(std::string_view word) {
  return static_cast<Outcome>(&named("outcome", kOutcomeNames, word) - kOutcomeNames.data());
}

}  // namespace geodesic::harness
