#include "solvers/core/parameters.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "solvers/core/messages.h"
#include "solvers/core/number_text.h"

namespace geodesic {
namespace {

std::optional<double> finite_number_in(const std::string& text) {
  const std::optional<double> number = number_in<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::vector<std::string> split_at_commas(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ',') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

bool is_acceptable(const ParameterDescription& parameter, const std::string& text) {
  const auto is_choice = [&](const std::string& word) {
    return std::ranges::count(parameter.choices, word) != 0;
  };
  switch (parameter.kind) {
    case ParameterKind::file:
      return !text.empty();
    case ParameterKind::choice:
      return is_choice(text);
    case ParameterKind::words:
      return std::ranges::all_of(split_at_commas(text), is_choice);
    default:
      const std::optional<double> number = finite_number_in(text);
      if (!number) return false;
      if (parameter.kind == ParameterKind::integer && *number != std::floor(*number)) return false;
      return parameter.least <= *number && *number <= parameter.greatest;
  }
}

}  // namespace

/// The fewest digits that reproduce the number: "8", "0.25", "1e-4".
std::string ParameterValue::shortest_text(double number) {
  number += 0.0;  // not -0
  char buffer[32];
  char* const end = buffer + sizeof buffer;
  const bool is_short_whole = number == std::floor(number) && std::abs(number) < 1e15;
  const auto written = is_short_whole ? std::to_chars(buffer, end, number, std::chars_format::fixed)
                                      : std::to_chars(buffer, end, number);
  std::string text(buffer, written.ptr);
  const std::size_t exponent = text.find('e');  // "1e-04", "1e+20"
  if (exponent == std::string::npos) return text;
  const std::size_t sign = text[exponent + 1] == '-' ? 1 : 0;
  const std::size_t digits = text.find_first_not_of("+-0", exponent + 1);
  return text.replace(exponent + 1 + sign, digits - exponent - 1 - sign, "");
}

std::string ParameterDescription::range() const {
  if (kind == ParameterKind::file) return "a file";
  if (kind == ParameterKind::words) {
    return "one or more of " + join(choices) + ", separated by commas";
  }
  if (kind == ParameterKind::choice) return "one of " + join(choices);
  return (kind == ParameterKind::integer ? "an integer from " : "a number from ") +
         ParameterValue(least).text() + " to " + ParameterValue(greatest).text();
}

ParameterDescription integer_parameter(std::string name, Index default_value, Index least,
                                       Index greatest, std::string description) {
  ParameterDescription parameter =
      real_parameter(std::move(name), default_value, least, greatest, std::move(description));
  parameter.kind = ParameterKind::integer;
  return parameter;
}

ParameterDescription real_parameter(std::string name, double default_value, double least,
                                    double greatest, std::string description) {
  return {.name = std::move(name),
          .description = std::move(description),
          .kind = ParameterKind::real,
          .default_value = default_value,
          .least = least,
          .greatest = greatest};
}

ParameterDescription choice_parameter(std::string name, std::vector<std::string> choices,
                                      std::string description) {
  std::string first = choices.front();
  return {.name = std::move(name),
          .description = std::move(description),
          .kind = ParameterKind::choice,
          .default_value = std::move(first),
          .choices = std::move(choices)};
}

ParameterDescription words_parameter(std::string name, std::vector<std::string> choices,
                                     std::string description) {
  ParameterDescription parameter =
      choice_parameter(std::move(name), std::move(choices), std::move(description));
  parameter.kind = ParameterKind::words;
  return parameter;
}

ParameterDescription file_parameter(std::string name, std::string description) {
  return {.name = std::move(name),
          .description = std::move(description),
          .kind = ParameterKind::file,
          .default_value = ""};
}

CheckedParameters::CheckedParameters(std::string_view owner,
                                     const std::vector<ParameterDescription>& descriptions,
                                     const ParameterValues& given) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument(std::string(owner) + ": " + why);
  };
  std::vector<std::string> names;
  for (const ParameterDescription& parameter : descriptions) {
    const auto found = given.find(parameter.name);
    if (found == given.end() && parameter.is_required()) {
      refuse("needs --" + parameter.name + ", " + parameter.description);
    }
    const std::string& text =
        (found == given.end() ? parameter.default_value : found->second).text();
    if (!is_acceptable(parameter, text)) {
      refuse("parameter " + parameter.name + " is '" + text + "'; it must be " + parameter.range());
    }
    texts_.emplace(parameter.name,
                   parameter.is_number() ? ParameterValue(*finite_number_in(text)).text() : text);
    names.push_back(parameter.name);
  }
  for (const auto& [name, value] : given) {
    if (!texts_.contains(name)) refuse(unknown_name("parameter", name, names));
  }
}

double CheckedParameters::real(std::string_view name) const {
  return *finite_number_in(text(name));
}

const std::string& CheckedParameters::text(std::string_view name) const {
  const auto found = texts_.find(name);
  if (found == texts_.end()) throw std::out_of_range("no parameter " + std::string(name));
  return found->second;
}

std::vector<std::string> CheckedParameters::words(std::string_view name) const {
  return split_at_commas(text(name));
}

}  // namespace geodesic
