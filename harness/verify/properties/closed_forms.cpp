// Distances against plane geometry: the closed forms of generated meshes, and planes that are
// tilted and stirred here.
#include <cmath>

#include "harness/verify/properties/properties.h"
#include "meshes/generators/generators.h"
#include "meshes/random.h"

namespace geodesic::conformance {
namespace {

std::vector<Query> from_every_vertex(const TriangleSoup& soup) {
  std::vector<Query> queries;
  for (Index v = 0; v < soup.positions.size(); ++v) queries.push_back(from(v));
  return queries;
}

Case closed_form(const std::string& generator, const GeneratorParameters& parameters) {
  const TriangleSoup soup = generate(generator, parameters);
  return {generator, soup, from_every_vertex(soup), [=](const Query& query) {
            const Index source = query.sources.front().vertex;
            return known_distances(generator, parameters, soup, source).value();
          }};
}

// A convex piece of a plane, wherever it lies in space.
// @param flat the same mesh in the plane z = 0, before rounding by a tilt
Case convex_plane(const std::string& name, const TriangleSoup& soup, const TriangleSoup& flat) {
  return {name, soup, from_every_vertex(soup), [=](const Query& query) {
            const Vec3& source = flat.positions[query.sources.front().vertex];
            std::vector<double> lines;
            for (const auto& [x, y, z] : flat.positions) {
              lines.push_back(std::hypot(x - source[0], y - source[1]));
            }
            return lines;
          }};
}

GeneratorParameters grid_parameters() { return {{"columns", 12}, {"rows", 9}}; }

TriangleSoup grid() { return generate("grid", grid_parameters()); }

// Moves vertices of the grid pseudo-randomly within the plane by up to 0.28 cells; those of the
// border move along it. Hardly any line between vertices then runs through a third.
TriangleSoup stirred_grid() {
  Random random(7);
  TriangleSoup soup = grid();
  for (auto& [x, y, z] : soup.positions) {
    const bool border_x = x == 0 || x == 12, border_y = y == 0 || y == 9;
    if (!border_x) x += 0.28 * random.between(-1, 1);
    if (!border_y) y += 0.28 * random.between(-1, 1);
  }
  return soup;
}

// Turned about two axes, so that coordinates of a plane get rounding errors.
TriangleSoup tilted(TriangleSoup soup) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  for (Vec3& p : soup.positions) p = {c * p[0], c * p[1] + s * s * p[0], s * p[1] - s * c * p[0]};
  return soup;
}

Case box(Index x, Index y, Index z) {
  return closed_form("box", {{"x-cells", x}, {"y-cells", y}, {"z-cells", z}});
}

std::vector<Case> flat_disk() {
  TriangleSoup disk = generate("cone", {{"sectors", 6}, {"rings", 5}});
  for (Vec3& p : disk.positions) p[2] = 0;
  return {convex_plane("disk", disk, disk)};
}

// The excess over 360 degrees is about 1e-6 and 1e-12 rad.
std::vector<Case> hardly_curved_saddles() {
  std::vector<Case> cases;
  for (const double excess : {1e-4, 1e-10}) {
    cases.push_back(
        closed_form("saddle-cone", {{"sectors", 6}, {"sector-angle", 60 + excess}, {"rings", 5}}));
  }
  return cases;
}

using Cases = std::vector<Case>;

}  // namespace

std::vector<Property> closed_form_properties() {
  return {
      {"flat-grid-distances-equal-euclid",
       "in a plane that is a grid, where many lines run through vertices, distances are Euclid's",
       {},
       [] { return Cases{closed_form("grid", grid_parameters())}; },
       distances_are_right},
      {"flat-grid-distances-equal-euclid-when-stirred",
       "in a plane of irregular triangles distances are Euclid's",
       {},
       [] { return Cases{convex_plane("stirred grid", stirred_grid(), stirred_grid())}; },
       distances_are_right},
      {"flat-grid-distances-equal-euclid-when-tilted",
       "a plane that lies askew in space, so that its coordinates are rounded, keeps Euclid's",
       {},
       [] {
         return Cases{convex_plane("tilted grid", tilted(grid()), grid()),
                      convex_plane("tilted stirred grid", tilted(stirred_grid()), stirred_grid())};
       },
       distances_are_right},
      {"flat-disk-distances-equal-euclid",
       "on a disk around a vertex distances are Euclid's",
       {},
       flat_disk,
       distances_are_right},
      {"distances-on-a-cube-equal-the-shortest-unfolding",
       "on a cube every distance is the least straight line over all unfoldings",
       {},
       [] {
         return Cases{box(1, 1, 1), box(4, 4, 4)};
       },
       distances_are_right},
      {"distances-in-a-long-room-equal-the-shortest-unfolding",
       "in a long room every distance is the least straight line over all unfoldings",
       {},
       [] { return Cases{box(8, 3, 3)}; },
       distances_are_right},
      {"distances-on-a-slab-equal-the-shortest-unfolding",
       "on a slab every distance is the least straight line over all unfoldings",
       {},
       [] { return Cases{box(7, 5, 1)}; },
       distances_are_right},
      {"cone-distances-follow-from-the-angle-at-the-apex",
       "on cones, blunt and sharp, distances are those of the unrolled sectors",
       {},
       [] {
         return Cases{closed_form("cone", {{"sectors", 7}, {"angle", 290}, {"rings", 5}}),
                      // Sharp: most paths go around.
                      closed_form("cone", {{"sectors", 4}, {"angle", 90}, {"rings", 5}})};
       },
       distances_are_right},
      {"saddle-paths-are-straight-below-pi-and-bend-at-the-apex-above",
       "around a saddle vertex paths are straight below 180 degrees and run through it above",
       {},
       [] {
         return Cases{
             closed_form("saddle-cone", {{"sectors", 6}, {"sector-angle", 72}, {"rings", 5}}),
             closed_form("saddle-cone", {{"sectors", 8}, {"sector-angle", 90}, {"rings", 5}})};
       },
       distances_are_right},
      {"hardly-curved-saddle-is-exact-too",
       "a saddle vertex whose angle exceeds 360 degrees by next to nothing is handled exactly",
       {},
       hardly_curved_saddles,
       distances_are_right},
      {"cylinder-distances-equal-those-of-the-unrolled-strip",
       "on a cylinder distances are those of the unrolled strip, the shorter way round",
       {},
       [] {
         return Cases{closed_form("cylinder", {{"sides", 18}, {"rows", 6}}),
                      closed_form("cylinder", {{"sides", 3}, {"rows", 9}})};
       },
       distances_are_right},
      {"square-with-hole-paths-bend-at-the-corners-of-the-hole",
       "around a hole paths bend at its corners: boundary vertices are pseudo-sources",
       {},
       [] {
         return Cases{closed_form("square-with-hole", {{"hole", 3}, {"rim", 3}}),
                      closed_form("square-with-hole", {{"hole", 6}, {"rim", 2}})};
       },
       distances_are_right},
  };
}

}  // namespace geodesic::conformance
