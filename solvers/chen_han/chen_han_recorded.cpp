// Recorded solves of `ch`, `ich` and `fwp-ch`, compiled apart from timed ones (core/recorders.h).
#include "solvers/chen_han/recorded.h"

namespace geodesic::chen_han {

template void ChenHan<Ch>::solve_recorded(const Mesh&, const Start&, std::span<double>, Recording&);
template void ChenHan<Ch>::solve_dropping_long_strips(const Mesh&, const Start&, std::span<double>);
template void ChenHan<Ich>::solve_recorded(const Mesh&, const Start&, std::span<double>,
                                           Recording&);
template void ChenHan<Ich>::solve_dropping_long_strips(const Mesh&, const Start&,
                                                       std::span<double>);
template void ChenHan<FwpCh>::solve_recorded(const Mesh&, const Start&, std::span<double>,
                                             Recording&);
template void ChenHan<FwpCh>::solve_dropping_long_strips(const Mesh&, const Start&,
                                                         std::span<double>);

}  // namespace geodesic::chen_han
