// What the values of options must be, in words that say what is wrong with one and what to give.
#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// Every option of the command refuses a value that is empty, and one that takes a number what is
/// none: "12abc", "0,5", and for a count "-1", which would otherwise become a large one.
void check_values(CLI::App& command);

/// For CLI::Option::check, of an option that takes a number.
CLI::Validator above_zero();
CLI::Validator zero_or_above();

}  // namespace geodesic::harness
