// Sine and cosine with the same bits on every machine.
//
// The C library's differ in the last bit between processors (it picks variants with and without
// fused multiply-add at run time) and between versions. Rounding their results to a coarser grid
// only makes a difference rare and bends flat faces; these functions use nothing but + - * /.
#pragma once

#include <vector>

#include "solvers/core/geometry.h"

namespace geodesic {

struct CirclePoint {
  double cosine;
  double sine;
};

inline constexpr double kTwoPi = 6.283185307179586476925;

/// The point of the unit circle at an angle, in turns (1 = 360 degrees), which is finite; its error
/// is below 4e-16 for |turns| <= 1 and eighths of turns have the symmetries they should.
CirclePoint circle_point(double turns);

/// The corners of the regular n-gon: entry i at i / n turns.
std::vector<CirclePoint> regular_polygon(Index n);

}  // namespace geodesic
