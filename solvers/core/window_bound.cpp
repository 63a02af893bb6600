#include "solvers/core/window_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace geodesic {
namespace {

constexpr double kPerRoot = 1024;  // factor of H sqrt(H)
constexpr std::uint64_t kFloor = std::uint64_t{1} << 20;

constinit thread_local std::uint64_t lowered_to = std::numeric_limits<std::uint64_t>::max();

}  // namespace

void lower_window_bound(std::uint64_t most) { lowered_to = most; }  // tests/lowered_window_bound.h

std::uint64_t window_bound(const Mesh& mesh) {
  const double half_edges = mesh.half_edge_count();  // below 2^32: the bound is below 2^59
  const auto bound = static_cast<std::uint64_t>(kPerRoot * half_edges * std::sqrt(half_edges));
  return std::min(lowered_to, bound + kFloor);
}

void WindowBudget::report() const {
  throw EndlessPropagation("endless propagation: more than " + std::to_string(bound_) +
                           " windows on a mesh of " + std::to_string(faces_) +
                           " faces; please report this mesh");
}

}  // namespace geodesic
