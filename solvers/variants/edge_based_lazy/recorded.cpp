#include "solvers/edge_based/recorded-inl.h"
#include "solvers/variants/edge_based_lazy/policies.h"

template struct geodesic::edge_based::Recorded<geodesic::edge_based_lazy::Lazy>;
