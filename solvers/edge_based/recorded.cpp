#include "solvers/edge_based/policies.h"
#include "solvers/edge_based/recorded-inl.h"

template struct geodesic::edge_based::Recorded<geodesic::edge_based::ByDistance>;
