// What every solver is held to, as data: a property says one thing about answers, knows the meshes
// it is asked on, and can be asked on any other.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/verify/trial.h"

namespace geodesic::conformance {

/// What a solver must claim about itself for a property to concern it.
struct Claim {
  const char* words;  ///< "a distance limit"
  bool (*made_by)(const Description& solver);
};

struct Property {
  std::string name;       ///< lower case with hyphens, unique: "single-triangle-has-its-edges"
  std::string statement;  ///< one sentence
  std::vector<Claim> needs;
  std::vector<Case> (*cases)();          ///< what it is asked on, small ones first
  Finding (*check)(const Trial& trial);  ///< one solver on one case; may throw
  bool on_any_mesh = true;               ///< whether it holds on other meshes too
};

/// All of them, from cheap to dear.
const std::vector<Property>& all_properties();

/// @return null when no property has that name
const Property* find_property(std::string_view name);

/// Distances equal those of the reference (Trial::expected): what is asked on any mesh of a user.
inline constexpr const char* kDistancesProperty = "distances-equal-the-reference";

/// "does not claim: a distance limit, multiple sources"; empty when the property concerns it.
std::string unclaimed(const Property& property, const Description& solver);

/// Whether the mesh has more vertices than the solver is meant for: such cases are passed over.
bool too_large(const Case& given, const Description& solver);

/// What stands in front of the message of an exception.
inline constexpr const char* kThrew = "threw: ";

/// Checks one case. A mesh that the solver declares not to support must be refused. What the solver
/// throws is a failure. @throws NoReference
Finding check_case(const Property& property, const Description& solver, const Case& given);

}  // namespace geodesic::conformance
