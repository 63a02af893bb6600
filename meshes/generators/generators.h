// Meshes made from a name and parameters: what `geodesic-bench generate` and the manifest use.
//
// The same name and parameters give the same bits on every run and every x86-64 machine: generators
// use only the operations that IEEE 754 rounds correctly (+ - * / sqrt), their own sine and cosine
// (families.h) and their own random numbers (random.h), compiled without contraction. Loop's
// weights come from OpenMesh, by the C library's cosine of 2 pi / valence, which is the correctly
// rounded one for valences below 200 with fused multiply-add and without.
//
// To add a generator, add a family to a source file of this folder, or of meshes/editing where it
// edits the mesh of a file, and to the table in generators.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/core/parameters.h"

namespace geodesic {

/// Values by the parameters' names.
using GeneratorParameters = ParameterValues;

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
