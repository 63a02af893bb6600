// Regression tests on small random meshes for which a solver once gave wrong distances.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "harness/corpus/solvers.h"
#include "harness/verify/path_check.h"
#include "harness/verify/random_check.h"
#include "meshes/editing/inserted_points.h"
#include "meshes/mesh_file.h"
#include "meshes/point_solver.h"

namespace geodesic::harness {
namespace {

/// A failure found on a random mesh, which was then shrunk. The file name has the number of the
/// random mesh, and the seed if it is not 1.
struct Pin {
  const char* mesh;  ///< name of the file in meshes/
  Index source;
  const char* broke;  ///< solvers, with their largest relative error before the repair
};

const std::vector<Pin> kPins = {
    // A source next to edges thousands of times as long as its distances. Rounding of coordinates
    // was a reason to drop a window.
    {"mesh-2598", 0, "edge-based, edge-based-bucket: 5e-7"},
    {"mesh-3872", 0, "edge-based and its variants: 4e-8"},
    {"mesh-4561", 17, "edge-based and its variants: 2e-4"},
    {"mesh-4569", 8, "edge-based: 0.08"},
    {"mesh-5004", 4, "edge-based and its variants: 0.15"},
    {"mesh-7289", 6, "edge-based and its variants: 6e-6"},
    // A collapsed edge beside a flat face. A source and an apex on the line of an edge saw each
    // other through this edge.
    {"mesh-7257", 7, "edge-based and its variants: 0.55"},
    // An edge a billionth as long as its neighbours: its direction was no unit vector.
    {"mesh-705", 0, "a lazy variant: 0.07, all but edge-based and edge-based-bucket: 1e-11"},
    {"mesh-705", 17, "template: 8e-12, all but the edge-based: 6e-12"},
    {"mesh-705-again", 10, "template: 8e-10"},
    {"mesh-6969", 10, "template: 2e-11"},
    {"mesh-9808", 13, "template: 4e-10"},
    {"mesh-8341", 2, "all: 2e-12"},
    {"mesh-8341", 12, "all but the edge-based: 2e-12"},
    // Two windows of one source. The later one is shorter by less than rounding at the far end.
    {"seed-2-mesh-6031", 3, "fwp-mmp: 1e-9"},
    // All vertices lie on a line up to rounding, which excluded one as a pseudo-source.
    {"seed-7-mesh-4989", 5, "mmp and its variants: 0.07"},
    // A saddle vertex a billionth of an edge behind a flat one: by rounding, the way over the flat
    // one was shorter than the line beside it, and its direction turned the shadow.
    {"seed-407-mesh-6242", 19, "ch, ich, fwp-ch: 1.4e-4"},
    // Lines from a vertex wind around the tip of needles, each turn shorter by rounding.
    {"seed-404-mesh-7724", 7, "edge-based, ich, fwp-ch: 1e-11"},
    {"seed-403-mesh-8580", 45, "edge-based, ich, fwp-ch: 2e-12"},
};

std::ostream& operator<<(std::ostream& out, const Pin& pin) {
  return out << pin.mesh << " from " << pin.source << ": " << pin.broke;
}

class PinnedMesh : public ::testing::TestWithParam<Pin> {};

TEST_P(PinnedMesh, is_right_by_every_exact_solver_and_instruction_set) {
  const Pin& pin = GetParam();
  const std::string file = std::string(PINNED_MESHES) + "/" + pin.mesh + ".obj";
  const Case given{pin.mesh, read_mesh_file(file).soup, {from(pin.source)}};
  const Property& property = property_named(kDistancesProperty);  // brute force judges small meshes
  for (const Description* solver : registered_solvers()) {
    // The errors of independent oracles cannot be repaired here.
    if (solver->exactness != Exactness::exact || solver->independent_oracle) continue;
    for (const InstructionSet set : std::set{InstructionSet::plain, widest_instruction_set()}) {
      set_instruction_set(set);
      const Finding wrong = check_case(property, *solver, given);
      EXPECT_FALSE(wrong) << solver->name << ", " << name_of(set)
                          << " instructions: " << wrong->what;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, PinnedMesh, ::testing::ValuesIn(kPins), [](const auto& pinned) {
  std::string name =
      std::string(pinned.param.mesh) + "_from_" + std::to_string(pinned.param.source);
  std::ranges::replace(name, '-', '_');
  return name;
});

/// A failure with sources and targets at any points of a random mesh, and the paths between them.
struct PinnedPoints {
  std::uint64_t seed, number;  ///< that give the random mesh
  std::size_t faces;           ///< of the random mesh
  std::vector<SurfacePoint> sources, targets;
  const char* broke;
};

SurfacePoint in(Index face, double a, double b, double c) {
  SurfacePoint point;
  point.face = face;
  point.weights = {a, b, c};
  return point;
}

const std::vector<PinnedPoints> kPinnedPoints = {
    {20,
     1719,
     576,
     {in(220, 0.26083198276539427, 0.23922736093567698, 0.4999406562989287),
      in(369, 0.55332048269580802, 0.057348843136553702, 0.38933067416763817),
      in(375, 0.75049999320436822, 0.24950000679563183, 0)},
     {in(482, 0.21933969473656861, 2.5539939134409466e-10, 0.78066030500803196),
      in(515, 0.99999999967272535, 0, 3.2727473170690159e-10), SurfacePoint(155)},
     "ch, 0.04: one angle, one split presupposes sources at vertices"},
    {2,
     9443,
     144,
     {in(32, 0.36386439762608358, 0.23002462132310139, 0.40611098105081495)},
     {in(88, 0.39457672691032686, 0.31199882492026226, 0.29342444816941082),
      in(91, 0.29204751940047058, 0.42203030476718018, 0.28592217583234936), SurfacePoint(71),
      in(143, 0.049712125888313113, 0, 0.9502878741116868)},
     "paths, 6.5e-12 longer than distances over needles with collapsed edges"},
    {10,
     4156,
     12,
     {in(7, 0.45703167176270221, 0.5429683281226364, 1.146613956689891e-10)},
     {in(2, 0.60238514879715344, 0.22648499519420076, 0.17112985600864583), SurfacePoint(7),
      in(3, 0.42710826577669042, 0.57289173276757233, 1.4557372213704923e-09)},
     "paths, 1.1e-12 longer than distances"},
    {10,
     7265,
     38,
     {in(9, 0.99999999912027215, 0, 8.7972778645222411e-10)},
     {in(24, 0.69013386838775104, 6.0113311890223518e-10, 0.30986613101111576),
      in(22, 6.5288262741991979e-09, 0.99999999347117363, 0), SurfacePoint(16)},
     "paths, lost: among faces without area a strip turned back upon itself"},
    {3,
     161,
     15,
     {in(14, 0.99999999997649747, 0, 2.3502495448887019e-11)},
     {SurfacePoint(16)},
     "mmp, fwp-mmp: 1e-9, beside an edge 10^9 times as long as two sources were apart"},
    {2,
     245,
     114,
     {in(66, 0.99999999984634336, 0, 1.5365668712774858e-10)},
     {SurfacePoint(72)},
     "edge-based: 1.2e-12 of the edges, round a vertex next to the source"},
    {10,
     943,
     846,
     {in(830, 0, 0.5330996015599796, 0.46690039844002051)},
     {SurfacePoint(495), SurfacePoint(101)},
     "paths, lost: along a boundary, past a vertex that rounding moves into it"},
    {2,
     1880,
     221,
     {in(160, 0.99999999919805904, 0, 8.0194103429094572e-10)},
     {SurfacePoint(17)},
     "ch, ich, fwp-ch: 2.5e-11, bent round the wrong end of a window"},
    {10,
     6168,
     80,
     {in(6, 0.99999999979555176, 0, 2.0444816255823247e-10)},
     {SurfacePoint(3), SurfacePoint(0)},
     "mmp, fwp-mmp: 1.9e-10 of 1.9e-10, a millionfold winding around three collapsed faces"},
    {9,
     9322,
     96,
     {in(56, 0.99999999983289278, 0, 1.6710727363088468e-10)},
     {SurfacePoint(9)},
     "edge-based: 7.2e-4, lines beaten by a path round the other side of a saddle vertex"},
    {8,
     6993,
     144,
     {in(62, 0.99999999986600097, 0, 1.3399898822968261e-10)},
     {SurfacePoint(82), SurfacePoint(72)},
     "edge-based: 0.036, mmp: 6.2e-11, between the lines of a vertex 2e-9 from an edge and those "
     "beside them"},
    {3,
     7360,
     144,
     {SurfacePoint(82)},
     {SurfacePoint(24)},
     "paths, lost: from a flat cap's apex to one behind it in the same place"},
    {3,
     3024,
     180,
     {in(7, 0.018078799995668041, 0.55570086461787538, 0.42622033538645659)},
     {SurfacePoint(56)},
     "paths, lost among collapsed edges"},
    {7,
     3234,
     536,
     {in(406, 0.023978166972088769, 0, 0.97602183302791135)},
     {in(412, 0.99999999933809658, 0, 6.6190345106253141e-10)},
     "paths, lost: past a vertex 4e-11 from the target"},
    {7,
     1516,
     182,
     {in(86, 0.35225338476248286, 0.6477466152375172, 0)},
     {SurfacePoint(39)},
     "paths, 4.5e-9 longer than distances: between vertices in line, beside edges 10^5 times as "
     "long"},
    {4,
     9764,
     586,
     {in(409, 0.99999999920018023, 0, 7.9981967993419391e-10)},
     {SurfacePoint(318)},
     "ch, ich, fwp-ch: 2.3e-10, between a pseudo-source's shadow and the lines that pass it"},
    {5,
     3827,
     96,
     {in(56, 0.99999999983289278, 0, 1.6710727363088468e-10)},
     {SurfacePoint(3)},
     "edge-based: 2e-12, from a source 9e-15 of an edge from a corner"},
    {401,
     5163,
     196,
     {in(194, 0.99999999969999998, 1.8e-10, 1.200000248221113e-10)},
     {SurfacePoint(70)},
     "edge-based, ich, fwp-ch: 9e-12, from lines that wind round the tip of needles"},
    {406,
     5833,
     80,
     {in(34, 0.49972121543272713, 0.50027878456727282, 0)},
     {SurfacePoint(13)},
     "paths, 2.4e-9 off their line: before a vertex they led to an inexact position of their end"},
};

std::ostream& operator<<(std::ostream& out, const PinnedPoints& pin) {
  return out << "mesh " << pin.number << " of seed " << pin.seed << ": " << pin.broke;
}

class PinnedPaths : public ::testing::TestWithParam<PinnedPoints> {};

TEST_P(PinnedPaths, are_as_long_as_right_distances_by_every_exact_solver) {
  const PinnedPoints& pin = GetParam();
  const Case given = random_mesh_case({pin.seed, pin.number}, ScratchFolder().path());
  ASSERT_EQ(given.soup.triangles.size(), pin.faces) << "another mesh has this number now";
  const Mesh mesh = given.build();
  Query query{.sources = {}, .targets = pin.targets};
  std::vector<SurfacePoint> points = pin.targets;
  for (const SurfacePoint& source : pin.sources) {
    query.sources.push_back({source, 0});
    points.push_back(source);
  }
  const InsertedPoints finer(mesh, points);
  std::vector<Source> inserted;
  for (const SurfacePoint& source : pin.sources) inserted.push_back({finer.vertex(source), 0});
  const std::vector<double> right = BruteForce(finer.mesh()).distances(inserted);
  Tolerance tolerance = given.tolerance;
  tolerance.least = std::max(tolerance.least, 2 * finer.place() / tolerance.relative);
  for (const Description* solver : registered_solvers()) {
    const bool starts_anywhere = solver->abilities.surface_sources && solver->abilities.paths;
    if (solver->exactness != Exactness::exact || solver->independent_oracle) continue;
    if (!starts_anywhere || !unsupported(*solver, mesh).empty()) continue;
    const auto made = make_solver(solver->name, mesh);
    const Paths paths = solve_paths(*made, mesh, query);
    std::vector<double> timed(mesh.vertex_count());
    made->solve({.sources = query.sources}, timed);
    EXPECT_EQ(timed, paths.distances()) << solver->name;
    for (std::size_t i = 0; i < pin.targets.size(); ++i) {
      const double distance = paths.distance_to_target(i);
      EXPECT_LE(
          std::abs(relative_error(distance, right[finer.vertex(pin.targets[i])], tolerance.least)),
          tolerance.relative)
          << solver->name << " to target " << i;
      const auto wrong =
          check_path(mesh, query, pin.targets[i], distance, paths.to_target(i), given.tolerance);
      EXPECT_FALSE(wrong) << solver->name << " to target " << i << ": " << wrong->what;
      const auto bent = check_straight(mesh, paths.to_target(i), tolerance);
      EXPECT_FALSE(bent) << solver->name << " to target " << i << ": " << bent->what;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, PinnedPaths, ::testing::ValuesIn(kPinnedPoints), [](const auto& pinned) {
  return "mesh_" + std::to_string(pinned.param.number) + "_of_seed_" +
         std::to_string(pinned.param.seed);
});

}  // namespace
}  // namespace geodesic::harness
