// Checks of values on the command line. Messages say what is wrong and what to give.
#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// Makes every option of the command refuse empty values. Options that take a number also refuse
/// "12abc" and "0,5", and counts refuse "-1", which would otherwise become a large number. The help
/// shows N for an integer and X for another number.
void check_values(CLI::App& command);

/// Checks a command line for result files, which keep it, and names from it, as JSON.
/// @throws HarnessError when it has a control character, or bytes that are not UTF-8
void require_text(const std::string& command_line);

/// Validators for CLI::Option::check of an option that takes a number.
CLI::Validator above_zero();
CLI::Validator zero_or_above();
CLI::Validator from_to(int least, int most);

}  // namespace geodesic::harness
