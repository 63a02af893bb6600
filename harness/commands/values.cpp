#include "harness/commands/values.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>

#include "harness/base/error.h"
#include "harness/corpus/points.h"
#include "solvers/core/number_text.h"

namespace geodesic::harness {
namespace {

std::string in_quotes(const std::string& word) { return "'" + word + "' "; }

// Empty if the word is an integer.
template <class Integer>
std::string why_no_integer(const std::string& word) {
  if (number_in<Integer>(word)) return {};
  const bool digits = word.find_first_not_of("0123456789") == std::string::npos;
  if (digits) return in_quotes(word) + "is too large";
  return in_quotes(word) +
         (std::is_signed_v<Integer> ? "is not an integer" : "is not a non-negative integer");
}

std::string why_no_number(const std::string& word) {
  const std::optional<double> number = number_in<double>(word);
  if (number && !std::isnan(*number)) return {};
  return in_quotes(word) + "is not a number, such as 0.5 or 1e-3";
}

CLI::Validator number_that(const std::function<bool(double)>& holds, const std::string& words) {
  const auto check = [holds, words](const std::string& word) {
    const std::string why = why_no_number(word);
    const double number = number_in<double>(word).value_or(0);
    return !why.empty() || holds(number) ? why : in_quotes(word) + "is not " + words;
  };
  return {[check](std::string& word) { return check(word); }, ""};
}

struct Type {
  std::string shown;  // in help; empty for CLI11's own text
  std::string (*check)(const std::string& word);
};

// Finds a type by CLI11's name for it.
Type type_of(const std::string& name) {
  if (name.starts_with("UINT")) return {"N", why_no_integer<std::uint64_t>};
  if (name.starts_with("INT")) return {"N", why_no_integer<int>};
  if (name.starts_with("FLOAT")) return {"X", why_no_number};
  return {"", [](const std::string&) -> std::string { return {}; }};
}

}  // namespace

void check_values(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    const Type type = type_of(option->get_type_name());
    if (!type.shown.empty()) option->type_name(type.shown);
    option->check([check = type.check](const std::string& word) {
      return word.empty() ? "must not be empty" : check(word);
    });
  }
}

void require_text(const std::string& command_line) {
  if (harmless(command_line) == command_line) return;
  throw HarnessError(
      "a word of the command line has a control character, or bytes that are not UTF-8, which no "
      "result file can hold: rename the file or folder");
}

void add_crossing_option(CLI::App& command, bool& crosses) {
  command.add_flag(
      "--cross-non-manifold", crosses,
      "paths go from a face into each of the others at an edge of more than two faces, "
      "and at one between inconsistently oriented faces; --repair does not cut them "
      "then");
}

void check_output_differs(
    const std::string& flag, const std::string& output,
    const std::vector<std::pair<std::string, std::filesystem::path>>& inputs) {
  for (const auto& [name, input] : inputs) {
    std::error_code other;
    if (output.empty() || input.empty() || !std::filesystem::equivalent(output, input, other)) {
      continue;
    }
    if (!std::filesystem::is_regular_file(output, other)) continue;  // a device holds nothing
    throw HarnessError(flag + " '" + output + "' is the " +
                       (name == "mesh" ? "mesh itself" : "file of " + name) +
                       ": results go to a file of their own");
  }
}

CLI::Validator above_zero() {
  return number_that([](double x) { return x > 0; }, "greater than 0");
}

void add_weld_option(CLI::App& command, std::optional<double>& distance) {
  command
      .add_option("--weld", distance,
                  "join the vertices at the same place, or within DISTANCE of each other, so that "
                  "paths cross seams; all numbers stay those of the file")
      ->check(number_that([](double x) { return x >= 0 && std::isfinite(x); }, "0 or greater"))
      ->type_name("[DISTANCE]");
}

std::vector<std::string> with_weld_distance(std::vector<std::string> words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != "--weld") continue;
    if (i + 1 == words.size() || !number_in<double>(words[i + 1])) words[i] += "=0";
  }
  return words;
}

void add_avoid_options(CLI::App& command, AvoidedFiles& files) {
  command
      .add_option("--avoid", files.vertices,
                  "file of the numbers of vertices that paths may not enter: all their faces are "
                  "left out, and numbers stay those of the file; a JSON list, or text")
      ->type_name("FILE");
  command
      .add_option("--avoid-faces", files.faces,
                  "file of the numbers of faces that paths may not enter, in the same formats")
      ->type_name("FILE");
}

Avoided read_avoided(const AvoidedFiles& files) {
  Avoided avoided;
  if (!files.vertices.empty()) avoided.vertices = read_numbers(files.vertices, "--avoid");
  if (!files.faces.empty()) avoided.faces = read_numbers(files.faces, "--avoid-faces");
  return avoided;
}

CLI::Validator zero_or_above() {
  return number_that([](double x) { return x >= 0; }, "0 or greater");
}

CLI::Validator from_to(int least, int most) {
  return number_that([=](double x) { return x >= least && x <= most; },
                     "between " + std::to_string(least) + " and " + std::to_string(most));
}

}  // namespace geodesic::harness
