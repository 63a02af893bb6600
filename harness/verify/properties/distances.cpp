// Distances compared with closed forms. Where no formula is known, the references are brute force
// and, on larger meshes, the other exact solvers.
#include <cmath>

#include "harness/verify/properties/properties.h"
#include "meshes/random.h"

namespace geodesic::harness {
namespace {

const GeneratorParameters kGrid{{"columns", 12}, {"rows", 9}};

TriangleSoup grid() { return generate("grid", kGrid); }

// Moves vertices of the grid pseudo-randomly within the plane by up to 0.28 cells. Vertices of the
// border move along it. Then hardly any line between two vertices runs through a third one.
TriangleSoup perturbed_grid() {
  Random random(7);
  TriangleSoup soup = grid();
  for (auto& [x, y, z] : soup.positions) {
    const bool border_x = x == 0 || x == 12, border_y = y == 0 || y == 9;
    if (!border_x) x += 0.28 * random.between(-1, 1);
    if (!border_y) y += 0.28 * random.between(-1, 1);
  }
  return soup;
}

Case plane(const std::string& name, const TriangleSoup& soup) {
  return plane_case(name, soup, every_source(soup), soup);
}

// A plane rotated about two axes, so that its coordinates have rounding errors.
Case rotated(const std::string& name, const TriangleSoup& flat) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  TriangleSoup soup = flat;
  for (Vec3& p : soup.positions) p = {c * p[0], c * p[1] + s * s * p[0], s * p[1] - s * c * p[0]};
  return plane_case("rotated " + name, soup, every_source(soup), flat);
}

Cases flat_disk() {
  TriangleSoup disk = generate("cone", {{"sectors", 6}, {"rings", 5}});
  for (Vec3& p : disk.positions) p[2] = 0;
  return {plane("disk", disk)};
}

Case box(Index x, Index y, Index z) {
  return closed_form_case("box", {{"x-cells", x}, {"y-cells", y}, {"z-cells", z}});
}

// Many paths go around the sharp cone.
Cases blunt_and_sharp_cones() {
  return {closed_form_case("cone", {{"sectors", 7}, {"angle", 290}, {"rings", 5}}),
          closed_form_case("cone", {{"sectors", 4}, {"angle", 90}, {"rings", 5}})};
}

Case saddle(Index sectors, double sector_angle) {
  return closed_form_case("saddle-cone",
                          {{"sectors", sectors}, {"sector-angle", sector_angle}, {"rings", 5}});
}

Cases cylinders() {
  return {closed_form_case("cylinder", {{"sides", 18}, {"rows", 6}}),
          closed_form_case("cylinder", {{"sides", 3}, {"rows", 9}})};
}

Cases squares_with_holes() {
  return {closed_form_case("square-with-hole", {{"hole", 3}, {"rim", 3}}),
          closed_form_case("square-with-hole", {{"hole", 6}, {"rim", 2}})};
}

Cases many_small_meshes() {
  Cases cases;
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

void distances_are_symmetric(const Trial& trial) {
  const Index vertices = trial.mesh().vertex_count();
  const auto solver = trial.prepare();
  std::vector<std::vector<double>> between;
  for (Index v = 0; v < vertices; ++v) between.push_back(trial.solve(*solver, from(v)));
  for (Index a = 0; a < vertices; ++a) {
    std::vector<double> back;
    for (Index b = 0; b < vertices; ++b) back.push_back(between[b][a]);
    require("there and back", check_distances(from(a), between[a], back));
  }
}

// Windows that pass a vertex on its two sides meet in it, but do not cross. Deleting the one with
// the longer distance there loses the shortest path to vertex 13.
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

// A mesh that is too large for brute force.
Case large(const std::string& name, const TriangleSoup& soup) {
  return {name, soup, {from(0), from(static_cast<Index>(soup.positions.size()) / 2)}};
}

}  // namespace

std::vector<Property> closed_form_properties() {
  return {
      {"flat-grid-distances-equal-euclid",
       "in a plane that is a grid, where many lines run through vertices, distances are Euclid's",
       [] { return cases_of(closed_form_case("grid", kGrid)); }},
      {"flat-grid-distances-equal-euclid-when-stirred",
       "in a plane of irregular triangles distances are Euclid's",
       [] { return cases_of(plane("perturbed grid", perturbed_grid())); }},
      {"flat-grid-distances-equal-euclid-when-tilted",
       "in a plane that is rotated in space, so that its coordinates are rounded, distances are "
       "Euclid's",
       [] {
         return cases_of(rotated("grid", grid()), rotated("perturbed grid", perturbed_grid()));
       }},
      {"flat-disk-distances-equal-euclid", "on a disk around a vertex distances are Euclid's",
       flat_disk},
      {"distances-on-a-cube-equal-the-shortest-unfolding",
       "on a cube every distance is the least straight line over all unfoldings",
       [] { return cases_of(box(1, 1, 1), box(4, 4, 4)); }},
      {"distances-in-a-long-room-equal-the-shortest-unfolding",
       "in a long room every distance is the least straight line over all unfoldings",
       [] { return cases_of(box(8, 3, 3)); }},
      {"distances-on-a-slab-equal-the-shortest-unfolding",
       "on a slab every distance is the least straight line over all unfoldings",
       [] { return cases_of(box(7, 5, 1)); }},
      {"cone-distances-follow-from-the-angle-at-the-apex",
       "on cones, blunt and sharp, distances are those of the unrolled sectors",
       blunt_and_sharp_cones},
      {"saddle-paths-are-straight-below-pi-and-bend-at-the-apex-above",
       "around a saddle vertex paths are straight below 180 degrees and run through it above",
       [] { return cases_of(saddle(6, 72), saddle(8, 90)); }},
      {"hardly-curved-saddle-is-exact-too",
       "around a saddle vertex whose angle exceeds 360 degrees by 1e-5 and 1e-11 rad distances are "
       "exact",
       [] { return cases_of(saddle(6, 60 + 1e-4), saddle(6, 60 + 1e-10)); }},
      {"cylinder-distances-equal-those-of-the-unrolled-strip",
       "on a cylinder distances are those of the unrolled strip, the shorter way round", cylinders},
      {"plate-around-an-arc-has-paths-that-bend-at-its-corners",
       "around a convex arc distances are those of a string pulled taut",
       [] {
         return cases_of(closed_form_case("involute", {{"corners", 24}}));
       }},
      {"square-with-hole-paths-bend-at-the-corners-of-the-hole",
       "around a hole paths bend at its corners: boundary vertices are pseudo-sources",
       squares_with_holes},
  };
}

std::vector<Property> rough_mesh_properties() {
  return {
      {"windows-on-two-sides-of-a-vertex-do-not-cross-in-it",
       "distances are right on a mesh on which a solver was once wrong, cut down from a larger one",
       [] { return one("two strips", two_strips(), from(0)); }},
      {kDistancesProperty,
       "on rough meshes distances equal those of brute force, on large ones those of another exact "
       "solver",
       random_meshes_from_some_sources},
      {"distances-on-many-small-meshes-equal-brute-force",
       "on eighty small rough meshes distances equal those of brute force", many_small_meshes},
      {"distances-are-symmetric", "the way back is as long as the way there",
       [] { return one("terrain", rough_terrain(11, 12, 12, 3), from(0)); },
       distances_are_symmetric, kExactDistances},
      {"rivals-agree-on-a-terrain",
       "on a terrain of 1,800 faces distances equal those of another exact solver",
       [] { return cases_of(large("terrain", rough_terrain(21, 30, 30, 1))); }},
      {"rivals-agree-on-a-sphere",
       "on a sphere of 1,280 faces distances equal those of another exact solver",
       [] { return cases_of(large("sphere", rough_sphere(22, 3, 0.05))); }},
      {"rivals-agree-on-a-spiky-sphere",
       "on a sphere with deep valleys distances equal those of another exact solver",
       [] { return cases_of(large("spiky sphere", rough_sphere(23, 3, 0.4))); }},
      {"rivals-agree-on-a-torus",
       "on a torus of 1,600 faces distances equal those of another exact solver",
       [] { return cases_of(large("torus", rough_torus(24, 40, 20, 0.1))); }},
      {"rivals-agree-on-a-terrain-with-holes",
       "on a terrain with thirty holes distances equal those of another exact solver",
       [] {
         return cases_of(
             large("terrain with holes", with_holes(rough_terrain(25, 30, 30, 0.5), 25, 30)));
       }},
  };
}

}  // namespace geodesic::harness
