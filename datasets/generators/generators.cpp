#include "datasets/generators/generators.h"

#include <algorithm>
#include <stdexcept>

#include "datasets/generators/families.h"

namespace geodesic::generators {
namespace {

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list = {
        box(),         cone(),      cylinder(),   egg_carton(),    grid(),
        holed_plate(), icosphere(), needles(),    saddle_cone(),   square_with_hole(),
        terrain(),     torus(),     torus_knot(), two_components()};
    std::sort(list.begin(), list.end(), [](const Family& a, const Family& b) {
      return a.description.name < b.description.name;
    });
    return list;
  }();
  return all;
}

const Family& find_family(std::string_view name) {
  std::vector<std::string> names;
  for (const Family& family : families()) {
    if (family.description.name == name) return family;
    names.push_back(family.description.name);
  }
  throw std::invalid_argument("no generator '" + std::string(name) + "'; there are " +
                              listed(names));
}

}  // namespace

const std::vector<GeneratorDescription>& generator_descriptions() {
  static const std::vector<GeneratorDescription> descriptions = [] {
    std::vector<GeneratorDescription> list;
    for (const Family& family : families()) list.push_back(family.description);
    return list;
  }();
  return descriptions;
}

TriangleSoup generate(std::string_view name, const Parameters& parameters) {
  const Family& family = find_family(name);
  return family.make(CheckedParameters(name, family.description.parameters, parameters));
}

}  // namespace geodesic::generators
