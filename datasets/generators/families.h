// The families of generators; each is defined in the source file of its name.
#pragma once

#include "datasets/generators/generators.h"

namespace geodesic::generators {

struct Family {
  GeneratorDescription description;
  TriangleSoup (*make)(const CheckedParameters& parameters);
};

Family box();
Family cone();
Family cylinder();
Family egg_carton();
Family grid();
Family holed_plate();
Family icosphere();
Family needles();
Family saddle_cone();
Family square_with_hole();
Family terrain();
Family torus();
Family torus_knot();
Family two_components();

}  // namespace geodesic::generators
