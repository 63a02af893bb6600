// The contract a solver was compiled against, as text: kContract, and what changes with the types
// that solvers and programs hand to each other, whether or not somebody thought of raising it.
#pragma once

#include <string>

#include "solvers/core/solver.h"

namespace geodesic {

/// "contract 1 (C++ ABI 1017/1, sizes 32 208 312 ...)"
///
/// Static, and all of it in the header: every shared library has its own, and never another's.
/// Without `literal + string`, for which GCC 12 gives a false warning where users compile it (bug
/// 105651).
static inline std::string contract_compiled_against() {
  std::string text = "contract ";
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
