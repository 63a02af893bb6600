#include "tests/differential/perturb.h"

#include <algorithm>
#include <cmath>

#include "meshes/messages.h"
#include "meshes/oracles/brute_force.h"
#include "meshes/random.h"
#include "tests/differential/scratch.h"

namespace geodesic::differential {
namespace {

using harness::Case;

// Brute force takes a tenth of a second for so many faces.
constexpr std::size_t kMostFaces = 300;

/// The largest of a kind, and the mesh it was found on.
struct Largest {
  double value = 0;
  std::uint64_t at = 0;

  void raise(double other, std::uint64_t mesh) {
    if (other > value) *this = {other, mesh};
  }
};

struct Movement {
  std::uint64_t meshes = 0, distances = 0;
  std::uint64_t far = 0;        ///< distances moved by more than the tolerance of themselves
  std::uint64_t meshes_of = 0;  ///< that have such
  Largest relative;             ///< movement by distance
  Largest edge_part;  ///< movement of those by the tolerance of the longest edge: what is needed
};

double half_a_unit_in_the_last_place(const TriangleSoup& soup) {
  double largest = 0;
  for (const Vec3& p : soup.positions) {
    for (const double x : p) largest = std::max(largest, std::abs(x));
  }
  return (std::nextafter(largest, kInfinity) - largest) / 2;
}

TriangleSoup moved(TriangleSoup soup, double most, Random& random) {
  for (Vec3& p : soup.positions) {
    for (double& x : p) x += most * random.between(-1, 1);
  }
  return soup;
}

std::vector<double> right_distances(const TriangleSoup& soup, const Query& query) {
  const Mesh mesh(soup);
  return BruteForce(mesh).distances(query.sources);
}

void measure(const Case& given, std::uint64_t number, unsigned times, Movement& sum) {
  Random random(number);
  const double most = half_a_unit_in_the_last_place(given.soup);
  const Query& query = given.queries.front();
  const std::vector<double> right = right_distances(given.soup, query);
  std::vector<double> movement(right.size());
  for (unsigned time = 0; time < times; ++time) {
    const auto other = right_distances(moved(given.soup, most, random), query);
    for (std::size_t v = 0; v < right.size(); ++v) {
      if (right[v] == kInfinity) continue;
      movement[v] = std::max(movement[v], std::abs(other[v] - right[v]));
    }
  }
  const double longest = given.tolerance.least / kEdgePart;
  const std::uint64_t before = sum.far;
  for (std::size_t v = 0; v < right.size(); ++v) {
    if (right[v] == kInfinity || right[v] == 0) continue;
    ++sum.distances;
    sum.relative.raise(movement[v] / right[v], number);
    if (movement[v] <= given.tolerance.relative * right[v]) continue;
    ++sum.far;
    sum.edge_part.raise(movement[v] / (given.tolerance.relative * longest), number);
  }
  ++sum.meshes;
  sum.meshes_of += sum.far > before;
}

}  // namespace

void perturb(const Request& request, unsigned times, std::ostream& report) {
  const Scratch scratch;
  Movement sum;
  for (std::uint64_t number = 0; number < request.meshes; ++number) {
    const Case given = random_case(request.seed, number, scratch.folder());
    if (given.soup.triangles.size() > kMostFaces) continue;
    measure(given, number, times, sum);
  }
  report << "seed " << request.seed << ": " << sum.meshes << " meshes, moved " << times
         << " times by up to half a unit in the last place of the largest coordinate\n"
         << "  " << sum.distances << " distances moved by at most "
         << significant(sum.relative.value, 2) << " of themselves, at mesh " << sum.relative.at
         << '\n'
         << "  " << sum.far << " on " << sum.meshes_of << " meshes by more than "
         << significant(harness::kExactTolerance, 2) << '\n';
  if (sum.far == 0) return;
  report << "  of these the farthest by that part of 1/" << significant(1 / sum.edge_part.value, 3)
         << " of the longest edge, at mesh " << sum.edge_part.at << '\n';
}

}  // namespace geodesic::differential
