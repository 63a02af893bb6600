// The groups of properties, and functions that they share.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "harness/verify/property.h"
#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"

namespace geodesic::harness {

std::vector<Property> query_properties();
std::vector<Property> component_properties();
std::vector<Property> repetition_properties();
std::vector<Property> recording_properties();
std::vector<Property> invariance_properties();
std::vector<Property> closed_form_properties();
std::vector<Property> unclean_mesh_properties();
std::vector<Property> extreme_mesh_properties();
std::vector<Property> rough_mesh_properties();
std::vector<Property> path_properties();
std::vector<Property> sheet_properties();

using Cases = std::vector<Case>;

Cases one(const std::string& name, const TriangleSoup& soup, const Query& query);

template <class... Each>
Cases cases_of(const Each&... each) {
  return {each...};
}

/// The random meshes for every solver, each with these queries.
Cases random_mesh_cases(const std::vector<Query>& queries);

/// Queries from vertex 0, from the vertex with half the largest number, and from the last vertex.
std::vector<Query> some_sources(const TriangleSoup& soup);
/// The random meshes, each with some_sources.
Cases random_meshes_from_some_sources();
/// The random meshes, each with a query from four vertices, two of them usually neighbours.
Cases random_meshes_from_four_sources();
std::vector<Query> every_source(const TriangleSoup& soup);

/// Books, surfaces with fins and one-sided surfaces. Paths cross their non-manifold edges.
Cases surfaces_of_several_sheets();

/// A generated mesh with distances in closed form.
/// @param sources empty: every vertex
Case closed_form_case(const std::string& generator, const GeneratorParameters& parameters,
                      const std::vector<Index>& sources = {});

/// A convex piece of a plane: distances are straight lines.
/// @param flat the same mesh before a rotation, if any, that rounded its coordinates
Case plane_case(const std::string& name, const TriangleSoup& soup,
                const std::vector<Query>& queries, const TriangleSoup& flat);

/// Multiplies every coordinate by a factor.
TriangleSoup scaled(TriangleSoup soup, double factor);

/// The query with another limit.
Query within(double limit, Query query);

/// How often this thread has called `require` and `refused`. A check that has called neither has
/// compared nothing.
std::uint64_t requirements();

/// Counts a requirement that is not checked by `require`.
void count_requirement();

/// Throws the violation, if there is one, to end the check of a property.
void require(Finding finding);
void require(const std::string& circumstances, Finding finding);

/// Throws a violation unless `holds`. @param otherwise its text
void require(bool holds, const std::string& otherwise);

Finding same_bits(const Query& query, std::span<const double> got,
                  std::span<const double> expected);

/// Requires that the call throws std::invalid_argument. @param what subject of "... was accepted"
template <class Call>
void refused(const std::string& what, Call&& call) {
  count_requirement();
  try {
    call();
  } catch (const std::invalid_argument&) {
    return;
  }
  throw Violation{.what = what + " was accepted"};
}

}  // namespace geodesic::harness
