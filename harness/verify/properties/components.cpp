// What cannot be reached, and sources that share the work.
#include <numeric>

#include "harness/verify/properties/properties.h"

namespace geodesic::conformance {
namespace {

TriangleSoup with_isolated_vertex_first(const TriangleSoup& soup) {
  return side_by_side({{{5, 5, 5}}, {}}, soup);
}

// A source in the first of two components and, if wished, one in the second.
std::vector<Case> two_components(bool source_in_each) {
  const TriangleSoup first = rough_sphere(1, 1, 0.2);
  const Index in_second = static_cast<Index>(first.positions.size()) + 7;
  return {{"two components",
           side_by_side(first, rough_terrain(2, 4, 4, 1)),
           {source_in_each ? from({3, in_second}) : from(3)}}};
}

Finding isolated_vertex_disturbs_nothing(const Trial& trial) {
  const Query& query = trial.query();
  Query shifted = query;
  for (Source& source : shifted.sources) ++source.vertex;
  std::vector<double> got = trial.solve(Mesh(with_isolated_vertex_first(trial.soup())), shifted);
  if (auto wrong = require(got.front() == kInfinity, "an isolated vertex was reached"))
    return wrong;
  got.erase(got.begin());
  return in("with an isolated vertex before the others", identical(query, got, trial.solve(query)));
}

std::vector<Case> one_triangle() {
  return {{"triangle", {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}, {from(0), from(1)}}};
}

Finding distances_are_exact(const Trial& trial) {
  for (const Query& query : trial.queries()) {
    if (auto wrong = agree(query, trial.solve(query), trial.expected(query))) return wrong;
  }
  return {};
}

Finding least_of_single_sources(const Trial& trial) {
  const Query& query = trial.query();
  std::vector<double> want(trial.mesh().vertex_count(), kInfinity);
  for (const Source& source : query.sources) want = least(want, trial.solve(from(source.vertex)));
  return agree(query, trial.solve(query), want);
}

std::vector<Case> random_meshes_from_four_sources() {
  std::vector<Case> cases = random_mesh_cases({});
  for (Case& each : cases) {
    const Index last = static_cast<Index>(each.soup.positions.size()) - 1;
    each.queries = {from({0, last / 3, last / 3 + 1, last})};
  }
  return cases;
}

std::vector<Case> small_sphere(const std::vector<Index>& sources) {
  return {{"sphere", rough_sphere(4, 1, 0.3), {from(sources)}}};
}

std::vector<Case> sphere_of_sources() {
  std::vector<Index> all(rough_sphere(4, 1, 0.3).positions.size());
  std::iota(all.begin(), all.end(), Index{0});
  return small_sphere(all);
}

std::vector<Case> torus(const std::vector<Source>& sources) {
  return {{"torus", rough_torus(5, 12, 7, 0.2), {{.sources = sources}}}};
}

}  // namespace

std::vector<Property> component_properties() {
  return {
      {"mesh-without-faces-has-only-its-source",
       "without faces, every vertex but the source is infinitely far",
       {},
       [] {
         return std::vector<Case>{{"two points", {{{0, 0, 0}, {1, 0, 0}}, {}}, {from(1)}}};
       },
       distances_are_right},
      {"single-triangle-has-its-edges-for-distances",
       "on one triangle the distances of its corners are its edges",
       {},
       one_triangle,
       distances_are_exact,
       /*on_any_mesh=*/false},
      {"isolated-source-reaches-itself-only",
       "from a vertex without faces no other vertex is reached",
       {},
       [] {
         return std::vector<Case>{{"terrain and a point",
                                   with_isolated_vertex_first(rough_terrain(3, 5, 5, 1)),
                                   {from(0)}}};
       },
       distances_are_right},
      {"isolated-vertex-is-infinitely-far-and-disturbs-nothing",
       "a vertex without faces is unreachable, and the others keep the bits of their distances",
       {},
       [] {
         return std::vector<Case>{{"terrain", rough_terrain(3, 5, 5, 1), {from(8)}}};
       },
       isolated_vertex_disturbs_nothing},
      {"another-component-is-infinitely-far",
       "vertices of another component are unreachable, those of the source's own have their "
       "distances",
       {},
       [] { return two_components(false); },
       distances_are_right},
      {"source-in-each-component-reaches-both",
       "with a source in each of two components every vertex has the distance from its own",
       {kMultipleSources},
       [] { return two_components(true); },
       distances_are_right},
      {"multiple-sources-give-the-least-of-single-sources",
       "with several sources every vertex has the least of the distances from each alone",
       {kMultipleSources, kExactDistances},
       random_meshes_from_four_sources,
       least_of_single_sources},
      {"sources-named-twice-count-once",
       "a source that is named twice gives the distances of that source",
       {kMultipleSources},
       [] {
         return small_sphere({5, 5});
       },
       distances_are_right},
      {"sources-may-be-all-vertices",
       "when every vertex is a source, every distance is 0",
       {kMultipleSources},
       sphere_of_sources,
       distances_are_right},
      {"initial-distances-are-added-to-every-path-from-their-source",
       "an initial distance is added to all distances from its source",
       {kInitialDistances},
       [] {
         return torus({{10, 2.5}});
       },
       distances_are_right},
      {"initial-distances-decide-which-source-is-nearest",
       "every vertex has the least sum of an initial distance and the way from its source",
       {kInitialDistances, kMultipleSources, kExactDistances},
       [] {
         return torus({{50, 1.25}, {10, 0}});
       },
       distances_are_right},
      {"too-large-initial-distances-make-a-source-an-ordinary-vertex",
       "a source that another one reaches sooner has no effect",
       {kInitialDistances, kMultipleSources},
       [] {
         return torus({{50, 1000}, {10, 0}, {10, 3}});
       },
       distances_are_right},
  };
}

}  // namespace geodesic::conformance
