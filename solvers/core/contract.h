// The version of the contract, which a plug-in and the program that loads it compare before they
// exchange objects.
#pragma once

#include <string>

#include "solvers/core/solver.h"

namespace geodesic {

/// Version of the interface that solvers are compiled against: all of solvers/core. A change that
/// breaks compiled solvers raises it: a member or virtual function that is added, moved, removed or
/// given another meaning. Plug-ins of other versions are refused.
inline constexpr int kContract = 11;

/// The contract that this file is compiled against: "contract 2 (C++ ABI 1017/1, sizes 32 280
/// ...)".
/// 1. The version, raised by hand.
/// 2. The ABI of the compiler and of its std::string: they decide the layout of objects in memory.
/// 3. The sizes of the types that both sides use. Most changes alter a size: they show even if the
///    version was not raised.
///
/// Static, so that every shared library calls its own copy.
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
