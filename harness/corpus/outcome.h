// The outcomes of a cell.
#pragma once

#include <array>
#include <string_view>

#include "harness/base/error.h"
#include "harness/base/json.h"

namespace geodesic::harness {

/// The `outcome` of a row (results/README.md).
enum class Outcome {
  ok,
  wrong_answer,
  unsupported,
  out_of_memory,
  time_out,
  crashed,
  error,
  skipped,  ///< after a failure of the same solver and mesh from another source
};

/// Names in the order of Outcome.
inline constexpr std::array<std::string_view, 8> kOutcomeNames{
    "ok",       "wrong answer", "unsupported", "out of memory",
    "time-out", "crashed",      "error",       "skipped"};

constexpr std::string_view name_of(Outcome outcome) {
  return kOutcomeNames[static_cast<std::size_t>(outcome)];
}

/// @throws HarnessError for a word that is not an outcome
inline Outcome outcome_named(std::string_view word) {
  return static_cast<Outcome>(&named("outcome", kOutcomeNames, word) - kOutcomeNames.data());
}

inline void to_json(Json& json, Outcome outcome) { json = name_of(outcome); }
inline void from_json(const Json& json, Outcome& outcome) {
  outcome = outcome_named(json.get<std::string>());
}

}  // namespace geodesic::harness
