#include "harness/commands/values.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace geodesic::harness {
namespace {

std::string quoted(const std::string& word) { return "'" + word + "' "; }

// Whether all of the word is a number, in decimals and with a point, whatever the locale.
template <class Number>
bool parse(const std::string& word, Number& number) {
  const char* const end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && rest == end;
}

// Empty when it is one.
template <class Integer>
std::string why_no_integer(const std::string& word) {
  Integer integer = 0;
  if (parse(word, integer)) return {};
  const bool digits = word.find_first_not_of("0123456789") == std::string::npos;
  if (digits) return quoted(word) + "is too large";
  return quoted(word) +
         (std::is_signed_v<Integer> ? "is no whole number" : "is no whole number of 0 or more");
}

std::string why_no_number(const std::string& word) {
  double number = 0;
  if (parse(word, number) && !std::isnan(number)) return {};
  return quoted(word) + "is no number, such as 0.5 or 1e-3";
}

CLI::Validator number_that(bool (*holds)(double), const std::string& words) {
  const auto check = [holds, words](const std::string& word) {
    const std::string why = why_no_number(word);
    double number = 0;
    parse(word, number);
    return !why.empty() || holds(number) ? why : quoted(word) + "is not " + words;
  };
  return {[check](std::string& word) { return check(word); }, ""};
}

std::string (*check_of(const std::string& type))(const std::string& word) {
  if (type.starts_with("UINT")) return why_no_integer<std::uint64_t>;
  if (type.starts_with("INT")) return why_no_integer<int>;
  if (type.starts_with("FLOAT")) return why_no_number;
  return [](const std::string&) -> std::string { return {}; };
}

}  // namespace

void check_values(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    option->check([check = check_of(option->get_type_name())](const std::string& word) {
      return word.empty() ? "must not be empty" : check(word);
    });
  }
}

CLI::Validator above_zero() {
  return number_that([](double x) { return x > 0; }, "above 0");
}

CLI::Validator zero_or_above() {
  return number_that([](double x) { return x >= 0; }, "0 or above");
}

}  // namespace geodesic::harness
