// The properties in groups, and what they share.
#pragma once

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

/// From vertex 0, one in the middle, and the last one.
std::vector<Query> some_sources(const TriangleSoup& soup);
/// The random meshes, each with some_sources.
Cases random_meshes_from_some_sources();
/// The random meshes, each with a query from four vertices, two of them neighbours as a rule.
Cases random_meshes_from_four_sources();
std::vector<Query> every_source(const TriangleSoup& soup);

/// Books, surfaces with fins and such of one side, whose non-manifold edges paths cross.
Cases surfaces_of_several_sheets();

/// A generated mesh with distances in closed form.
/// @param sources empty: every vertex
Case closed_form_case(const std::string& generator, const GeneratorParameters& parameters,
                      const std::vector<Index>& sources = {});

/// A convex piece of a plane: distances are straight lines.
/// @param flat the same mesh, before a rotation rounded its coordinates if there was one
Case plane_case(const std::string& name, const TriangleSoup& soup,
                const std::vector<Query>& queries, const TriangleSoup& flat);

/// With every coordinate times a factor.
TriangleSoup scaled(TriangleSoup soup, double factor);

/// The query with another limit.
Query within(double limit, Query query);

/// Ends the check of a property with what was found, if anything was.
void require(Finding finding);
void require(const std::string& circumstances, Finding finding);

/// The same unless the statement holds. @param otherwise what to say then
void require(bool holds, const std::string& otherwise);

Finding same_bits(const Query& query, std::span<const double> got,
                  std::span<const double> expected);

/// Requires that the call throws std::invalid_argument. @param what is accepted otherwise
template <class Call>
void refused(const std::string& what, Call&& call) {
  try {
    call();
  } catch (const std::invalid_argument&) {
    return;
  }
  throw Violation{.what = what + " was accepted"};
}

}  // namespace geodesic::harness
