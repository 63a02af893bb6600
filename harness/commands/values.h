// Checks of values on the command line. Messages say what is wrong and what to give.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meshes/avoid.h"

namespace geodesic::harness {

/// Makes every option of the command refuse empty values. Options that take a number also refuse
/// "12abc" and "0,5", and counts refuse "-1", which would otherwise become a large number. The help
/// shows N for an integer and X for another number.
void check_values(CLI::App& command);

/// Checks a command line for result files, which keep it, and names from it, as JSON.
/// @throws HarnessError when it has a control character, or bytes that are not UTF-8
void require_text(const std::string& command_line);

/// Adds --weld [DISTANCE], for the weld of LoadOptions. Before the command line is parsed,
/// `with_weld_distance` adds the distance that is left out.
void add_weld_option(CLI::App& command, std::optional<double>& distance);

/// Returns the words with --weld=0 for each --weld that no number follows: the next word is then a
/// file, or another option.
std::vector<std::string> with_weld_distance(std::vector<std::string> words);

/// Adds --cross-non-manifold, for the non_manifold_edges of LoadOptions.
void add_crossing_option(CLI::App& command, bool& crosses);

/// The files of --avoid and --avoid-faces; empty for none.
struct AvoidedFiles {
  std::string vertices, faces;
};

/// Adds --avoid FILE and --avoid-faces FILE, for Avoided.
void add_avoid_options(CLI::App& command, AvoidedFiles& files);

/// Reads the files. @throws HarnessError as read_numbers
Avoided read_avoided(const AvoidedFiles& files);

/// Checks that an output file is none of the files that a command reads.
/// @param flag option that names the output; it may be empty
/// @param inputs for each its option, or "mesh", and the file, empty for none
/// @throws HarnessError
void check_output_differs(const std::string& flag, const std::string& output,
                          const std::vector<std::pair<std::string, std::filesystem::path>>& inputs);

/// Validators for CLI::Option::check of an option that takes a number.
CLI::Validator above_zero();
CLI::Validator zero_or_above();
CLI::Validator from_to(int least, int most);

}  // namespace geodesic::harness
