// A query must have the same answer by an object that has solved before, in other threads, by other
// instructions, and for other numberings, units and orientations of the mesh.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <thread>
#include <utility>

#include "harness/verify/properties/properties.h"
#include "meshes/random.h"
#include "solvers/core/instruction_set.h"

namespace geodesic::harness {
namespace {

template <class... Sources>
Cases torus(Sources... sources) {
  return {{"torus", rough_torus(41, 20, 10, 0.3), {from(sources)...}}};
}

void repeats_its_bits(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  const auto first = trial.solve(*solver, query);
  require("asked again", same_bits(query, trial.solve(*solver, query), first));
  require("another object", same_bits(query, trial.solve(query), first));
}

void forgets_other_sources(const Trial& trial) {
  const auto solver = trial.prepare();
  for (const Query& query : trial.queries()) trial.solve(*solver, query);
  for (const Query& query : trial.queries()) {
    require("after other solves, beside a new object",
            same_bits(query, trial.solve(*solver, query), trial.solve(query)));
  }
}

// @param before a query of the same object
void unchanged_after(const Query& before, const std::string& what, const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  if (before.sources.empty()) {
    refused(what, [&] { trial.solve(*solver, before); });
  } else {
    trial.solve(*solver, before);
  }
  require("after " + what, same_bits(query, trial.solve(*solver, query), trial.solve(query)));
}

void forgets_limits(const Trial& trial) {
  unchanged_after(within(1.5 * trial.mesh().mean_edge_length(), trial.query()), "a limited query",
                  trial);
}

void survives_a_refusal(const Trial& trial) {
  unchanged_after(Query{}, "a query without sources", trial);
}

void objects_do_not_disturb_each_other(const Trial& trial) {
  const Query& query = trial.query();
  const auto one = trial.prepare(), other = trial.prepare();
  const auto first = trial.solve(*one, query);
  trial.solve(*other, trial.queries().back());
  require("after a solve by another object", same_bits(query, trial.solve(*one, query), first));
}

Cases terrain_from_four_vertices() {
  return {{"terrain", rough_terrain(61, 12, 12, 0.5), {from(0), from(30), from(60), from(90)}}};
}

// Distances of a timed solve, of a solve with counters and of a solve with phase times.
std::vector<std::vector<double>> solved_in_three_ways(const Trial& trial, const Query& query) {
  const auto own = trial.prepare();
  Recording counters, phases;
  phases.kind = RecordingKind::phase_times;
  std::vector<std::vector<double>> distances;
  for (Recording* recording : {static_cast<Recording*>(nullptr), &counters, &phases}) {
    distances.push_back(trial.solve(*own, query, recording));
  }
  return distances;
}

// The check also gives the thread sanitizer (preset thread) something to examine.
void threads_get_the_bits_of_one(const Trial& trial) {
  const std::vector<Query>& queries = trial.queries();
  std::vector<std::vector<std::vector<double>>> got(queries.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < queries.size(); ++t) {
      threads.emplace_back([&, t] { got[t] = solved_in_three_ways(trial, queries[t]); });
    }
  }
  const auto solver = trial.prepare();
  for (std::size_t t = 0; t < queries.size(); ++t) {
    const auto alone = trial.solve(*solver, queries[t]);
    for (const std::vector<double>& distances : got[t]) {
      require("in a thread", same_bits(queries[t], distances, alone));
    }
  }
}

Query scaled_query(Query query, double factor) {
  query.limit *= factor;
  for (Source& source : query.sources) source.distance *= factor;
  return query;
}

// In other units of length, only exponents change.
void scales_exactly(const Trial& trial, std::initializer_list<int> powers_of_two) {
  const Query& query = trial.query();
  Recording recording;
  const auto distances = trial.solve(trial.mesh(), query, &recording);
  for (const int power : powers_of_two) {
    const std::string circumstances = "times 2^" + std::to_string(power);
    const double factor = std::ldexp(1, power);
    const Mesh other(scaled(trial.soup(), factor));
    Recording other_recording;
    auto got = trial.solve(other, scaled_query(query, factor), &other_recording);
    for (double& d : got) d /= factor;
    require(circumstances, same_bits(query, got, distances));
    if (other_recording.wavefront_sd) *other_recording.wavefront_sd /= factor;
    require(other_recording == recording, circumstances + ": a counter changed");
  }
}

void scales_to_some_units(const Trial& trial) { scales_exactly(trial, {10, -30}); }

// About 10^18 and 10^-18.
void scales_to_far_units(const Trial& trial) { scales_exactly(trial, {60, -60}); }

// Coordinates are multiples of 2^-20.
Cases on_a_lattice() {
  Cases cases = {{"terrain", rough_terrain(87, 9, 9, 1.5), {from(4)}},
                 {"sphere", rough_sphere(88, 2, 0.3), {from(4)}}};
  for (Case& each : cases) {
    for (Vec3& p : each.soup.positions) {
      for (double& c : p) c = std::ldexp(std::nearbyint(std::ldexp(c, 20)), -20);
    }
  }
  return cases;
}

// Moves the mesh by a lattice vector about 10^9 long. Differences of coordinates keep every bit.
void moves_far_away(const Trial& trial) {
  const Query& query = trial.query();
  TriangleSoup moved = trial.soup();
  for (Vec3& p : moved.positions) p = add(p, {0x1p30, -0x1p30, 0x1p29});
  const Mesh other(moved);
  require("moved by 2^30", same_bits(query, trial.solve(other, query), trial.solve(query)));
}

// Initial distances and the limit are in the unit of length, too.
Cases for_far_units() {
  const Query query{.sources = {{1, 0.5}, {9, 0}}, .limit = 6};
  return {{"terrain", rough_terrain(85, 9, 9, 1.5), {query}},
          {"sphere", rough_sphere(86, 1, 0.3), {query}},
          {"torus", rough_torus(87, 10, 8, 0.3), {query}}};
}

std::vector<Index> shuffled(Index count, Random& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  for (Index i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

void keeps_distances_when_renumbered(const Trial& trial) {
  const Query& query = trial.query();
  Random random(31);
  const std::vector<Index> renumbered = shuffled(trial.mesh().vertex_count(), random);
  TriangleSoup other = trial.soup();
  for (Index v = 0; v < trial.mesh().vertex_count(); ++v) {
    other.positions[renumbered[v]] = trial.soup().positions[v];
  }
  for (Triangle& t : other.triangles) {
    for (Index& v : t) v = renumbered[v];
  }
  Query other_query = query;
  for (Source& source : other_query.sources) source.at.vertex = renumbered[source.at.vertex];
  const auto distances = trial.solve(Mesh(other), other_query);
  std::vector<double> in_old_order;
  for (const Index v : renumbered) in_old_order.push_back(distances[v]);
  require("with vertices renumbered", check_distances(query, in_old_order, trial.solve(query)));
}

// Inexact distances may depend on the order of vertices.
void keeps_distances_along_the_surface(const Trial& trial) {
  const bool exact = trial.solver().exactness == Exactness::exact;
  const Mesh renumbered(trial.soup(), Numbering::along_surface);
  for (const Query& query : trial.queries()) {
    const auto expected = exact ? trial.solve(query) : trial.expected(query);
    require("numbered along the surface",
            trial.correct(query, trial.solve(renumbered, query), expected));
  }
}

void keeps_distances_when_faces_are_reordered(const Trial& trial) {
  Random random(32);
  TriangleSoup other{trial.soup().positions, {}};
  for (const Index f : shuffled(trial.mesh().face_count(), random)) {
    Triangle t = trial.soup().triangles[f];
    std::rotate(t.begin(), t.begin() + random.below(3), t.end());
    other.triangles.push_back(t);
  }
  const Query& query = trial.query();
  require("with faces reordered and rotated",
          check_distances(query, trial.solve(Mesh(other), query), trial.solve(query)));
}

void keeps_distances_inside_out(const Trial& trial) {
  TriangleSoup other = trial.soup();
  for (Triangle& t : other.triangles) std::swap(t[1], t[2]);
  const Query& query = trial.query();
  require("turned inside out",
          check_distances(query, trial.solve(Mesh(other), query), trial.solve(query)));
}

Cases random_meshes_from_vertex_2() { return random_mesh_cases({from(2)}); }

// Prepares objects for instruction sets, and restores the previous choice of the process.
class InstructionSets {
 public:
  explicit InstructionSets(const Trial& trial) : trial_(trial) {}
  ~InstructionSets() { set_instruction_set(before_); }
  InstructionSets(const InstructionSets&) = delete;
  InstructionSets& operator=(const InstructionSets&) = delete;

  std::unique_ptr<Solver> prepare(InstructionSet set) const {
    set_instruction_set(set);
    return trial_.prepare();
  }

 private:
  const Trial& trial_;
  const InstructionSet before_ = instruction_set();
};

// Compares distances and counters of plain instructions with those of the widest ones.
void same_bits_and_counters(const Trial& trial) {
  const InstructionSets sets(trial);
  const Query& query = trial.query();
  const auto plain = sets.prepare(InstructionSet::plain);
  const auto wide = sets.prepare(widest_instruction_set());
  if (wide->instruction_set() == plain->instruction_set()) return;  // there is only one code path
  require("by the widest instructions, beside plain ones",
          same_bits(query, trial.solve(*wide, query), trial.solve(*plain, query)));
  Recording by_plain, by_wide;
  set_instruction_set(InstructionSet::plain);  // must not matter any more
  const auto recorded = trial.solve(*wide, query, &by_wide);
  require("recorded, by the widest instructions",
          same_bits(query, recorded, trial.solve(*plain, query, &by_plain)));
  require(by_wide == by_plain, "by the widest instructions a counter changed");
}

void never_wider_than_chosen(const Trial& trial) {
  require(InstructionSets(trial).prepare(InstructionSet::plain)->instruction_set() ==
              InstructionSet::plain,
          "a solver that was constructed for plain instructions uses others");
}

Cases small_sphere() { return one("sphere", rough_sphere(74, 1, 0.2), from(0)); }

Cases lists_of_many_windows() {
  return {{"terrain", rough_terrain(71, 50, 50, 0.1), {from(7)}},
          {"sphere", rough_sphere(72, 4, 0.02), {from(7)}},
          {"torus", rough_torus(73, 60, 30, 0.5), {from(7)}}};
}

Cases holes_and_missing_faces() {
  Cases cases;
  for (std::uint64_t seed = 80; seed < 90; ++seed) {
    const auto terrain = rough_terrain(seed, 12, 12, 0.5);
    const std::string number = std::to_string(seed);
    cases.push_back({"holes " + number, with_holes(terrain, seed, 4), {from(0)}});
    cases.push_back({"gaps " + number, with_missing_faces(terrain, seed, 9), {from(0)}});
  }
  return cases;
}

}  // namespace

std::vector<Property> repetition_properties() {
  return {
      {"repetition-gives-the-same-bits",
       "the same query gives the same bits, by the same object and by another one",
       [] { return torus(0u); }, repeats_its_bits, kSameBits},
      {"repetition-of-another-source-is-as-if-it-were-the-first",
       "an object that solved from other sources gives the bits of a new one",
       [] { return torus(0u, 77u); }, forgets_other_sources, kSameBits},
      {"repetition-after-a-limited-query-is-unlimited-again",
       "a distance limit ends with its query", [] { return torus(0u); }, forgets_limits,
       kDistanceLimit | kSameBits},
      {"repetition-after-a-refused-query-works", "a refused query leaves the object as it was",
       [] { return torus(3u); }, survives_a_refusal, kSameBits},
      {"two-objects-on-one-mesh-do-not-disturb-each-other",
       "what one object solves changes nothing for another one on the same mesh",
       [] { return torus(5u, 90u); }, objects_do_not_disturb_each_other, kSameBits},
      {"threads-with-a-solver-each-get-the-bits-of-one-alone",
       "objects that solve in several threads over one mesh give the bits of one alone",
       terrain_from_four_vertices, threads_get_the_bits_of_one, kSameBits | kConcurrentObjects},
  };
}

std::vector<Property> invariance_properties() {
  return {
      {"scaling-by-a-power-of-two-scales-distances-exactly-and-keeps-counters",
       "in a unit of length 2^n times as long, distances differ by exactly that factor",
       [] { return random_mesh_cases({from(1)}); }, scales_to_some_units, kSameBits},
      {"units-of-length-far-from-one-change-exponents-only",
       "in a unit 2^60 times as long or as short, about 10^18, distances and recordings have "
       "other exponents and the same bits besides",
       for_far_units, scales_to_far_units,
       kMultipleSources | kInitialDistances | kDistanceLimit | kSameBits},
      {"surfaces-moved-by-1e9-keep-every-bit",
       "where coordinates stay exact, distances do not depend on where the surface lies",
       on_a_lattice, moves_far_away, kSameBits | kOwnKernel, /*on_any_mesh=*/false},
      {"renumbered-vertices-keep-their-distances",
       "distances do not depend on the numbers of vertices", random_meshes_from_vertex_2,
       keeps_distances_when_renumbered, kExactDistances},
      {"numbering-along-the-surface-keeps-distances-and-sources",
       "a mesh that numbers its vertices along its surface takes sources and gives distances by "
       "the numbers given",
       random_meshes_from_some_sources, keeps_distances_along_the_surface},
      {"reordered-and-rotated-faces-keep-the-distances",
       "distances depend neither on the order of faces nor on their first corner",
       random_meshes_from_vertex_2, keeps_distances_when_faces_are_reordered, kExactDistances},
      {"mesh-turned-inside-out-keeps-the-distances",
       "distances do not depend on which side is outside", random_meshes_from_vertex_2,
       keeps_distances_inside_out, kExactDistances},
      {"instruction-sets-are-never-wider-than-the-one-chosen",
       "a solver that is constructed for plain instructions uses no others", small_sphere,
       never_wider_than_chosen},
      {"instruction-sets-give-the-same-bits-and-counters",
       "vector instructions change neither a bit of a distance nor a counter",
       [] { return random_mesh_cases({from(4)}); }, same_bits_and_counters, kSameBits},
      {"instruction-sets-give-the-same-bits-and-counters-with-holes-and-missing-faces",
       "vector instructions change neither a bit nor a counter on ragged surfaces",
       holes_and_missing_faces, same_bits_and_counters, kSameBits},
      {"instruction-sets-give-the-same-bits-and-counters-on-lists-of-many-windows",
       "vector instructions change neither a bit nor a counter where edges have many windows",
       lists_of_many_windows, same_bits_and_counters, kSameBits},
  };
}

}  // namespace geodesic::harness
