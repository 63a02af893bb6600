// Recorded solves of `ch`, `ich` and `fwp-ch`, compiled apart from timed ones (core/recorders.h).
#include "solvers/chen_han/recorded.h"

namespace geodesic::chen_han {

template void ChenHan<Ch>::solve_recorded(const Start&, std::span<double>, Recording&) const;
template void ChenHan<Ch>::solve_with_strip_lengths(const Start&, std::span<double>);
template void ChenHan<Ich>::solve_recorded(const Start&, std::span<double>, Recording&) const;
template void ChenHan<Ich>::solve_with_strip_lengths(const Start&, std::span<double>);
template void ChenHan<FwpCh>::solve_recorded(const Start&, std::span<double>, Recording&) const;
template void ChenHan<FwpCh>::solve_with_strip_lengths(const Start&, std::span<double>);

}  // namespace geodesic::chen_han
