// A solver object owns its state: it can be asked again, gives the same bits every time, and shares
// nothing that changes with other objects, in whatever thread they are.
#include <thread>

#include "harness/verify/properties/properties.h"

namespace geodesic::conformance {
namespace {

std::vector<Case> torus(const std::vector<Query>& queries) {
  return {{"torus", rough_torus(41, 20, 10, 0.3), queries}};
}

Finding repeats_its_bits(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  const auto first = ask(*solver, trial.mesh(), query);
  const auto second = ask(*solver, trial.mesh(), query);
  if (auto wrong = identical(query, second, first)) return in("asked again", wrong);
  return in("another object", identical(query, trial.solve(query), first));
}

Finding forgets_other_sources(const Trial& trial) {
  const auto solver = trial.prepare();
  for (const Query& query : trial.queries()) ask(*solver, trial.mesh(), query);
  for (const Query& query : trial.queries()) {
    const auto got = ask(*solver, trial.mesh(), query);
    if (auto wrong = identical(query, got, trial.solve(query)))
      return in("after other solves, beside a fresh object", wrong);
  }
  return {};
}

Finding forgets_limits(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  ask(*solver, trial.mesh(), within(1.5 * trial.mesh().mean_edge_length(), query));
  return in("after a limited query",
            identical(query, ask(*solver, trial.mesh(), query), trial.solve(query)));
}

Finding survives_a_refusal(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  if (auto wrong = refused("a query without sources", [&] { ask(*solver, trial.mesh(), Query{}); }))
    return wrong;
  return in("after a refused query",
            identical(query, ask(*solver, trial.mesh(), query), trial.solve(query)));
}

Finding objects_do_not_disturb_each_other(const Trial& trial) {
  const Query& query = trial.query();
  const auto one = trial.prepare(), other = trial.prepare();
  const auto first = ask(*one, trial.mesh(), query);
  ask(*other, trial.mesh(), trial.queries().back());
  return in("after a solve by another object",
            identical(query, ask(*one, trial.mesh(), query), first));
}

// Meant for the thread sanitizer (preset thread) as much as for what it compares.
Finding threads_get_the_bits_of_one(const Trial& trial) {
  struct Thread {
    std::vector<double> plain, counted, timed;
  };
  const std::vector<Query>& queries = trial.queries();
  std::vector<Thread> got(queries.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < queries.size(); ++t) {
      threads.emplace_back([&, t] {
        const auto own = trial.prepare();
        got[t].plain = ask(*own, trial.mesh(), queries[t]);
        Recording counters, phases;
        phases.what = Record::phase_times;
        got[t].counted = ask(*own, trial.mesh(), queries[t], &counters);
        got[t].timed = ask(*own, trial.mesh(), queries[t], &phases);
      });
    }
  }
  const auto solver = trial.prepare();
  for (std::size_t t = 0; t < queries.size(); ++t) {
    const auto alone = ask(*solver, trial.mesh(), queries[t]);
    for (const auto* distances : {&got[t].plain, &got[t].counted, &got[t].timed}) {
      if (auto wrong = identical(queries[t], *distances, alone)) return in("in a thread", wrong);
    }
  }
  return {};
}

}  // namespace

std::vector<Property> repetition_properties() {
  return {
      {"repetition-gives-the-same-bits",
       "the same query gives the same bits, by the same object and by another one",
       {},
       [] { return torus({from(0)}); },
       repeats_its_bits},
      {"repetition-of-another-source-is-as-if-it-were-the-first",
       "an object that solved from other sources gives the bits of a fresh one",
       {},
       [] {
         return torus({from(0), from(77)});
       },
       forgets_other_sources},
      {"repetition-after-a-limited-query-is-unlimited-again",
       "a distance limit ends with its query",
       {kDistanceLimit},
       [] { return torus({from(0)}); },
       forgets_limits},
      {"repetition-after-a-refused-query-works",
       "a refused query leaves the object as it was",
       {},
       [] { return torus({from(3)}); },
       survives_a_refusal},
      {"two-objects-on-one-mesh-do-not-disturb-each-other",
       "what one object solves changes nothing for another one on the same mesh",
       {},
       [] {
         return torus({from(5), from(90)});
       },
       objects_do_not_disturb_each_other},
      {"threads-with-a-solver-each-get-the-bits-of-one-alone",
       "objects that solve in several threads over one mesh give the bits of one alone",
       {},
       [] {
         return std::vector<Case>{
             {"terrain", rough_terrain(61, 12, 12, 0.5), {from(0), from(30), from(60), from(90)}}};
       },
       threads_get_the_bits_of_one},
  };
}

}  // namespace geodesic::conformance
