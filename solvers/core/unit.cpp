#include "solvers/core/unit.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace geodesic {
namespace {

constexpr int kOrdinary = 128;
constexpr int kMost = 960;

}  // namespace

Unit Unit::of(std::span<const Vec3> positions) {
  Unit unit;
  const double half = box_around(positions).half_extent();
  if (!(half > 0)) return unit;
  const int exponent = std::ilogb(half) + 1;
  if (std::abs(exponent) > kMost) {
    throw std::invalid_argument("the mesh is about 2^" + std::to_string(exponent) +
                                " long; distances need a unit of length in which it is between "
                                "1e-289 and 1e289");
  }
  if (std::abs(exponent) > kOrdinary) unit.exponent_ = exponent;
  return unit;
}

std::vector<Vec3> Unit::in_unit(std::span<const Vec3> positions) const {
  std::vector<Vec3> result(positions.begin(), positions.end());
  for (Vec3& p : result) {
    for (double& c : p) c = in_unit(c);
  }
  return result;
}

}  // namespace geodesic
