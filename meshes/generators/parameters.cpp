#include "meshes/generators/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace geodesic {
namespace {

/// The fewest digits that bring back the number; whole numbers without an exponent.
std::string number_text(double number) {
  char buffer[32];
  char* const end = buffer + sizeof buffer;
  const bool is_short_whole = number == std::floor(number) && std::abs(number) < 1e15;
  const auto written = is_short_whole ? std::to_chars(buffer, end, number, std::chars_format::fixed)
                                      : std::to_chars(buffer, end, number);
  return {buffer, written.ptr};
}

/// The whole of `text` as a finite number.
std::optional<double> parse_number(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

bool in_range(const ParameterDescription& parameter, double number) {
  const bool whole = parameter.kind != ParameterKind::integer || number == std::floor(number);
  return whole && parameter.least <= number && number <= parameter.greatest;
}

bool is_among_choices(const ParameterDescription& parameter, const std::string& word) {
  return std::count(parameter.choices.begin(), parameter.choices.end(), word) != 0;
}

bool is_acceptable(const ParameterDescription& parameter, const std::string& text) {
  if (parameter.kind == ParameterKind::file) return !text.empty();
  if (parameter.kind == ParameterKind::choice) return is_among_choices(parameter, text);
  if (parameter.kind == ParameterKind::words) {
    const std::vector<std::string> words = split(text);
    return std::all_of(words.begin(), words.end(),
                       [&](const std::string& word) { return is_among_choices(parameter, word); });
  }
  const std::optional<double> number = parse_number(text);
  return number && in_range(parameter, *number);
}

std::variant<double, std::string> check(std::string_view owner,
                                        const ParameterDescription& parameter,
                                        const ParameterValue& value) {
  if (is_acceptable(parameter, value.text())) {
    if (parameter.is_number()) return *parse_number(value.text());
    return value.text();
  }
  throw std::invalid_argument(std::string(owner) + ": parameter " + parameter.name + " is '" +
                              value.text() + "'; it must be " + parameter.range());
}

}  // namespace

std::string ParameterValue::shortest_text(double number) { return number_text(number); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::vector<std::string> split(std::string_view text) {
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

std::string ParameterDescription::range() const {
  if (kind == ParameterKind::file) return "a file";
  if (kind == ParameterKind::words)
    return "one or more of " + listed(choices) + ", separated by commas";
  if (kind == ParameterKind::choice) return "one of " + listed(choices);
  return (kind == ParameterKind::integer ? "an integer from " : "a number from ") +
         number_text(least) + " to " + number_text(greatest);
}

ParameterDescription integer_parameter(std::string name, Index default_value, Index least,
                                       Index greatest, std::string description) {
  return {.name = std::move(name),
          .description = std::move(description),
          .kind = ParameterKind::integer,
          .default_value = default_value,
          .least = static_cast<double>(least),
          .greatest = static_cast<double>(greatest)};
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
  return {.name = std::move(name),
          .description = std::move(description),
          .kind = ParameterKind::choice,
          .default_value = choices.front(),
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
                                     const GeneratorParameters& given) {
  std::vector<std::string> names;
  for (const ParameterDescription& parameter : descriptions) {
    const auto found = given.find(parameter.name);
    if (found == given.end() && parameter.is_required())
      throw std::invalid_argument(std::string(owner) + ": needs --" + parameter.name + ", " +
                                  parameter.description);
    const ParameterValue& value = found == given.end() ? parameter.default_value : found->second;
    values_.emplace(parameter.name, check(owner, parameter, value));
    names.push_back(parameter.name);
  }
  for (const auto& [name, value] : given) {
    if (values_.contains(name)) continue;
    throw std::invalid_argument(std::string(owner) + ": no parameter '" + name + "'; it takes " +
                                listed(names));
  }
}

double CheckedParameters::real(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end() || !std::holds_alternative<double>(found->second))
    throw std::logic_error("no number parameter " + std::string(name));
  return std::get<double>(found->second);
}

const std::string& CheckedParameters::text(std::string_view name) const {
  const auto found = values_.find(name);
  if (found == values_.end() || !std::holds_alternative<std::string>(found->second))
    throw std::logic_error("no text parameter " + std::string(name));
  return std::get<std::string>(found->second);
}

}  // namespace geodesic
