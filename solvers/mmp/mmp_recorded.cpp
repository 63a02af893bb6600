// Recorded solves of `mmp` and `fwp-mmp`, compiled apart from timed ones (core/recorders.h).
#include "solvers/mmp/recorded.h"

namespace geodesic::mmp {

template void Mmp<ByDistance>::solve_recorded(const Start&, std::span<double>, Recording&) const;
template void Mmp<ByBucket>::solve_recorded(const Start&, std::span<double>, Recording&) const;

}  // namespace geodesic::mmp
