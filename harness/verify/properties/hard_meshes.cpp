// Properties on unclean meshes, such as scans, and on clean meshes that are extreme.
#include <cmath>
#include <utility>

#include "harness/verify/properties/properties.h"
#include "meshes/messages.h"
#include "solvers/core/window_bound.h"

namespace geodesic::harness {
namespace {

// Two meshes joined at one vertex: number `a` of the first mesh and `b` of the second.
TriangleSoup joined_at_vertex(const TriangleSoup& first, Index a, const TriangleSoup& second,
                              Index b) {
  const Index offset = static_cast<Index>(first.positions.size());
  TriangleSoup both = side_by_side(first, second);
  for (std::size_t v = offset; v < both.positions.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      both.positions[v][k] += first.positions[a][k] - second.positions[b][k];
    }
  }
  for (Triangle& t : both.triangles) {
    for (Index& v : t) v = v == offset + b ? a : v;
  }
  return both;
}

Cases joined_terrains() {
  return {{"joined terrains",
           joined_at_vertex(rough_terrain(1, 5, 5, 1), 35, rough_terrain(2, 5, 5, 1), 0),
           {from(0), from(35), from(50)}}};
}

Cases joined_spheres() {
  return {{"joined spheres",
           joined_at_vertex(rough_sphere(3, 1, 0.2), 7, rough_sphere(4, 1, 0.2), 9),
           {from(0), from(7), from(60)}}};
}

Cases edge_of_three_faces() {
  TriangleSoup soup = rough_terrain(5, 6, 6, 1);
  soup.positions.push_back({3, 3, 5});
  const auto [a, b, c] = soup.triangles[30];
  soup.triangles.push_back({b, a, static_cast<Index>(soup.positions.size() - 1)});
  return {{"terrain with a fin", soup, {from(0), from(20), from(49)}}};
}

Cases flipped_face() {
  TriangleSoup soup = rough_terrain(6, 6, 6, 1);
  std::swap(soup.triangles[33][0], soup.triangles[33][1]);
  return {{"terrain with a flipped face", soup, {from(0), from(20), from(48)}}};
}

Cases ragged_surfaces() {
  Cases cases;
  for (std::uint64_t seed = 70; seed < 80; ++seed) {
    const auto add = [&](const std::string& name, const TriangleSoup& soup) {
      cases.push_back({"ragged " + name + ' ' + std::to_string(seed),
                       with_missing_faces(soup, seed, 4),
                       {from(44)}});
    };
    add("terrain", rough_terrain(seed, 9, 9, 1.5));
    add("sphere", rough_sphere(seed, 2, 0.3));
  }
  return cases;
}

TriangleSoup flat_grid(Index columns, Index rows, const char* diagonal = "alternating") {
  return generate("grid", {{"columns", columns}, {"rows", rows}, {"diagonal", diagonal}});
}

Case from_some_sources(const std::string& name, const TriangleSoup& soup) {
  return {name, soup, some_sources(soup)};
}

// Rough terrains and spheres of four seeds. `change` alters one in `one_in` faces or edges.
Cases changed(TriangleSoup (*change)(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in),
              std::uint32_t one_in, std::uint64_t first_seed, Index cells, int levels) {
  Cases cases;
  for (std::uint64_t seed = first_seed; seed < first_seed + 4; ++seed) {
    const auto add = [&](const std::string& name, const TriangleSoup& soup) {
      cases.push_back(
          from_some_sources(name + ' ' + std::to_string(seed), change(soup, seed, one_in)));
    };
    add("terrain", rough_terrain(seed, cells, cells, 1));
    add("sphere", rough_sphere(seed, levels, 0.2));
  }
  return cases;
}

// From a vertex in the middle of an edge, lines cross faces without area before they reach a face
// with an area.
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

Cases all_in_a_point() {
  TriangleSoup soup = rough_sphere(7, 1, 0.2);
  for (Vec3& p : soup.positions) p = {1, 2, 3};
  return {from_some_sources("a point", soup)};
}

Cases all_on_a_line() {
  TriangleSoup soup = rough_terrain(8, 5, 5, 1);
  for (Vec3& p : soup.positions) p = {p[0], 0, 0};
  return {from_some_sources("a line", soup)};
}

// Lower and upper bounds, for meshes so degenerate that rounding decides which path is shortest.
void distances_are_bounded(const Trial& trial) {
  const Promise promise = Promise::of(trial.solver());
  const Relation nowhere_nearer =
      promise.exactness == Exactness::unbounded ? Relation::same_reach : Relation::upper_bound;
  const auto solver = trial.prepare();
  for (const Query& query : trial.queries()) {
    const auto got = trial.solve(*solver, query);
    const auto lines = straight_lines(trial.soup(), query);
    const Tolerance tolerance{.relative = kExactTolerance + promise.bound};
    require("nearer than the straight line",
            check_distances(query, got, lines, nowhere_nearer, tolerance));
    if (promise.exactness != Exactness::exact) continue;
    require(check_edges(trial.mesh(), query, got));
    require("farther than brute force",
            check_distances(query, got, trial.expected(query), Relation::at_most));
  }
}

// Every other column of a plane is narrower than its neighbour by a large factor.
Case needles(double width, const std::vector<Query>& queries) {
  TriangleSoup soup = flat_grid(10, 6, "backward");
  for (Vec3& p : soup.positions) {
    const double column = std::floor(p[0] / 2);
    p[0] = column + (p[0] > 2 * column ? width : 0);
  }
  return plane_case("needles", soup, queries, soup);
}

Cases needles_of_a_million() { return {needles(1e-6, {from(0), from(38)})}; }

// CGAL 5.5 does not reach vertices behind these needles. The width of a needle has half as many
// digits as its long sides. Rounding moves positions by 10^-16, the bend of a path by 10^-16 times
// the aspect ratio, and the length of the path by the square of that.
Cases needles_of_a_hundred_million() {
  return {needles(1e-8, some_sources(flat_grid(10, 6, "backward")))};
}

// Does not call check_edges: rounding of long distances exceeds the length of an edge of a needle.
void distances_equal_the_known(const Trial& trial) {
  for (const Query& query : trial.queries()) {
    require(trial.correct(query, trial.solve(query), trial.expected(query)));
  }
}

/// A rotated and scaled grid with one more vertex in a face next to vertex `at`.
/// @param ahead the new vertex lies towards this vertex, up to rounding
/// @param distance of the new vertex from `at`, in sides of a cell
TriangleSoup with_vertex_next_to(Index at, Index ahead, double distance) {
  TriangleSoup soup = flat_grid(12, 12);
  const double cos = 1.1 * std::cos(0.3), sin = 1.1 * std::sin(0.3);
  for (Vec3& p : soup.positions) p = {cos * p[0] - sin * p[1], sin * p[0] + cos * p[1], 0};
  const auto towards = [&](Index v) { return subtract(soup.positions[v], soup.positions[at]); };
  const auto is_left = [](const Vec3& a, const Vec3& b) { return a[0] * b[1] > a[1] * b[0]; };
  const Vec3 line = towards(ahead);
  const Index added = static_cast<Index>(soup.positions.size());
  for (Triangle& t : soup.triangles) {
    while (t[0] != at && (t[1] == at || t[2] == at)) t = {t[1], t[2], t[0]};
    const auto [a, b, c] = t;
    if (a != at || !is_left(towards(b), line) || !is_left(line, towards(c))) continue;
    const double part = distance * 1.1 / geodesic::norm(line);
    const Vec3 from = soup.positions[at];
    soup.positions.push_back({from[0] + part * line[0], from[1] + part * line[1], 0});
    t = {a, b, added};
    soup.triangles.insert(soup.triangles.end(), {{b, c, added}, {c, a, added}});
    break;
  }
  return soup;
}

// Rounding rotates the lines from a source past both sides of a vertex that is near to it. The
// distances of the vertices behind that vertex must be right nevertheless.
Cases vertices_next_to_sources() {
  constexpr Index kSource = 6 * 13 + 6;
  Cases cases;
  for (int exponent = -14; exponent <= -2; ++exponent) {
    for (const Index ahead : {2 * 13 + 5u, 3 * 13 + 11u, 9 * 13 + 8u, 11 * 13 + 3u, 5 * 13 + 0u}) {
      const TriangleSoup soup = with_vertex_next_to(kSource, ahead, std::pow(10.0, exponent));
      const Index added = static_cast<Index>(soup.positions.size()) - 1;
      cases.push_back(
          plane_case("1e" + std::to_string(exponent) + " towards vertex " + std::to_string(ahead),
                     soup, {from(kSource), from(added), from(0)}, soup));
    }
  }
  return cases;
}

// A cone and a saddle cone whose apexes have a thousand sectors.
Cases thousand_sectors() {
  return {
      closed_form_case("cone", {{"sectors", 1000}, {"angle", 290}, {"rings", 1}}, {0, 1, 700}),
      closed_form_case("saddle-cone", {{"sectors", 1000}, {"sector-angle", 0.5}, {"rings", 1}},
                       {0, 1, 700}),
  };
}

// A saddle cone whose apex has an angle of 10,000 degrees.
Cases twenty_eight_turns() {
  return {closed_form_case("saddle-cone", {{"sectors", 200}, {"sector-angle", 50}, {"rings", 3}},
                           {0, 1, 350, 601})};
}

// Each of the 400 corners sends windows across 60 degrees of needles.
Cases windows_by_the_square() {
  return {closed_form_case("involute", {{"corners", 400}, {"angle", 300}, {"width", 1}},
                           {0, 200, 500})};
}

Case flat(const std::string& name, const TriangleSoup& soup) {
  return plane_case(name, soup, some_sources(soup), soup);
}

// A triangle in a plane, cut at the centroids of its faces four times. The last 27 vertices have
// valence 3.
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

Cases valence_three() {
  const TriangleSoup tetrahedron{{{0, 0, 0}, {3, 0, 0.2}, {0, 2, -0.1}, {0.7, 0.8, 1.9}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  return {{"tetrahedron", tetrahedron, {from(0), from(3)}},
          flat("a triangle cut at centroids", cut_at_centroids())};
}

// 10,000 faces in a row. A line crosses all faces between its ends.
Cases long_strips() {
  Cases cases;
  for (const char* diagonal : {"alternating", "forward"}) {
    const TriangleSoup soup = flat_grid(5'000, 1, diagonal);
    cases.push_back(plane_case(diagonal, soup, {from(0), from(7'000)}, soup));
  }
  return cases;
}

// 200,000 faces in a row. Vertices 2 i and 2 i + 1 have the abscissa i.
Cases strip_of_200_000_faces() {
  constexpr Index kSquares = 100'000;
  TriangleSoup strip;
  for (Index i = 0; i <= kSquares; ++i) {
    strip.positions.push_back({static_cast<double>(i), 0, 0});
    strip.positions.push_back({static_cast<double>(i), 1, 0});
  }
  for (Index v = 0; v < 2 * kSquares; v += 2) {
    strip.triangles.push_back({v, v + 2, v + 3});
    strip.triangles.push_back({v, v + 3, v + 1});
  }
  return {plane_case("strip", strip, {from(0)}, strip)};
}

/// Rounding adds at most a unit in the last place for every face that a line crosses.
void distances_lose_a_last_place_a_face(const Trial& trial) {
  const std::vector<double> got = trial.solve(trial.query());
  const std::vector<double> expected = trial.expected(trial.query());
  for (Index v = 1; v < got.size(); ++v) {
    const double faces = 2 * trial.mesh().position(v)[0] + 1;
    const double error = std::abs(relative_error(got[v], expected[v]));
    require(error <= 0x1p-53 * faces, "vertex " + std::to_string(v) + ", behind " +
                                          significant(faces) + " faces, is off by " +
                                          significant(error, 3));
  }
}

// The cells of a rough terrain for which `keep` holds.
template <class Keep>
TriangleSoup cells_of_terrain(Index cells, Keep keep) {
  TriangleSoup soup = rough_terrain(81, cells, cells, 0.5);
  std::vector<Triangle> kept;
  for (Index cell = 0; cell < cells * cells; ++cell) {
    if (!keep(cell % cells, cell / cells)) continue;
    const Index first = 2 * cell;
    kept.insert(kept.end(), {soup.triangles[first], soup.triangles[first + 1]});
  }
  soup.triangles = std::move(kept);
  return soup;
}

// 2,048 squares that touch at corners, each with a boundary of its own, and a plate with 400 holes.
Cases boundary_loops() {
  const TriangleSoup board =
      cells_of_terrain(64, [](Index i, Index j) { return (i + j) % 2 == 0; });
  const TriangleSoup plate =
      cells_of_terrain(41, [](Index i, Index j) { return i % 2 == 0 || j % 2 == 0; });
  return {{"checkerboard", board, {from(0), from(2112)}}, {"plate", plate, {from(900)}}};
}

Cases separate_triangles() {
  constexpr Index kTriangles = 100'000;
  TriangleSoup soup;
  for (Index t = 0; t < kTriangles; ++t) {
    const double x = 4.0 * t;
    soup.positions.insert(soup.positions.end(), {{x, 0, 0}, {x + 3, 0, 0}, {x, 4, 0}});
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const Index last = 3 * kTriangles - 2;
  return {{"triangles", soup, {from({4, last})}, [=](const Query&) {
             std::vector<double> distances(std::size_t{3} * kTriangles, kInfinity);
             for (const Index source : {Index{4}, last}) {
               distances[source - 1] = 3;
               distances[source] = 0;
               distances[source + 1] = 5;
             }
             return distances;
           }}};
}

// Saddles whose angle exceeds 360 degrees by about the square of the relief.
Cases nearly_flat() {
  Cases cases;
  for (const double relief : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
    cases.push_back({"terrain", rough_terrain(82, 9, 9, relief), {from(0), from(45)}});
  }
  return cases;
}

// Lines from a vertex of a grid run through other vertices, and many vertices of a box have several
// shortest paths. Windows meet in one point there, and must not multiply.
Cases ties() {
  Cases cases;
  for (const char* diagonal : {"alternating", "forward"}) {
    cases.push_back(closed_form_case(
        "grid", {{"columns", 30}, {"rows", 30}, {"diagonal", diagonal}}, {0, 480}));
    cases.push_back(closed_form_case(
        "box", {{"x-cells", 10}, {"y-cells", 10}, {"z-cells", 10}, {"diagonal", diagonal}},
        {0, 300}));
  }
  return cases;
}

Cases far_units() {
  const TriangleSoup grid = flat_grid(8, 6);
  return {flat("grid of 10^18", scaled(grid, 1e18)),
          flat("grid of 10^-18", scaled(grid, 1e-18)),
          {"terrain of 10^18", scaled(rough_terrain(83, 7, 7, 2), 1e18), {from(9)}},
          {"sphere of 10^-18", scaled(rough_sphere(84, 1, 0.4), 1e-18), {from(9)}}};
}

void distances_are_right_in_windows(const Trial& trial, std::uint64_t most) {
  const auto solver = trial.prepare();
  for (const Query& query : trial.queries()) {
    Recording recording;
    const auto got = trial.solve(*solver, query, &recording);
    require(trial.correct(query, got, trial.expected(query)));
    if (recording.window_propagations.value_or(0) <= most) continue;
    throw Violation{.what = std::to_string(*recording.window_propagations) +
                            " windows were propagated, more than " + std::to_string(most),
                    .query = query};
  }
}

// A solver must stay far below the bound on its windows. A solver for small meshes only may
// propagate windows without a filter.
void distances_are_right_in_few_windows(const Trial& trial) {
  const std::uint64_t part = trial.solver().abilities.max_vertices == kNone ? 1000 : 10;
  distances_are_right_in_windows(trial, window_bound(trial.mesh()) / part);
}

void distances_are_right_in_a_window_a_side(const Trial& trial) {
  distances_are_right_in_windows(trial, trial.mesh().half_edge_count());
}

}  // namespace

std::vector<Property> unclean_mesh_properties() {
  return {
      {"non-manifold-vertex-that-joins-two-terrains-lets-paths-through",
       "paths run from one surface to another through the vertex that both share", joined_terrains},
      {"non-manifold-vertex-that-joins-two-closed-surfaces-lets-paths-through",
       "paths run from one closed surface to another through the vertex that both share",
       joined_spheres},
      {"non-manifold-edge-of-three-faces-is-crossed-at-its-ends-only",
       "an edge of three faces is a boundary of each", edge_of_three_faces},
      {"non-manifold-edges-of-a-flipped-face-are-crossed-at-their-ends-only",
       "edges whose faces are oriented against each other are boundaries of both", flipped_face},
      {"non-manifold-ragged-surfaces-equal-brute-force",
       "on surfaces with many missing faces distances are exact", ragged_surfaces},
      {"needles-in-a-plane-keep-euclid",
       "faces a million times longer than wide leave the distances of a plane Euclid's",
       needles_of_a_million, distances_equal_the_known},
      {"degenerate-all-positions-equal", "where all vertices lie in one point every distance is 0",
       all_in_a_point},
      {"degenerate-all-positions-on-a-line",
       "where all vertices lie on a line distances are between straight lines and ways along edges",
       all_on_a_line, distances_are_bounded, kNoClaim,
       /*on_any_mesh=*/false},
      {"degenerate-zero-length-edges-in-a-plane",
       "in a plane with zero-length edges distances are exact, and 0 along those",
       [] {
         return cases_of(from_some_sources("grid", with_collapsed_edges(flat_grid(8, 8), 1, 12)));
       }},
      {"degenerate-zero-area-faces-in-a-plane",
       "in a plane with zero-area faces distances are exact",
       [] { return cases_of(from_some_sources("grid", with_flat_caps(flat_grid(8, 8), 6, 5))); }},
      {"degenerate-zero-area-faces-in-a-row-let-lines-through",
       "distances are right on a mesh on which solvers were once wrong, cut down from a larger one",
       [] { return cases_of(from_some_sources("flat faces", flat_faces_in_a_row())); }},
      {"degenerate-zero-area-faces-on-a-rough-surface",
       "on a rough surface with zero-area faces distances are exact",
       [] { return changed(with_flat_caps, 6, 12, 7, 1); }},
      {"degenerate-zero-length-edges-on-a-rough-surface",
       "on a rough surface with zero-length edges distances are exact, and 0 along those",
       [] { return changed(with_collapsed_edges, 12, 2, 8, 2); }},
  };
}

std::vector<Property> extreme_mesh_properties() {
  return {
      {"units-of-length-far-from-one-leave-distances-right",
       "with coordinates of 10^18 and 10^-18 distances are exact", far_units},
      {"valence-of-a-thousand-is-exact",
       "around a vertex of a thousand faces distances are those of the unrolled sectors",
       thousand_sectors, distances_are_right_in_few_windows},
      {"saddle-of-ten-thousand-degrees-is-exact",
       "around an apex of 28 turns distances are those of the unrolled sectors", twenty_eight_turns,
       distances_are_right_in_few_windows},
      {"windows-by-the-square-of-faces-are-exact",
       "around an arc, where every corner sends windows over all needles behind it, distances are "
       "those of a string pulled taut",
       windows_by_the_square, distances_are_right},
      {"strips-of-ten-thousand-faces-keep-euclid",
       "along a strip of a plane distances are Euclid's, however many faces a line crosses, and "
       "windows no more than sides of faces",
       long_strips, distances_are_right_in_a_window_a_side, kOwnKernel},
      {"strips-of-200000-faces-lose-a-last-place-a-face",
       "along a strip of 200,000 faces distances are Euclid's to 2^-53, relative, for each face "
       "crossed",
       strip_of_200_000_faces, distances_lose_a_last_place_a_face, kOwnKernel | kExactDistances,
       /*on_any_mesh=*/false},
      {"valence-of-three-is-exact", "where vertices have three faces distances are exact",
       valence_three, distances_are_right_in_few_windows},
      {"saddles-next-to-flat-are-exact",
       "on terrains whose saddles exceed 360 degrees by less and less distances are exact",
       nearly_flat, distances_are_right_in_few_windows},
      {"ties-by-the-hundred-are-exact-and-few-windows",
       "on regular grids and boxes, where windows meet in one point, they do not multiply", ties,
       distances_are_right_in_few_windows},
      {"needles-of-aspect-1e8-keep-euclid",
       "faces 10^8 times longer than wide leave the distances of a plane Euclid's",
       needles_of_a_hundred_million, distances_are_right_in_few_windows, kOwnKernel},
      {"vertices-next-to-a-source-hide-nothing",
       "behind a flat vertex as near to the source as 10^-14 of an edge distances are Euclid's",
       vertices_next_to_sources, distances_are_right, kOwnKernel},
      {"components-by-the-hundred-thousand-are-apart",
       "of 10^5 components those of the sources are reached, and no other", separate_triangles,
       distances_are_right_in_few_windows, kMultipleSources},
      {"boundary-loops-by-the-thousand-are-exact",
       "on surfaces with thousands of boundary loops distances equal those of another exact solver",
       boundary_loops, distances_are_right_in_few_windows},
  };
}

}  // namespace geodesic::harness
