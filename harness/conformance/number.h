// Numbers in sentences.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace geodesic::conformance {

/// @param digits significant ones; 17 bring the same double back
inline std::string number(double x, int digits = 17) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return text.data();
}

}  // namespace geodesic::conformance
