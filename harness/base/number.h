// Numbers in sentences.
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace geodesic::harness {

/// @param digits so many significant ones; 17 bring the same double back
inline std::string significant(double x, int digits = 17) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return text.data();
}

}  // namespace geodesic::harness
