#include "solvers/mmp/recorded-inl.h"
#include "solvers/variants/mmp_half_edge/policies.h"

template struct geodesic::mmp::Recorded<geodesic::mmp_half_edge::HalfEdge>;
