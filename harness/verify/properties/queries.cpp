// Properties of queries: refusals, the distance limit, several sources and unreachable vertices.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "harness/verify/properties/properties.h"

namespace geodesic::harness {
namespace {

Cases small_terrain() { return one("terrain", rough_terrain(62, 3, 3, 1), from(0)); }

void refuses(const Trial& trial, const std::string& what, const Query& query) {
  refused(what, [&] { trial.solve(query); });
}

void refuses_no_source(const Trial& trial) { refuses(trial, "a query without sources", Query{}); }

void refuses_sources_elsewhere(const Trial& trial) {
  for (const Index source : {trial.mesh().vertex_count(), kNone}) {
    const std::string what = "source vertex " + std::to_string(source);
    refuses(trial, what, from(source));
  }
}

void refuses_bad_initial_distances(const Trial& trial) {
  for (const double d : {-1.0, -1e-300, kInfinity, std::nan("")}) {
    Query query = trial.query();
    query.sources[0].distance = d;
    const std::string what = "an initial distance of " + std::to_string(d);
    refuses(trial, what, query);
  }
}

void refuses_bad_limits(const Trial& trial) {
  for (const double limit : {-1.0, -kInfinity, std::nan("")}) {
    const std::string what = "a limit of " + std::to_string(limit);
    refuses(trial, what, within(limit, trial.query()));
  }
}

void refuses_wrong_sizes(const Trial& trial) {
  const auto solver = trial.prepare();
  for (const Index size : {trial.mesh().vertex_count() - 1, trial.mesh().vertex_count() + 1}) {
    std::vector<double> distances(size);
    const std::string what = "room for " + std::to_string(size) + " distances";
    refused(what, [&] { solver->solve(trial.query(), distances); });
  }
}

void refuses_what_it_lacks(const Trial& trial) {
  const Abilities& can = trial.solver().abilities;
  const std::tuple<bool, const char*, Query> abilities[] = {
      {can.multiple_sources, "a second source", from({0, 1})},
      {can.initial_distances, "an initial distance", {.sources = {{0, 1}}}},
      {can.distance_limit, "a distance limit", within(1, from(0))},
      {can.surface_sources,
       "a source in a face",
       {.sources = {{point_in_face(trial.mesh(), 0, {1, 1, 1}), 0}}}},
  };
  for (const auto& [has_it, what, query] : abilities) {
    if (!has_it) refuses(trial, what, query);
  }
  Recording paths;
  paths.kind = RecordingKind::paths;
  if (!can.paths) refused("to record paths", [&] { trial.solve(trial.mesh(), from(0), &paths); });
}

void names_itself_when_refusing(const Trial& trial) {
  std::string what;
  refused("a query without sources", [&] {
    try {
      trial.solve(Query{});
    } catch (const std::invalid_argument& error) {
      what = error.what();
      throw;
    }
  });
  require(what.find(trial.solver().name) != std::string::npos,
          "the solver is not named in: " + what);
}

Cases terrain(const Query& query) { return one("terrain", rough_terrain(61, 12, 12, 1), query); }

// The limit may change distances of a solver that errs to both sides, within its bound. Such a
// solver is compared with the right distances, any other with its own distances without a limit.
void limit_keeps_what_is_nearer(const Trial& trial) {
  const Exactness exactness = trial.solver().exactness;
  const bool own = exactness == Exactness::exact || exactness == Exactness::upper_bound;
  const std::vector<double> all = own ? trial.solve(trial.query()) : trial.expected(trial.query());
  std::vector<double> sorted;
  std::ranges::copy_if(all, std::back_inserter(sorted), [](double d) { return d < kInfinity; });
  std::ranges::sort(sorted);
  if (sorted.size() < 2) return;  // no limit separates distances
  for (const std::size_t rank : {std::size_t{1}, sorted.size() / 3, sorted.size() - 2}) {
    if (rank + 1 >= sorted.size()) continue;
    const double limit = (sorted[rank] + sorted[rank + 1]) / 2;
    const Query query = within(limit, trial.query());
    std::vector<double> expected = all;
    for (double& d : expected) d = d > limit ? kInfinity : d;
    const std::vector<double> got = trial.solve(query);
    require("limit " + std::to_string(limit),
            own ? check_distances(query, got, expected) : trial.correct(query, got, expected));
  }
}

void stopping_keeps_what_is_nearer(const Trial& trial) {
  const Index last = trial.mesh().vertex_count() - 1;
  const std::vector<double> all = trial.solve(trial.query());
  for (const std::vector<SurfacePoint>& targets :
       {std::vector<SurfacePoint>{last / 2}, std::vector<SurfacePoint>{last / 3, last, 0}}) {
    Query query = trial.query();
    query.targets = targets;
    query.stop_at_targets = true;
    double farthest = 0;
    for (const SurfacePoint& target : targets) farthest = std::max(farthest, all[target.vertex]);
    const std::vector<double> got = trial.solve(query);
    std::vector<double> expected = all;
    // Rounding decides whether vertices as far as the farthest target are reached.
    for (Index v = 0; v < all.size(); ++v) {
      if (all[v] > farthest && (all[v] > farthest * (1 + kExactTolerance) || got[v] == kInfinity)) {
        expected[v] = kInfinity;
      }
    }
    require("stopped", trial.correct(query, got, expected));
  }
}

TriangleSoup with_isolated_vertex_first(const TriangleSoup& soup) {
  return side_by_side({{{5, 5, 5}}, {}}, soup);
}

Cases isolated_source() {
  return {
      {"terrain and a point", with_isolated_vertex_first(rough_terrain(3, 5, 5, 1)), {from(0)}}};
}

void isolated_vertex_disturbs_nothing(const Trial& trial) {
  const Query& query = trial.query();
  Query shifted = query;
  for (Source& source : shifted.sources) ++source.at.vertex;
  std::vector<double> got = trial.solve(Mesh(with_isolated_vertex_first(trial.soup())), shifted);
  require(got.front() == kInfinity, "an isolated vertex was reached");
  got.erase(got.begin());
  const bool exact = trial.solver().exactness == Exactness::exact && trial.solver().deterministic;
  require("with an isolated vertex before the others",
          exact ? same_bits(query, got, trial.solve(query))
                : trial.correct(query, got, trial.expected(query)));
}

// A source in the first of two components and, if there are two, one in the second.
Cases two_components(int sources) {
  const TriangleSoup first = rough_sphere(1, 1, 0.2);
  const Index in_second = static_cast<Index>(first.positions.size()) + 7;
  return {{"two components",
           side_by_side(first, rough_terrain(2, 4, 4, 1)),
           {sources == 2 ? from({3, in_second}) : from(3)}}};
}

// Only three meshes: brute force for every solver takes long.
Cases few_meshes_from_four_sources() {
  Cases cases = random_meshes_from_four_sources();
  cases.erase(cases.begin() + 3, cases.end());
  return cases;
}

void least_of_single_sources(const Trial& trial) {
  const Query& query = trial.query();
  std::vector<double> least(trial.mesh().vertex_count(), kInfinity);
  for (const Source& source : query.sources) {
    std::ranges::transform(least, trial.solve(from(source.at.vertex)), least.begin(),
                           [](double a, double b) { return std::min(a, b); });
  }
  require(check_distances(query, trial.solve(query), least));
}

Cases sphere(const Query& query) { return one("sphere", rough_sphere(4, 1, 0.3), query); }

Cases torus(const std::vector<Source>& sources) {
  return {{"torus", rough_torus(5, 12, 7, 0.2), {{.sources = sources}}}};
}

}  // namespace

std::vector<Property> query_properties() {
  return {
      {"query-without-a-source-is-refused", "a query without sources throws std::invalid_argument",
       small_terrain, refuses_no_source},
      {"source-that-is-not-in-the-mesh-is-refused",
       "a source that is not a vertex of the mesh throws std::invalid_argument", small_terrain,
       refuses_sources_elsewhere},
      {"initial-distance-that-is-negative-or-not-finite-is-refused",
       "a negative, infinite or undefined initial distance throws std::invalid_argument",
       small_terrain, refuses_bad_initial_distances},
      {"limit-that-is-negative-or-not-a-number-is-refused",
       "a negative or undefined distance limit throws std::invalid_argument", small_terrain,
       refuses_bad_limits},
      {"room-for-too-few-or-too-many-distances-is-refused",
       "a span that does not have one entry a vertex throws std::invalid_argument", small_terrain,
       refuses_wrong_sizes},
      {"ability-that-the-solver-lacks-is-refused",
       "a query that needs more than the solver claims throws std::invalid_argument", small_terrain,
       refuses_what_it_lacks},
      {"refusals-name-the-solver", "the message of a refused query names the solver", small_terrain,
       names_itself_when_refusing},
      {"limit-keeps-what-is-nearer-and-drops-what-is-farther",
       "a distance limit keeps the distances up to it and makes farther vertices unreachable",
       [] { return terrain(from(40)); }, limit_keeps_what_is_nearer, kDistanceLimit},
      {"stopping-at-targets-keeps-what-is-nearer",
       "a solve that stops at its targets keeps the distances up to the farthest one",
       [] { return terrain(from(40)); }, stopping_keeps_what_is_nearer, kExactDistances},
      {"limit-of-zero-keeps-the-source", "a limit of 0 leaves the source alone",
       [] { return terrain(within(0, from(40))); }, distances_are_right, kDistanceLimit},
      {"limit-beyond-the-mesh-changes-nothing",
       "a limit that no vertex reaches leaves all distances as they are",
       [] { return terrain(within(1e6, from(40))); }, distances_are_right, kDistanceLimit},
      {"limit-drops-sources-that-start-beyond-it",
       "a source whose initial distance exceeds the limit reaches nothing, itself included",
       [] {
         return terrain({.sources = {{40, 0}, {0, 5}}, .limit = 1e-3});
       },
       distances_are_right, kDistanceLimit | kInitialDistances | kMultipleSources},
  };
}

std::vector<Property> component_properties() {
  return {
      {"mesh-without-faces-has-only-its-source",
       "without faces, every vertex but the source is unreachable",
       [] {
         return one("two points", {{{0, 0, 0}, {1, 0, 0}}, {}}, from(1));
       }},
      {"single-triangle-has-its-edges-for-distances",
       "on one triangle the distances of its corners are its edges",
       [] {
         return Cases{
             {"triangle", {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}, {from(0), from(1)}}};
       },
       distances_are_right, kExactDistances,
       /*on_any_mesh=*/false},
      {"isolated-source-reaches-itself-only",
       "from a vertex without faces no other vertex is reached", isolated_source},
      {"isolated-vertex-is-infinitely-far-and-disturbs-nothing",
       "a vertex without faces is unreachable, and the others keep their distances: exact ones the "
       "bits",
       [] { return one("terrain", rough_terrain(3, 5, 5, 1), from(8)); },
       isolated_vertex_disturbs_nothing},
      {"another-component-is-infinitely-far",
       "vertices of other components are unreachable, those of the source's have their distances",
       [] { return two_components(1); }},
      {"source-in-each-component-reaches-both",
       "with a source in each of two components every vertex has the distance from its own",
       [] { return two_components(2); }, distances_are_right, kMultipleSources},
      {"multiple-sources-give-the-least-of-single-sources",
       "with several sources every vertex has the least of the distances from each alone",
       random_meshes_from_four_sources, least_of_single_sources,
       kMultipleSources | kExactDistances},
      {"multiple-sources-are-answered-as-promised",
       "with several sources every distance is what the solver promises of the least one",
       few_meshes_from_four_sources, distances_are_right, kMultipleSources},
      {"sources-named-twice-count-once",
       "a source that is named twice gives the distances of that source",
       [] {
         return sphere(from({5, 5}));
       },
       distances_are_right, kMultipleSources},
      {"sources-may-be-all-vertices", "when every vertex is a source, every distance is 0",
       [] {
         std::vector<Index> all(42);
         std::iota(all.begin(), all.end(), Index{0});
         return sphere(from(all));
       },
       distances_are_right, kMultipleSources},
      {"initial-distances-are-added-to-every-path-from-their-source",
       "an initial distance is added to all distances from its source",
       [] {
         return torus({{10, 2.5}});
       },
       distances_are_right, kInitialDistances},
      {"initial-distances-decide-which-source-is-nearest",
       "every vertex has the least sum of an initial distance and the way from its source",
       [] {
         return torus({{50, 1.25}, {10, 0}});
       },
       distances_are_right, kInitialDistances | kMultipleSources},
      {"too-large-initial-distances-make-a-source-an-ordinary-vertex",
       "a source that a path from another one reaches sooner has no effect",
       [] {
         return torus({{50, 1000}, {10, 0}, {10, 3}});
       },
       distances_are_right, kInitialDistances | kMultipleSources},
  };
}

}  // namespace geodesic::harness
