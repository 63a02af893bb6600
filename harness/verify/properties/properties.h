// The properties by what they are about, each group in a file of its own, cheap ones first.
#pragma once

#include <stdexcept>

#include "harness/verify/property.h"
#include "meshes/oracles/random_meshes.h"

namespace geodesic::conformance {

std::vector<Property> query_properties();
std::vector<Property> component_properties();
std::vector<Property> repetition_properties();
std::vector<Property> recording_properties();
std::vector<Property> invariance_properties();
std::vector<Property> instruction_set_properties();
std::vector<Property> closed_form_properties();
std::vector<Property> non_manifold_properties();
std::vector<Property> degenerate_properties();
std::vector<Property> extreme_properties();
std::vector<Property> random_mesh_properties();
std::vector<Property> rival_properties();

// What properties share.

inline constexpr Claim kExactDistances{
    "exact distances", [](const Description& d) { return d.exactness == Exactness::exact; }};
inline constexpr Claim kMultipleSources{
    "multiple sources", [](const Description& d) { return d.abilities.multiple_sources; }};
inline constexpr Claim kInitialDistances{
    "initial distances", [](const Description& d) { return d.abilities.initial_distances; }};
inline constexpr Claim kDistanceLimit{
    "a distance limit", [](const Description& d) { return d.abilities.distance_limit; }};
inline constexpr Claim kFinalWindows{"windows that it keeps",
                                     [](const Description& d) { return d.final_windows; }};
inline constexpr Claim kNoFinalWindows{"to keep no windows",
                                       [](const Description& d) { return !d.final_windows; }};

/// Every distance, by one solver object for all queries, is the expected one; along every edge they
/// differ by no more than it is long.
Finding distances_are_right(const Trial& trial);

/// A failure unless the call throws std::invalid_argument.
/// @param what was accepted then
template <class Call>
Finding refused(const std::string& what, Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument&) {
    return {};
  }
  return Failure{.what = what + " was accepted"};
}

/// The random meshes for every solver, each with these queries.
std::vector<Case> random_mesh_cases(const std::vector<Query>& queries);

/// Vertex 0, one in the middle, the last one.
std::vector<Query> some_sources(const TriangleSoup& soup);

/// From the first source to every vertex, through space.
std::vector<double> straight_lines(const TriangleSoup& soup, const Query& query);

}  // namespace geodesic::conformance
