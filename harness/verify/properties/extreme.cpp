// Meshes that are clean and yet far from ordinary: valences, loops and components by the thousand,
// ties everywhere, saddles next to flat, units of length far from 1. On all of them a solver stays
// far below the bound on its windows (solvers/core/window_bound.h).
#include <cmath>

#include "harness/verify/properties/properties.h"
#include "meshes/generators/generators.h"
#include "solvers/core/window_bound.h"

namespace geodesic::conformance {
namespace {

// One 10^150 and one 10^-150 are about.
constexpr int kFar = 498;  // power of two

// CGAL 5.5 leaves vertices behind needles of aspect 10^8 unreached.
constexpr Claim kOwnKernel{"the window kernel of this project",
                           [](const Description& d) { return !d.independent_oracle; }};

TriangleSoup times(TriangleSoup soup, double factor) {
  for (Vec3& p : soup.positions) {
    for (double& c : p) c *= factor;
  }
  return soup;
}

Case closed_form(const std::string& generator, const GeneratorParameters& parameters,
                 const std::vector<Index>& sources) {
  const TriangleSoup soup = generate(generator, parameters);
  std::vector<Query> queries;
  for (const Index source : sources) queries.push_back(from(source));
  return {generator, soup, queries, [=](const Query& query) {
            const Index source = query.sources.front().vertex;
            return known_distances(generator, parameters, soup, source).value();
          }};
}

// The apex of a cone and of a saddle cone of a thousand sectors.
std::vector<Case> thousand_sectors() {
  return {
      closed_form("cone", {{"sectors", 1000}, {"angle", 290}, {"rings", 1}}, {0, 1, 700}),
      closed_form("saddle-cone", {{"sectors", 1000}, {"sector-angle", 0.5}, {"rings", 1}},
                  {0, 1, 700}),
  };
}

Case flat(const std::string& name, const TriangleSoup& soup) {
  return {name, soup, some_sources(soup),
          [soup](const Query& query) { return straight_lines(soup, query); }};
}

// A triangle in a plane whose faces were cut at their centroids four times: the last 27 vertices
// are of valence 3.
TriangleSoup cut_at_centroids() {
  TriangleSoup soup{{{0, 0, 0}, {9, 1, 0}, {4, 8, 0}}, {{0, 1, 2}}};
  for (int time = 0; time < 4; ++time) {
    const std::vector<Triangle> faces = std::move(soup.triangles);
    soup.triangles.clear();
    for (const auto& [a, b, c] : faces) {
      const Index m = static_cast<Index>(soup.positions.size());
      Vec3 middle;
      for (std::size_t k = 0; k < 3; ++k) {
        middle[k] = (soup.positions[a][k] + soup.positions[b][k] + soup.positions[c][k]) / 3;
      }
      soup.positions.push_back(middle);
      soup.triangles.insert(soup.triangles.end(), {{a, b, m}, {b, c, m}, {c, a, m}});
    }
  }
  return soup;
}

std::vector<Case> valence_three() {
  const TriangleSoup tetrahedron{{{0, 0, 0}, {3, 0, 0.2}, {0, 2, -0.1}, {0.7, 0.8, 1.9}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  return {{"tetrahedron", tetrahedron, {from(0), from(3)}},
          flat("a triangle cut at centroids", cut_at_centroids())};
}

// The cells of a rough terrain that `keep` wants.
template <class Keep>
TriangleSoup cells_of_terrain(Index cells, Keep keep) {
  TriangleSoup soup = rough_terrain(81, cells, cells, 0.5);
  std::vector<Triangle> kept;
  for (Index cell = 0; cell < cells * cells; ++cell) {
    if (!keep(cell % cells, cell / cells)) continue;
    kept.insert(kept.end(), {soup.triangles[2 * cell], soup.triangles[2 * cell + 1]});
  }
  soup.triangles = std::move(kept);
  return soup;
}

// 2,048 squares that touch at corners, each with a boundary of its own, and a plate with 400 holes.
std::vector<Case> boundary_loops() {
  const TriangleSoup board =
      cells_of_terrain(64, [](Index i, Index j) { return (i + j) % 2 == 0; });
  const TriangleSoup plate =
      cells_of_terrain(41, [](Index i, Index j) { return i % 2 == 0 || j % 2 == 0; });
  return {{"checkerboard", board, {from(0), from(2112)}}, {"plate", plate, {from(900)}}};
}

// Triangles side by side.
std::vector<Case> components() {
  constexpr Index kTriangles = 100'000;
  TriangleSoup soup;
  for (Index t = 0; t < kTriangles; ++t) {
    const double x = 4.0 * t;
    soup.positions.insert(soup.positions.end(), {{x, 0, 0}, {x + 3, 0, 0}, {x, 4, 0}});
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const Index last = 3 * kTriangles - 2;
  return {{"triangles", soup, {from({4, last})}, [=](const Query&) {
             std::vector<double> distances(3 * kTriangles, kInfinity);
             for (const Index source : {Index{4}, last}) {
               distances[source - 1] = 3;
               distances[source] = 0;
               distances[source + 1] = 5;
             }
             return distances;
           }}};
}

// Saddles whose angle exceeds 360 degrees by about the square of the relief.
std::vector<Case> nearly_flat() {
  std::vector<Case> cases;
  for (const double relief : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const TriangleSoup soup = rough_terrain(82, 9, 9, relief);
    cases.push_back({"terrain", soup, {from(0), from(45)}});
  }
  return cases;
}

// Lines from a vertex of a grid run through other vertices, and around a box several equally short
// ways lead to many: windows meet in one point, and none may multiply.
std::vector<Case> ties() {
  std::vector<Case> cases;
  for (const char* diagonal : {"alternating", "forward"}) {
    cases.push_back(
        closed_form("grid", {{"columns", 30}, {"rows", 30}, {"diagonal", diagonal}}, {0, 480}));
    cases.push_back(closed_form(
        "box", {{"x-cells", 10}, {"y-cells", 10}, {"z-cells", 10}, {"diagonal", diagonal}},
        {0, 300}));
  }
  return cases;
}

// Every other column is 10^8 times narrower than its neighbour. Beside the long sides of a needle
// its width has half as many digits: positions that a coordinate's last place moves by 10^-16 move
// the bend of a path by 10^-16 times the aspect, and its length by the square of that.
std::vector<Case> thin_needles() {
  TriangleSoup soup = generate("grid", {{"columns", 10}, {"rows", 6}, {"diagonal", "backward"}});
  for (Vec3& p : soup.positions) {
    const double column = std::floor(p[0] / 2);
    p[0] = column + (p[0] > 2 * column ? 1e-8 : 0);
  }
  return {flat("needles", soup)};
}

std::vector<Case> far_units() {
  const TriangleSoup grid = generate("grid", {{"columns", 8}, {"rows", 6}});
  return {flat("grid of 10^150", times(grid, 1e150)),
          flat("grid of 10^-150", times(grid, 1e-150)),
          {"terrain of 10^150", times(rough_terrain(83, 7, 7, 2), 1e150), {from(9)}},
          {"sphere of 10^-150", times(rough_sphere(84, 1, 0.4), 1e-150), {from(9)}}};
}

Finding distances_are_known_in_few_windows(const Trial& trial) {
  // Of the bound. What is meant for small meshes alone may propagate windows without a filter.
  const std::uint64_t part = trial.solver().abilities.max_vertices == kNone ? 1000 : 10;
  const std::uint64_t most = window_bound(trial.mesh()) / part;
  const auto solver = trial.prepare();
  for (const Query& query : trial.queries()) {
    Recording recording;
    const auto got = ask(*solver, trial.mesh(), query, &recording);
    if (auto wrong = trial.correct(query, got, trial.expected(query))) return wrong;
    if (recording.window_propagations.value_or(0) <= most) continue;
    return Failure{.what = std::to_string(*recording.window_propagations) +
                           " windows were propagated, more than " + std::to_string(most) +
                           ", one part in " + std::to_string(part) + " of the bound",
                   .query = query};
  }
  return {};
}

Query scaled(Query query, int exponent) {
  query.limit = std::ldexp(query.limit, exponent);
  for (Source& source : query.sources) source.distance = std::ldexp(source.distance, exponent);
  return query;
}

Finding far_units_change_exponents_only(const Trial& trial) {
  const Query& query = trial.query();
  Recording recording;
  const auto distances = ask(*trial.prepare(), trial.mesh(), query, &recording);
  for (const int exponent : {kFar, -kFar}) {
    const std::string circumstances = "times 2^" + std::to_string(exponent);
    const Mesh other(times(trial.soup(), std::ldexp(1, exponent)));
    const Query other_query = scaled(query, exponent);
    Recording other_recording;
    auto got = ask(*trial.prepare(other), other, other_query, &other_recording);
    for (double& d : got) d = std::ldexp(d, -exponent);
    if (auto wrong = identical(query, got, distances)) return in(circumstances, wrong);
    if (other_recording.wavefront_sd) {
      other_recording.wavefront_sd = std::ldexp(*other_recording.wavefront_sd, -exponent);
    }
    if (!(other_recording == recording))
      return Failure{.what = circumstances + ": a counter changed", .query = query};
  }
  return {};
}

// Sources with initial distances and a limit, in the unit of length too.
std::vector<Case> for_far_units() {
  const Query query{.sources = {{1, 0.5}, {9, 0}}, .limit = 6};
  return {{"terrain", rough_terrain(85, 9, 9, 1.5), {query}},
          {"sphere", rough_sphere(86, 1, 0.3), {query}},
          {"torus", rough_torus(87, 10, 8, 0.3), {query}}};
}

}  // namespace

std::vector<Property> extreme_properties() {
  return {
      {"units-of-length-far-from-one-change-exponents-only",
       "in a unit 2^498 times as long or as short, about 10^150, distances and recordings have "
       "other exponents and the same bits besides",
       {kMultipleSources, kInitialDistances, kDistanceLimit},
       for_far_units,
       far_units_change_exponents_only},
      {"units-of-length-far-from-one-leave-distances-right",
       "with coordinates of 10^150 and 10^-150 distances are exact",
       {},
       far_units,
       distances_are_right},
      {"valence-of-a-thousand-is-exact",
       "around a vertex of a thousand faces distances are those of the unrolled sectors",
       {},
       thousand_sectors,
       distances_are_known_in_few_windows},
      {"valence-of-three-is-exact",
       "where vertices have three faces distances are exact",
       {},
       valence_three,
       distances_are_known_in_few_windows},
      {"saddles-next-to-flat-are-exact",
       "on terrains whose saddles exceed 360 degrees by less and less distances are exact",
       {},
       nearly_flat,
       distances_are_known_in_few_windows},
      {"ties-by-the-hundred-are-exact-and-few-windows",
       "on regular grids and boxes, where windows meet in one point, they do not multiply",
       {},
       ties,
       distances_are_known_in_few_windows},
      {"needles-of-aspect-1e8-keep-euclid",
       "faces 10^8 times longer than wide leave the distances of a plane Euclid's",
       {kOwnKernel},
       thin_needles,
       distances_are_known_in_few_windows},
      {"components-by-the-hundred-thousand-are-apart",
       "of 10^5 components those of the sources are reached, and no other",
       {kMultipleSources},
       components,
       distances_are_known_in_few_windows},
      {"boundary-loops-by-the-thousand-are-exact",
       "on surfaces with thousands of boundary loops distances equal those of another exact solver",
       {},
       boundary_loops,
       distances_are_known_in_few_windows},
  };
}

}  // namespace geodesic::conformance
