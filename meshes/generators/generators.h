// Generates meshes from a name and parameters, for `geodesic-bench generate` and the manifest.
//
// The same name and parameters give the same bits on every run and every x86-64 machine. Generators
// use only the operations that IEEE 754 rounds correctly (+ - * / sqrt), their own sine and cosine
// (families.h) and their own random numbers (random.h), compiled without contraction. Loop's
// weights come from OpenMesh, which uses the C library's cosine of 2 pi / valence. This cosine is
// correctly rounded for valences below 200, with and without fused multiply-add.
//
// To add a generator, add a family to a source file of this folder, or of meshes/editing if it
// edits the mesh of a file, and to the table in generators.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/core/parameters.h"

namespace geodesic {

/// Parameter values, by name.
using GeneratorParameters = ParameterValues;

/// Description of a generator, as `geodesic-bench generate --list` prints it.
struct GeneratorDescription {
  std::string name;                              ///< lower case with hyphens: "torus-knot"
  std::string description;                       ///< shape, counts and unit of length
  std::string closed_form = {};                  ///< formula of geodesic distances, or empty
  std::vector<ParameterDescription> parameters;  ///< all but files have a default
};

/// All generators, by name.
const std::vector<GeneratorDescription>& generator_descriptions();

/// Generates a mesh. Faces are counter-clockwise seen from outside (closed surfaces) or from above,
/// or oriented as in the input file.
/// @param parameters values by name; missing ones have their defaults
/// @param remarks if not null, receives one line for each change to the mesh of an input file
/// @throws std::invalid_argument with one line, listing what exists, for an unknown generator, an
///         unknown parameter, a value out of range, or a mesh with more elements than an Index
///         can number
/// @throws MeshError with one line for an input file that is missing or not usable
TriangleSoup generate(std::string_view name, const GeneratorParameters& parameters = {},
                      std::vector<std::string>* remarks = nullptr);

/// Returns geodesic distances from a vertex to all vertices, in the unit of the positions, to the
/// last bit or two: reference values for solvers. Each family has its formula and its source.
/// @param soup the result of `generate(name, parameters)`
/// @return nothing if the generator has no closed form (`GeneratorDescription::closed_form`)
/// @throws std::invalid_argument for the reasons of `generate`, and if `soup` is another mesh or
///         has no such source vertex
std::optional<std::vector<double>> known_distances(std::string_view name,
                                                   const GeneratorParameters& parameters,
                                                   const TriangleSoup& soup, Index source);

}  // namespace geodesic
