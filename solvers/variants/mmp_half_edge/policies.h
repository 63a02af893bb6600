// MMP by distance, with windows of the two sides of an edge kept apart.
#pragma once

#include "solvers/mmp/policies.h"

namespace geodesic::mmp_half_edge {

struct HalfEdge : mmp::ByDistance {
  using Layout = mmp::ListPerHalfEdge;
};

}  // namespace geodesic::mmp_half_edge
