// Parameters of generators and solvers: their descriptions and values.
#pragma once

#include <concepts>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// A parameter's value as text, as on a command line. Numbers convert without loss.
class ParameterValue {
 public:
  ParameterValue(const char* text) : text_(text) {}
  ParameterValue(std::string text) : text_(std::move(text)) {}
  template <typename Number>
  requires(std::integral<Number> || std::floating_point<Number>) ParameterValue(Number number)
      : text_(shortest_text(static_cast<double>(number))) {}

  const std::string& text() const { return text_; }

 private:
  static std::string shortest_text(double number);
  std::string text_;
};

/// Values, by parameter name.
using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

/// `words`: one or more of the choices, separated by commas. `file`: a path; has no default.
enum class ParameterKind { integer, real, choice, words, file };

struct ParameterDescription {
  std::string name;  ///< lower case with hyphens: "tube-radius"
  std::string description;
  ParameterKind kind = ParameterKind::integer;
  ParameterValue default_value = 0;
  double least = 0;  ///< closed range of a number: its lower end
  double greatest = 0;
  std::vector<std::string> choices = {};  ///< allowed words of a choice

  bool is_number() const { return kind == ParameterKind::integer || kind == ParameterKind::real; }
  bool is_required() const { return kind == ParameterKind::file; }
  /// "an integer from 1 to 9", "a number from 0.1 to 2", "one of forward, backward", "a file"
  std::string range() const;
};

ParameterDescription integer_parameter(std::string name, Index default_value, Index least,
                                       Index greatest, std::string description);
ParameterDescription real_parameter(std::string name, double default_value, double least,
                                    double greatest, std::string description);
/// The first choice is the default. The same holds for words_parameter.
ParameterDescription choice_parameter(std::string name, std::vector<std::string> choices,
                                      std::string description);
ParameterDescription words_parameter(std::string name, std::vector<std::string> choices,
                                     std::string description);
ParameterDescription file_parameter(std::string name, std::string description);

/// The values of all parameters, complete and in range.
class CheckedParameters {
 public:
  /// @param owner the name of the generator or solver, for messages
  /// @throws std::invalid_argument for an unknown parameter, a missing file and a value out of
  ///         range
  CheckedParameters(std::string_view owner, const std::vector<ParameterDescription>& descriptions,
                    const ParameterValues& given);

  /// Value of a parameter. A name without a description is a programming error (std::out_of_range).
  Index integer(std::string_view name) const { return static_cast<Index>(real(name)); }
  double real(std::string_view name) const;
  /// Text of a choice or a file; a number in its shortest form.
  const std::string& text(std::string_view name) const;
  std::vector<std::string> words(std::string_view name) const;

 private:
  std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace geodesic
