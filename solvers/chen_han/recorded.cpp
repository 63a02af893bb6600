#include "solvers/chen_han/policies.h"
#include "solvers/chen_han/recorded-inl.h"

template struct geodesic::chen_han::Recorded<geodesic::chen_han::Ch>;
template struct geodesic::chen_han::Recorded<geodesic::chen_han::Ich>;
template struct geodesic::chen_han::Recorded<geodesic::chen_han::FwpCh>;
