// Recorded solves of `mmp` and `fwp-mmp`, compiled apart from timed ones (core/recorders.h).
#include "solvers/mmp/recorded.h"

namespace geodesic::mmp {

template void Mmp<ByDistance>::record(const Mesh&, const Query&, std::span<double>, Recording&);
template void Mmp<ByBucket>::record(const Mesh&, const Query&, std::span<double>, Recording&);

}  // namespace geodesic::mmp
