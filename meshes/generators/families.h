// The families of generators; each is defined in the source file of its name.
#pragma once

#include <functional>
#include <utility>

#include "meshes/generators/generators.h"

namespace geodesic {

/// A mesh, and one line for each thing that was done to the input that it is made from.
struct Made {
  Made(TriangleSoup mesh, std::vector<std::string> lines = {})
      : soup(std::move(mesh)), remarks(std::move(lines)) {}

  TriangleSoup soup;
  std::vector<std::string> remarks;
};

struct Family {
  GeneratorDescription description;
  std::function<Made(const CheckedParameters& parameters)> make;
  /// The closed form (known_distances.h) where there is one.
  std::vector<double> (*known_distances)(const CheckedParameters& parameters,
                                         const TriangleSoup& soup, Index source) = nullptr;
};

Family box();
Family clean();
Family cone();
Family cylinder();
Family egg_carton();
Family elevation();
Family grid();
Family holed_plate();
Family icosphere();
Family needles();
Family noise();
Family refine();
Family saddle_cone();
Family square_with_hole();
Family subdivide();
Family terrain();
Family torus();
Family torus_knot();
Family two_components();

}  // namespace geodesic
