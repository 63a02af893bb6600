// Zero-length edges and zero-area faces, as real scans have them. They hang no solver, a
// zero-length edge is a distance of 0 between its ends, and distances elsewhere stay exact.
#include <cmath>

#include "harness/verify/properties/properties.h"
#include "meshes/generators/generators.h"

namespace geodesic::conformance {
namespace {

TriangleSoup flat_grid(Index columns, Index rows, const char* diagonal = "alternating") {
  return generate("grid", {{"columns", columns}, {"rows", rows}, {"diagonal", diagonal}});
}

Case from_some_sources(const std::string& name, const TriangleSoup& soup) {
  return {name, soup, some_sources(soup)};
}

std::vector<Case> collapsed_edges_on_rough_surfaces() {
  std::vector<Case> cases;
  for (std::uint64_t seed = 2; seed < 6; ++seed) {
    const auto collapsed = [&](const TriangleSoup& soup) {
      return with_collapsed_edges(soup, seed, 12);
    };
    const std::string number = std::to_string(seed);
    cases.push_back(
        from_some_sources("terrain " + number, collapsed(rough_terrain(seed, 8, 8, 1))));
    cases.push_back(from_some_sources("sphere " + number, collapsed(rough_sphere(seed, 2, 0.2))));
  }
  return cases;
}

std::vector<Case> flat_caps_on_rough_surfaces() {
  std::vector<Case> cases;
  for (std::uint64_t seed = 12; seed < 16; ++seed) {
    const auto capped = [&](const TriangleSoup& soup) { return with_flat_caps(soup, seed, 6); };
    const std::string number = std::to_string(seed);
    cases.push_back(from_some_sources("terrain " + number, capped(rough_terrain(seed, 7, 7, 1))));
    cases.push_back(from_some_sources("sphere " + number, capped(rough_sphere(seed, 1, 0.2))));
  }
  return cases;
}

// From a vertex in the middle of an edge, lines cross faces without area before they come to one
// that has any.
TriangleSoup flat_faces_in_a_row() {
  return {
      {{0.10019145557185018, 4, 0},
       {0.042939195245078651, 5, 0},
       {0.057252260326771533, 5, 0},
       {0.071565325408464414, 5, 0},
       {0.085878390490157303, 5, 0},
       {0.10019145557185018, 5, 0},
       {0.028626130163385766, 6, 0},
       {0.042939195245078651, 6, 0},
       {0.057252260326771533, 6, 0},
       {0.014313065081692883, 7, 0},
       {0.028626130163385766, 7, 0}},
      {{1, 4, 3}, {1, 0, 5}, {1, 5, 4}, {1, 7, 6}, {1, 2, 8}, {1, 8, 7}, {2, 3, 8}, {6, 10, 9}}};
}

std::vector<Case> a_point() {
  TriangleSoup soup = rough_sphere(7, 1, 0.2);
  for (Vec3& p : soup.positions) p = {1, 2, 3};
  return {from_some_sources("a point", soup)};
}

std::vector<Case> a_line() {
  TriangleSoup soup = rough_terrain(8, 5, 5, 1);
  for (Vec3& p : soup.positions) p = {p[0], 0, 0};
  return {from_some_sources("a line", soup)};
}

// For meshes so degenerate that it is rounding which way is the shortest: bounds from both sides.
Finding distances_are_bounded(const Trial& trial) {
  const auto solver = trial.prepare();
  for (const Query& query : trial.queries()) {
    const auto got = ask(*solver, trial.mesh(), query);
    if (auto wrong = satisfies_edges(trial.mesh(), query, got)) return wrong;
    if (auto wrong = bound_from_above(query, got, straight_lines(trial.soup(), query)))
      return in("nearer than the straight line", wrong);
    if (trial.solver().exactness != Exactness::exact) continue;
    if (auto wrong = bound_from_above(query, trial.expected(query), got))
      return in("farther than brute force, here as the second of the two", wrong);
  }
  return {};
}

// Every other column is 10^6 times narrower than its neighbour.
std::vector<Case> needles() {
  TriangleSoup soup = flat_grid(10, 6, "backward");
  for (Vec3& p : soup.positions) {
    const double column = std::floor(p[0] / 2);
    p[0] = column + (p[0] > 2 * column ? 1e-6 : 0);
  }
  return {{"needles", soup, {from(0), from(38)}, [=](const Query& query) {
             return straight_lines(soup, query);
           }}};
}

// Distances alone: along an edge of a needle, rounding of long distances exceeds its length.
Finding distances_equal_the_known(const Trial& trial) {
  for (const Query& query : trial.queries()) {
    if (auto wrong = trial.correct(query, trial.solve(query), trial.expected(query))) return wrong;
  }
  return {};
}

using Cases = std::vector<Case>;

}  // namespace

std::vector<Property> degenerate_properties() {
  return {
      {"needles-in-a-plane-keep-euclid",
       "faces a million times longer than wide leave the distances of a plane Euclid's",
       {},
       needles,
       distances_equal_the_known},
      {"degenerate-all-positions-equal",
       "where all vertices lie in one point every distance is 0",
       {},
       a_point,
       distances_are_right},
      {"degenerate-all-positions-on-a-line",
       "where all vertices lie on a line distances are between straight lines and ways along edges",
       {},
       a_line,
       distances_are_bounded,
       /*on_any_mesh=*/false},
      {"degenerate-zero-length-edges-in-a-plane",
       "in a plane with zero-length edges distances are exact, and 0 along those",
       {},
       [] {
         return Cases{from_some_sources("grid", with_collapsed_edges(flat_grid(8, 8), 1, 12))};
       },
       distances_are_right},
      {"degenerate-zero-area-faces-in-a-plane",
       "in a plane with zero-area faces distances are exact",
       {},
       [] { return Cases{from_some_sources("grid", with_flat_caps(flat_grid(8, 8), 6, 5))}; },
       distances_are_right},
      {"degenerate-zero-area-faces-in-a-row-let-lines-through",
       "a mesh on which some solvers were once wrong, cut down from a larger one",
       {},
       [] { return Cases{from_some_sources("flat faces", flat_faces_in_a_row())}; },
       distances_are_right},
      {"degenerate-zero-area-faces-on-a-rough-surface",
       "on a rough surface with zero-area faces distances are exact",
       {},
       flat_caps_on_rough_surfaces,
       distances_are_right},
      {"degenerate-zero-length-edges-on-a-rough-surface",
       "on a rough surface with zero-length edges distances are exact, and 0 along those",
       {},
       collapsed_edges_on_rough_surfaces,
       distances_are_right},
  };
}

}  // namespace geodesic::conformance
