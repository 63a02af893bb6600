// Distances where no closed form is known: against brute force, and on larger meshes between the
// exact solvers, CGAL among them where it is installed.
#include "harness/verify/properties/properties.h"

namespace geodesic::conformance {
namespace {

std::vector<Case> random_meshes_from_some_sources() {
  std::vector<Case> cases = random_mesh_cases({});
  for (Case& each : cases) each.queries = some_sources(each.soup);
  return cases;
}

std::vector<Case> many_small_meshes() {
  std::vector<Case> cases;
  for (std::uint64_t seed = 100; seed < 140; ++seed) {
    const auto add = [&](const std::string& name, const TriangleSoup& soup) {
      const Index source = static_cast<Index>(seed % soup.positions.size());
      cases.push_back({name + ' ' + std::to_string(seed), soup, {from(source)}});
    };
    add("terrain", rough_terrain(seed, 5, 4, 2));
    add("sphere", rough_sphere(seed, 1, 0.5));
  }
  return cases;
}

Finding distances_are_symmetric(const Trial& trial) {
  const Mesh& mesh = trial.mesh();
  const auto solver = trial.prepare();
  std::vector<std::vector<double>> between;
  for (Index v = 0; v < mesh.vertex_count(); ++v) between.push_back(ask(*solver, mesh, from(v)));
  for (Index a = 0; a < mesh.vertex_count(); ++a) {
    std::vector<double> back;
    for (Index b = 0; b < mesh.vertex_count(); ++b) back.push_back(between[b][a]);
    if (auto wrong = agree(from(a), between[a], back)) return in("there and back", wrong);
  }
  return {};
}

// Windows that pass a vertex on its two sides meet in it, but do not cross: deleting the one that
// is longer there loses the shortest path to vertex 13.
TriangleSoup two_strips() {
  return {
      {{5.4421158196870234, 3.8479964430211111, 1.4318139762151987},
       {4.5663144382648166, 1.6403496404876932, -0.22920017545111479},
       {4.7959119756473232, 3.3777311034500599, 0.24539344387594614},
       {4.8429472436429934, 2.8344953002408149, 0.68724247962236407},
       {1.704442414199002, 0.43369651541579518, 0.43511062588077037},
       {2.9032545751193539, -0.052902674186043441, 1.0279664753703401},
       {2.4459534065797923, 0.27339378632605077, 0.65160123908426615},
       {3.1918565081432462, 0.39020182786043739, -0.28886066749691963},
       {4.1414545129518956, -0.32216793294064705, 0.90603937150444835},
       {4.1173643666785207, 0.17718297012615952, -0.36357491472736003},
       {5.09540212766733, 0.41149114421568816, 0.42021839751396334},
       {4.7023452429566532, 0.10999257797375322, 0.67169913328252728},
       {2.8235441782046111, -0.16172791938297448, 1.7688452389091254},
       {1.6862647442379965, -0.073780860495753608, 1.6121405666461215},
       {4.3705244522774596, -0.34904929425101727, 1.6347530646948143},
       {4.5947542600333691, 0.015602848632261135, 1.772728125168942},
       {2.6597715147072449, 0.82253234335221348, 0.29295496630948042},
       {3.6144247385673225, 1.2439743522554636, -0.34705738546326759},
       {4.1428468002937731, 2.4149775865720584, 0.12247712728567423},
       {4.6204772062832493, 1.3046889518154785, 0.050557394209317874}},
      {{1, 2, 3},   {2, 0, 3},   {4, 5, 6},    {4, 7, 5},   {7, 8, 5},   {7, 9, 8},   {9, 10, 11},
       {6, 12, 13}, {6, 5, 12},  {5, 14, 12},  {5, 8, 14},  {8, 15, 14}, {8, 11, 15}, {4, 16, 7},
       {7, 17, 9},  {7, 16, 17}, {16, 18, 17}, {9, 19, 10}, {9, 17, 19}, {17, 1, 19}, {18, 2, 1}}};
}

Case against_a_rival(const std::string& name, const TriangleSoup& soup) {
  return {name, soup, {from(0), from(static_cast<Index>(soup.positions.size()) / 2)}};
}

using Cases = std::vector<Case>;

}  // namespace

std::vector<Property> random_mesh_properties() {
  return {
      {"windows-on-two-sides-of-a-vertex-do-not-cross-in-it",
       "a mesh on which some solver was once wrong, cut down from a larger one",
       {},
       [] {
         return Cases{{"two strips", two_strips(), {from(0)}}};
       },
       distances_are_right},
      {kDistancesProperty,
       "on rough meshes distances equal those of brute force, on large ones those of another exact "
       "solver",
       {},
       random_meshes_from_some_sources,
       distances_are_right},
      {"distances-on-many-small-meshes-equal-brute-force",
       "on eighty small rough meshes distances equal those of brute force",
       {},
       many_small_meshes,
       distances_are_right},
      {"distances-are-symmetric",
       "the way back is as long as the way there",
       {kExactDistances},
       [] {
         return Cases{{"terrain", rough_terrain(11, 12, 12, 3), {from(0)}}};
       },
       distances_are_symmetric},
  };
}

std::vector<Property> rival_properties() {
  return {
      {"rivals-agree-on-a-terrain",
       "on a terrain of 1,800 faces distances equal those of another exact solver",
       {},
       [] { return Cases{against_a_rival("terrain", rough_terrain(21, 30, 30, 1))}; },
       distances_are_right},
      {"rivals-agree-on-a-sphere",
       "on a sphere of 1,280 faces distances equal those of another exact solver",
       {},
       [] { return Cases{against_a_rival("sphere", rough_sphere(22, 3, 0.05))}; },
       distances_are_right},
      {"rivals-agree-on-a-spiky-sphere",
       "on a sphere with deep valleys distances equal those of another exact solver",
       {},
       [] { return Cases{against_a_rival("spiky sphere", rough_sphere(23, 3, 0.4))}; },
       distances_are_right},
      {"rivals-agree-on-a-torus",
       "on a torus of 1,600 faces distances equal those of another exact solver",
       {},
       [] { return Cases{against_a_rival("torus", rough_torus(24, 40, 20, 0.1))}; },
       distances_are_right},
      {"rivals-agree-on-a-terrain-with-holes",
       "on a terrain with thirty holes distances equal those of another exact solver",
       {},
       [] {
         return Cases{against_a_rival("terrain with holes",
                                      with_holes(rough_terrain(25, 30, 30, 0.5), 25, 30))};
       },
       distances_are_right},
  };
}

}  // namespace geodesic::conformance
