// What the two sides of the contract must agree on before they exchange objects: a solver in a
// plug-in, and the program that loads it.
#pragma once

#include <string>

#include "solvers/core/solver.h"

namespace geodesic {

/// The version of what a solver sees: all of solvers/core. Raised when a solver that was compiled
/// before a change would no longer work after it: when a member or a virtual function is added,
/// moved or removed, or means something else. Plug-ins of other versions are refused.
inline constexpr int kContract = 9;

/// The contract that this file is compiled against: "contract 2 (C++ ABI 1017/1, sizes 32 280
/// ...)".
/// 1. The version, raised by hand.
/// 2. The compiler's ABI and that of its std::string: they decide how objects lie in memory.
/// 3. The sizes of the types that both sides use: a change of most kinds shows in them, should the
///    version have been forgotten.
///
/// Static, so that every shared library has its own and never another's.
static inline std::string compiled_contract() {
  std::string text = "contract ";
  // Appended piece by piece: for `literal + string` GCC 12 gives a false warning (bug 105651).
  text.append(std::to_string(kContract)).append(" (C++ ABI ");
  text.append(std::to_string(__GXX_ABI_VERSION));
#ifdef _GLIBCXX_USE_CXX11_ABI
  text.append("/").append(std::to_string(_GLIBCXX_USE_CXX11_ABI));
#endif
  text += ", sizes";
  for (const std::size_t bytes : {sizeof(HalfEdge), sizeof(Mesh), sizeof(Description),
                                  sizeof(Query), sizeof(Recording), sizeof(Solver)}) {
    text.append(" ").append(std::to_string(bytes));
  }
  return text + ")";
}

}  // namespace geodesic
