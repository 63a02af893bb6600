#include "harness/verify/property.h"

#include <algorithm>
#include <stdexcept>

#include "harness/base/error.h"
#include "harness/corpus/solvers.h"
#include "harness/verify/properties/properties.h"

namespace geodesic::conformance {
namespace {

Finding must_refuse(const Trial& trial, const std::string& why) {
  try {
    trial.prepare();
  } catch (const std::invalid_argument&) {
    return {};
  }
  return Failure{.what = "the mesh was accepted, though " + why};
}

}  // namespace

const std::vector<Property>& all_properties() {
  static const std::vector<Property> all = [] {
    std::vector<Property> properties;
    for (const auto& group :
         {query_properties(), component_properties(), repetition_properties(),
          recording_properties(), invariance_properties(), instruction_set_properties(),
          closed_form_properties(), non_manifold_properties(), degenerate_properties(),
          extreme_properties(), random_mesh_properties(), rival_properties()}) {
      properties.insert(properties.end(), group.begin(), group.end());
    }
    return properties;
  }();
  return all;
}

const Property* find_property(std::string_view name) {
  const auto at = std::ranges::find(all_properties(), name, &Property::name);
  return at == all_properties().end() ? nullptr : &*at;
}

std::string unclaimed(const Property& property, const Description& solver) {
  std::vector<std::string> missing;
  for (const Claim& claim : property.needs) {
    if (!claim.made_by(solver)) missing.emplace_back(claim.words);
  }
  return missing.empty() ? "" : "does not claim: " + join(missing);
}

bool too_large(const Case& given, const Description& solver) {
  return given.soup.positions.size() > solver.abilities.max_vertices;
}

Finding check_case(const Property& property, const Description& solver, const Case& given) {
  try {
    const Trial trial(solver, given);
    const std::string unsupported = harness::unsupported(solver, trial.mesh());
    Finding finding = unsupported.empty() ? property.check(trial) : must_refuse(trial, unsupported);
    if (finding) finding->kind = kind_of(*finding, trial.mesh());
    return finding;
  } catch (const NoReference&) {
    throw;
  } catch (const std::exception& error) {
    const std::string what = kThrew + std::string(error.what());
    return Failure{.what = what, .kind = without_numbers(what)};
  }
}

}  // namespace geodesic::conformance
