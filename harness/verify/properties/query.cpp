// Queries: what is refused, and the distance limit.
#include <algorithm>
#include <cmath>

#include "harness/verify/properties/properties.h"

namespace geodesic::conformance {
namespace {

std::vector<Case> small_terrain() { return {{"terrain", rough_terrain(62, 3, 3, 1), {from(0)}}}; }

Finding refuses(const Trial& trial, const std::string& what, const Query& query) {
  return refused(what, [&] { trial.solve(query); });
}

Finding refuses_sources_elsewhere(const Trial& trial) {
  for (const Index source : {trial.mesh().vertex_count(), kNone}) {
    const std::string what = "source vertex " + std::to_string(source);
    if (auto wrong = refuses(trial, what, from(source))) return wrong;
  }
  return {};
}

Finding refuses_bad_initial_distances(const Trial& trial) {
  for (const double d : {-1.0, -1e-300, kInfinity, std::nan("")}) {
    Query query = trial.query();
    query.sources[0].distance = d;
    if (auto wrong = refuses(trial, "an initial distance of " + std::to_string(d), query))
      return wrong;
  }
  return {};
}

Finding refuses_bad_limits(const Trial& trial) {
  for (const double limit : {-1.0, -kInfinity, std::nan("")}) {
    const std::string what = "a limit of " + std::to_string(limit);
    if (auto wrong = refuses(trial, what, within(limit, trial.query()))) return wrong;
  }
  return {};
}

Finding refuses_wrong_room(const Trial& trial) {
  const auto solver = trial.prepare();
  for (const Index room : {trial.mesh().vertex_count() - 1, trial.mesh().vertex_count() + 1}) {
    std::vector<double> distances(room);
    if (auto wrong = refused("room for " + std::to_string(room) + " distances",
                             [&] { solver->solve(trial.query(), distances); }))
      return wrong;
  }
  return {};
}

Finding refuses_what_it_lacks(const Trial& trial) {
  const Description& solver = trial.solver();
  if (!kMultipleSources.made_by(solver)) {
    if (auto wrong = refuses(trial, "a second source", from({0, 1}))) return wrong;
  }
  if (!kInitialDistances.made_by(solver)) {
    Query late = from(0);
    late.sources[0].distance = 1;
    if (auto wrong = refuses(trial, "an initial distance", late)) return wrong;
  }
  if (kDistanceLimit.made_by(solver)) return {};
  return refuses(trial, "a distance limit", within(1, from(0)));
}

Finding names_itself_when_refusing(const Trial& trial) {
  try {
    trial.solve(Query{});
  } catch (const std::invalid_argument& error) {
    return require(std::string(error.what()).find(trial.solver().name) != std::string::npos,
                   std::string("the solver is not named in: ") + error.what());
  }
  return Failure{.what = "a query without sources was accepted"};
}

std::vector<Case> terrain(const Query& query) {
  return {{"terrain", rough_terrain(61, 12, 12, 1), {query}}};
}

Finding limit_keeps_what_is_nearer(const Trial& trial) {
  const std::vector<double> all = trial.solve(trial.query());
  std::vector<double> sorted;
  std::ranges::copy_if(all, std::back_inserter(sorted), [](double d) { return d < kInfinity; });
  std::ranges::sort(sorted);
  for (const std::size_t rank : {std::size_t{1}, sorted.size() / 3, sorted.size() - 2}) {
    if (rank + 1 >= sorted.size()) continue;
    const double limit = (sorted[rank] + sorted[rank + 1]) / 2;
    const Query query = within(limit, trial.query());
    std::vector<double> want = all;
    for (double& d : want) d = d > limit ? kInfinity : d;
    if (auto wrong = trial.correct(query, trial.solve(query), want))
      return in("limit " + std::to_string(limit), wrong);
  }
  return {};
}

}  // namespace

std::vector<Property> query_properties() {
  return {
      {"query-without-a-source-is-refused",
       "a query without sources throws std::invalid_argument",
       {},
       small_terrain,
       [](const Trial& trial) { return refuses(trial, "a query without sources", Query{}); }},
      {"source-that-is-not-in-the-mesh-is-refused",
       "a source that is no vertex of the mesh throws std::invalid_argument",
       {},
       small_terrain,
       refuses_sources_elsewhere},
      {"initial-distance-that-is-negative-or-not-finite-is-refused",
       "a negative, infinite or undefined initial distance throws std::invalid_argument",
       {},
       small_terrain,
       refuses_bad_initial_distances},
      {"limit-that-is-negative-or-not-a-number-is-refused",
       "a negative or undefined distance limit throws std::invalid_argument",
       {},
       small_terrain,
       refuses_bad_limits},
      {"room-for-too-few-or-too-many-distances-is-refused",
       "a span that has not one entry a vertex throws std::invalid_argument",
       {},
       small_terrain,
       refuses_wrong_room},
      {"ability-that-the-solver-lacks-is-refused",
       "a query that needs more than the solver claims throws std::invalid_argument",
       {},
       small_terrain,
       refuses_what_it_lacks},
      {"refusals-name-the-solver",
       "the message of a refused query names the solver",
       {},
       small_terrain,
       names_itself_when_refusing},
      {"limit-keeps-what-is-nearer-and-drops-what-is-farther",
       "a distance limit leaves nearer vertices as they are and makes farther ones unreachable",
       {kDistanceLimit},
       [] { return terrain(from(40)); },
       limit_keeps_what_is_nearer},
      {"limit-of-zero-keeps-the-source",
       "within a distance of 0 there is the source alone",
       {kDistanceLimit},
       [] { return terrain(within(0, from(40))); },
       distances_are_right},
      {"limit-beyond-the-mesh-changes-nothing",
       "a limit that no vertex reaches leaves all distances as they are",
       {kDistanceLimit},
       [] { return terrain(within(1e6, from(40))); },
       distances_are_right},
      {"limit-drops-sources-that-start-beyond-it",
       "a source whose initial distance exceeds the limit reaches nothing, itself included",
       {kDistanceLimit, kInitialDistances, kMultipleSources},
       [] {
         return terrain({.sources = {{40, 0}, {0, 5}}, .limit = 1e-3});
       },
       distances_are_right},
  };
}

}  // namespace geodesic::conformance
