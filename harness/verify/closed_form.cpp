#include "harness/verify/closed_form.h"

#include <algorithm>
#include <stdexcept>

#include "harness/base/error.h"
#include "meshes/generators/generators.h"

namespace geodesic::harness {

bool has_closed_form(const MeshEntry& entry) {
  const auto& generators = generator_descriptions();
  return entry.recipe &&
         std::any_of(generators.begin(), generators.end(), [&](const auto& generator) {
           return generator.name == entry.recipe->generator && !generator.closed_form.empty();
         });
}

std::optional<std::vector<double>> closed_form_distances(const MeshEntry& entry,
                                                         const TriangleSoup& soup, Index source) {
  if (!has_closed_form(entry)) return std::nullopt;
  try {
    return known_distances(entry.recipe->generator, entry.recipe->parameters, soup, source);
  } catch (const std::invalid_argument& error) {
    throw HarnessError("mesh '" + entry.name +
                       "' cannot be verified by its closed form: " + error.what());
  }
}

}  // namespace geodesic::harness
