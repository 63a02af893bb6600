// Compares closed forms, brute force and exact solvers with intervals of the true distances.
#include "tests/oracles/enclosures.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <map>
#include <string>

#include "harness/base/scratch_folder.h"
#include "harness/corpus/solvers.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/brute_force.h"
#include "meshes/oracles/random_case.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

// An interval of 100 digits stays narrower than this even where needles are unfolded. It is wider
// if a line leads through a vertex and no other line leads round that vertex.
bool is_decided(const Interval& truth) {
  return lower(truth) == upper(truth) || upper(truth) - lower(truth) < 1e-30 * upper(truth);
}

double error_of(double distance, const Interval& truth) {
  return static_cast<double>(upper(abs(Interval(distance) - truth)));
}

// The error in units of the last place of the distance. Rounding to the nearest costs up to 0.5.
double places(double distance, double error) {
  return error == 0 ? 0 : error / (std::nextafter(distance, kInfinity) - distance);
}

// Above 0.5, as the rounding of `long double` decides between two doubles that are equally near.
constexpr double kNearest = 0.501;

// The angles of a closed form are rounded, and so are the positions, which leave the cone.
constexpr double kClosedForm = 1e-15 / std::numeric_limits<double>::epsilon();

// Exact solvers promise a relative error of at most 1e-12.
constexpr double kExact = 1e-12 / std::numeric_limits<double>::epsilon();

struct Errors {
  std::size_t distances = 0, nearest = 0;  // nearest: how many are the nearest double
  double places = 0;                       // largest error, in last places
};

void expect_errors_of_rounding(std::span<const double> distances, std::span<const Interval> truth,
                               double most_places, double least_distance, Errors& errors) {
  for (std::size_t v = 0; v < truth.size(); ++v) {
    ASSERT_TRUE(is_decided(truth[v])) << "vertex " << v << ": " << truth[v];
    if (lower(truth[v]) == kInfinity) {
      EXPECT_EQ(distances[v], kInfinity) << "vertex " << v;
      continue;
    }
    const double error = error_of(distances[v], truth[v]), off = places(distances[v], error);
    ++errors.distances;
    errors.nearest += off <= kNearest;
    errors.places = std::max(errors.places, off);
    if (error <= 1e-12 * least_distance) continue;
    EXPECT_LE(off, most_places) << "vertex " << v << ": " << std::setprecision(17) << distances[v]
                                << " instead of " << truth[v];
  }
}

TEST(Enclosures, hold_the_closed_forms) {
  const std::pair<const char*, GeneratorParameters> shapes[] = {
      {"grid", {{"columns", 4}, {"rows", 3}, {"spacing", 0.3}}},
      {"capped-grid", {{"columns", 3}, {"rows", 3}, {"cap", 0}}},
      {"box", {{"x-cells", 3}, {"y-cells", 2}, {"z-cells", 1}, {"spacing", 0.1}}},
      {"cone", {{"sectors", 3}, {"angle", 12}, {"rings", 3}}},
      {"saddle-cone", {{"sectors", 4}, {"sector-angle", 91}, {"rings", 3}}},
      {"cylinder", {{"sides", 7}, {"rows", 3}, {"height", 0.9}}},
      {"involute", {{"corners", 12}, {"angle", 350}}},
      {"square-with-hole", {{"hole", 2}, {"rim", 1}}},
  };
  for (const auto& [generator, parameters] : shapes) {
    SCOPED_TRACE(generator);
    const TriangleSoup soup = generate(generator, parameters);
    const Mesh mesh(soup);
    const Enclosures enclosures(mesh);
    Errors errors;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const std::vector<Interval> truth = enclosures.distances(std::vector<Source>{{.at = v}});
      const auto known = known_distances(generator, parameters, soup, v);
      expect_errors_of_rounding(*known, truth, kClosedForm, 0, errors);
    }
  }
}

double number_from(const char* variable, double otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atof(text) : otherwise;
}

// Environment: JUDGED_MESHES (number of meshes), JUDGED_SEED, JUDGED_FACES (most faces of a mesh).
TEST(Enclosures, say_that_exact_distances_on_random_meshes_are_right_but_for_rounding) {
  const auto count = static_cast<std::size_t>(number_from("JUDGED_MESHES", 50));
  const auto seed = static_cast<std::uint64_t>(number_from("JUDGED_SEED", 1));
  const auto most_faces = static_cast<std::size_t>(number_from("JUDGED_FACES", 40));
  const harness::ScratchFolder scratch;
  std::map<std::pair<bool, std::string>, Errors> errors;  // key: mesh is well shaped, solver
  std::array<std::size_t, kMeshKinds> kinds{};
  for (std::uint64_t number = 0, judged = 0; judged < count; ++number) {
    const RandomCase made = random_case(seed, number, scratch.path());
    if (made.soup.triangles.size() > most_faces) continue;
    ++judged;
    const Mesh mesh(made.soup);
    const MeshKind kind = kind_of(mesh);
    ++kinds[static_cast<std::size_t>(kind)];
    const bool shaped = kind == MeshKind::clean || kind == MeshKind::non_manifold;
    const std::vector<Interval> truth = Enclosures(mesh).distances(made.query.sources);
    const auto judge = [&](const std::string& name, std::span<const double> distances,
                           double most_places) {
      SCOPED_TRACE(name + " on mesh " + std::to_string(number) + " of seed " +
                   std::to_string(seed) + ", " + made.recipe);
      expect_errors_of_rounding(distances, truth, most_places, made.least_distance,
                                errors[{shaped, name}]);
    };
    judge("brute force", BruteForce(mesh).distances(made.query.sources), kNearest);
    for (const Description* solver : registered_solvers()) {
      if (solver->exactness != Exactness::exact || solver->by_name_only) continue;
      if (solver->independent_oracle || !harness::unsupported(*solver, mesh).empty()) continue;
      std::vector<double> distances(mesh.vertex_count());
      make_solver(solver->name, mesh)->solve({.sources = made.query.sources}, distances);
      judge(solver->name, distances, kExact);
    }
  }
  for (std::size_t kind = 0; kind < kMeshKinds; ++kind) {
    std::cout << kinds[kind] << ' ' << name_of(static_cast<MeshKind>(kind)) << ' ';
  }
  std::cout << "meshes\n";
  for (const auto& [key, of] : errors) {
    std::cout << key.second << (key.first ? "" : " on thin and degenerate meshes") << ": "
              << of.distances << " distances, " << of.nearest << " of them nearest, at most "
              << of.places << " last places off\n";
  }
}

}  // namespace
}  // namespace geodesic
