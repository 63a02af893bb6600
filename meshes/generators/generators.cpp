#include "meshes/generators/generators.h"

#include <algorithm>
#include <stdexcept>

#include "meshes/generators/families.h"
#include "meshes/messages.h"

namespace geodesic {
namespace {

/// The table of generators, by name.
const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list = {box(),   clean(),  decimate(),  involute(),
                                noise(), refine(), subdivide(), transform()};
    for (const auto& group : {cones(), sheets(), spheres(), terrains(), tubes()}) {
      list.insert(list.end(), group.begin(), group.end());
    }
    std::ranges::sort(list, {}, [](const Family& family) { return family.description.name; });
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
  throw std::invalid_argument(unknown_name("generator", name, names));
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

TriangleSoup generate(std::string_view name, const GeneratorParameters& parameters,
                      std::vector<std::string>* remarks) {
  const Family& family = find_family(name);
  GeneratedMesh made =
      family.make(CheckedParameters(name, family.description.parameters, parameters));
  if (remarks != nullptr) *remarks = std::move(made.remarks);
  return std::move(made.soup);
}

std::optional<std::vector<double>> known_distances(std::string_view name,
                                                   const GeneratorParameters& parameters,
                                                   const TriangleSoup& soup, Index source) {
  const Family& family = find_family(name);
  if (family.known_distances == nullptr) return std::nullopt;
  const CheckedParameters checked(name, family.description.parameters, parameters);
  const TriangleSoup made = family.make(checked).soup;
  if (soup.positions != made.positions || soup.triangles != made.triangles) {
    throw std::invalid_argument("the mesh is not what " + std::string(name) +
                                " makes with these parameters: its distances are not known");
  }
  if (source >= soup.positions.size()) {
    throw std::invalid_argument("source vertex " + std::to_string(source) + " is not in the mesh");
  }
  return family.known_distances(checked, soup, source);
}

}  // namespace geodesic
