#include "solvers/mmp/policies.h"
#include "solvers/mmp/recorded-inl.h"

template struct geodesic::mmp::Recorded<geodesic::mmp::ByDistance>;
template struct geodesic::mmp::Recorded<geodesic::mmp::ByBucket>;
