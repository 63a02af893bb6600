// Meshes made from a name and parameters: what `geodesic-bench generate` and the manifest use.
//
// The same name and parameters give the same bits on every run and every x86-64 machine: generators
// use only the operations that IEEE 754 rounds correctly (+ - * / sqrt), their own sine and cosine
// (families.h) and their own random numbers (random.h), compiled without contraction.
//
// To add a generator, add a family to a source file of this folder and to the table in
// generators.cpp.
#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

/// A parameter's value as it is written on a command line; numbers convert without loss.
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

/// Values by the parameters' names.
using GeneratorParameters = std::map<std::string, ParameterValue, std::less<>>;

/// `words` is one or more of the choices, separated by commas; `file` a path, without a default.
enum class ParameterKind { integer, real, choice, words, file };

struct ParameterDescription {
  std::string name;  ///< lower case with hyphens: "tube-radius"
  std::string description;
  ParameterKind kind = ParameterKind::integer;
  ParameterValue default_value = 0;
  double least = 0;  ///< closed range of a number
  double greatest = 0;
  std::vector<std::string> choices = {};  ///< the words that a choice may be

  bool is_number() const { return kind == ParameterKind::integer || kind == ParameterKind::real; }
  bool is_required() const { return kind == ParameterKind::file; }
  /// "an integer from 1 to 9", "a number from 0.1 to 2", "one of forward, backward", "a file"
  std::string range() const;
};

/// A generator as data: what `geodesic-bench generate --list` prints.
struct GeneratorDescription {
  std::string name;                              ///< lower case with hyphens: "torus-knot"
  std::string description;                       ///< shape, counts and unit of length
  std::string closed_form = {};                  ///< geodesic distances in closed form, or empty
  std::vector<ParameterDescription> parameters;  ///< all but files have a default
};

/// All generators, by name.
const std::vector<GeneratorDescription>& generator_descriptions();

/// Makes a mesh; faces are counter-clockwise seen from outside (closed surfaces) or from above, or
/// as they are in the file that the mesh is made from.
/// @param parameters those not named take their defaults
/// @param remarks set, where given, to one line for each thing done to an input file's mesh
/// @throws std::invalid_argument with one line, listing what exists, for an unknown generator, an
///         unknown parameter, a value out of range, or a mesh with more elements than an Index
///         can number
/// @throws MeshError with one line for an input file that is missing or not usable
TriangleSoup generate(std::string_view name, const GeneratorParameters& parameters = {},
                      std::vector<std::string>* remarks = nullptr);

/// Geodesic distances from a vertex to all vertices, in the unit of the positions, to the last bit
/// or two: reference values for solvers. The formulas and their sources are beside each family.
/// @param soup what `generate(name, parameters)` gives
/// @return nothing when the generator has no closed form (`GeneratorDescription::closed_form`)
/// @throws std::invalid_argument as `generate`, and when `soup` is another mesh or has no such
///         source vertex
std::optional<std::vector<double>> known_distances(std::string_view name,
                                                   const GeneratorParameters& parameters,
                                                   const TriangleSoup& soup, Index source);

}  // namespace geodesic
