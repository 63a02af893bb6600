#include "solvers/core/unit.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace geodesic {
namespace {

constexpr int kOrdinary = 128;
constexpr int kMost = 960;

}  // namespace

int unit_exponent(std::span<const Vec3> positions) {
  const double half = box_around(positions).half_extent();
  if (!(half > 0)) return 0;
  const int exponent = std::ilogb(half) + 1;
  if (std::abs(exponent) <= kOrdinary) return 0;
  if (std::abs(exponent) <= kMost) return exponent;
  throw std::invalid_argument("the mesh is about 2^" + std::to_string(exponent) +
                              " long; distances need a unit of length in which it is between "
                              "1e-289 and 1e289");
}

std::vector<Vec3> scaled(std::span<const Vec3> positions, int exponent) {
  std::vector<Vec3> result(positions.begin(), positions.end());
  if (exponent == 0) return result;
  for (Vec3& p : result) {
    for (double& c : p) c = std::ldexp(c, exponent);
  }
  return result;
}

}  // namespace geodesic
