// What must not depend on how a mesh is written down: unit of length, numbers of vertices, order
// and first corner of faces.
#include <algorithm>
#include <numeric>
#include <utility>

#include "harness/verify/properties/properties.h"
#include "meshes/random.h"

namespace geodesic::conformance {
namespace {

std::vector<std::optional<std::uint64_t>> counters(const Recording& r) {
  return {r.window_propagations, r.valid_windows, r.window_limit,
          r.peak_wavefront,      r.strip_depth,   r.window_bytes};
}

TriangleSoup scaled(TriangleSoup soup, double factor) {
  for (Vec3& p : soup.positions) {
    for (double& c : p) c *= factor;
  }
  return soup;
}

Finding scales_exactly(const Trial& trial) {
  const Query& query = trial.query();
  Recording recording;
  const auto distances = ask(*trial.prepare(), trial.mesh(), query, &recording);
  for (const double factor : {0x1p10, 0x1p-30}) {
    const std::string times = "scaled by " + std::to_string(factor);
    const Mesh other(scaled(trial.soup(), factor));
    Recording other_recording;
    auto other_distances = ask(*trial.prepare(other), other, query, &other_recording);
    for (double& d : other_distances) d /= factor;
    if (auto wrong = identical(query, other_distances, distances)) return in(times, wrong);
    if (counters(other_recording) != counters(recording))
      return Failure{.what = times + ": a counter changed", .query = query};
  }
  return {};
}

std::vector<Index> shuffled(Index count, Random& random) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  for (Index i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

Finding keeps_distances_when_renumbered(const Trial& trial) {
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
  for (Source& source : other_query.sources) source.vertex = renumbered[source.vertex];
  const auto distances = trial.solve(Mesh(other), other_query);
  std::vector<double> in_old_order;
  for (const Index v : renumbered) in_old_order.push_back(distances[v]);
  return in("with vertices renumbered", agree(query, in_old_order, trial.solve(query)));
}

Finding keeps_distances_along_the_surface(const Trial& trial) {
  const Mesh renumbered(trial.soup(), Numbering::along_surface);
  for (const Query& query : trial.queries()) {
    if (auto wrong = agree(query, trial.solve(renumbered, query), trial.solve(query)))
      return in("numbered along the surface", wrong);
  }
  return {};
}

Finding keeps_distances_when_faces_are_reordered(const Trial& trial) {
  Random random(32);
  TriangleSoup other{trial.soup().positions, {}};
  for (const Index f : shuffled(trial.mesh().face_count(), random)) {
    Triangle t = trial.soup().triangles[f];
    std::rotate(t.begin(), t.begin() + random.below(3), t.end());
    other.triangles.push_back(t);
  }
  const Query& query = trial.query();
  return in("with faces reordered and rotated",
            agree(query, trial.solve(Mesh(other), query), trial.solve(query)));
}

Finding keeps_distances_inside_out(const Trial& trial) {
  TriangleSoup other = trial.soup();
  for (Triangle& t : other.triangles) std::swap(t[1], t[2]);
  const Query& query = trial.query();
  return in("turned inside out", agree(query, trial.solve(Mesh(other), query), trial.solve(query)));
}

std::vector<Case> from_its_ends() {
  std::vector<Case> cases = random_mesh_cases({});
  for (Case& each : cases) {
    each.queries = {from(0), from(static_cast<Index>(each.soup.positions.size()) - 1)};
  }
  return cases;
}

std::vector<Case> from_vertex_2() { return random_mesh_cases({from(2)}); }

}  // namespace

std::vector<Property> invariance_properties() {
  return {
      {"scaling-by-a-power-of-two-scales-distances-exactly-and-keeps-counters",
       "in a unit of length 2^n times as long, distances differ by exactly that factor",
       {},
       [] { return random_mesh_cases({from(1)}); },
       scales_exactly},
      {"renumbered-vertices-keep-their-distances",
       "distances do not depend on the numbers of vertices",
       {kExactDistances},
       from_vertex_2,
       keeps_distances_when_renumbered},
      {"numbering-along-the-surface-keeps-distances-and-sources",
       "a mesh that numbers its vertices along its surface takes sources and gives distances by "
       "the "
       "numbers given",
       {},
       from_its_ends,
       keeps_distances_along_the_surface},
      {"reordered-and-rotated-faces-keep-the-distances",
       "distances depend neither on the order of faces nor on their first corner",
       {kExactDistances},
       from_vertex_2,
       keeps_distances_when_faces_are_reordered},
      {"mesh-turned-inside-out-keeps-the-distances",
       "distances do not depend on which side is outside",
       {kExactDistances},
       from_vertex_2,
       keeps_distances_inside_out},
  };
}

}  // namespace geodesic::conformance
