// Checks of what users write on the command line; messages say what is wrong and what to give.
#pragma once

#include <CLI/CLI.hpp>

namespace geodesic::harness {

/// Makes every option of the command refuse empty values, and those that take a number "12abc",
/// "0,5", and for a count "-1", which would otherwise become a large one. Their help shows N for an
/// integer and X for another number.
void check_values(CLI::App& command);

/// Result files keep the command line, and names from it, as JSON.
/// @throws HarnessError when it has a control character, or bytes that are not UTF-8
void require_text(const std::string& command_line);

/// For CLI::Option::check, of an option that takes a number.
CLI::Validator above_zero();
CLI::Validator zero_or_above();
CLI::Validator from_to(int least, int most);

}  // namespace geodesic::harness
