// Counters: recording changes no distance, and what is counted makes sense.
#include <algorithm>

#include "harness/verify/properties/properties.h"

namespace geodesic::conformance {
namespace {

Finding change_no_distance(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  Recording recording;
  const auto recorded = ask(*solver, trial.mesh(), query, &recording);
  return in("recorded, beside a timed solve",
            identical(query, recorded, ask(*solver, trial.mesh(), query)));
}

Finding repeat_on_every_run(const Trial& trial) {
  const auto solver = trial.prepare();
  Recording first, second;
  ask(*solver, trial.mesh(), trial.query(), &first);
  ask(*solver, trial.mesh(), trial.query(), &second);
  return require(first == second, "a counter changed from one solve to the next");
}

Finding are_bounded(const Trial& trial) {
  const Mesh& mesh = trial.mesh();
  Recording r;
  ask(*trial.prepare(), mesh, trial.query(), &r);
  struct Bound {
    const char* counter;
    std::optional<std::uint64_t> value;
    std::uint64_t least, most;
  };
  constexpr std::uint64_t kNoBound = ~std::uint64_t{0};
  const std::uint64_t thrice =
      r.window_propagations ? 3 * *r.window_propagations : kNoBound;  // a child each, and one
  for (const Bound& bound : {
           Bound{"window_propagations", r.window_propagations, mesh.vertex_count(), kNoBound},
           Bound{"valid_windows", r.valid_windows, 1, thrice},
           Bound{"window_limit", r.window_limit, mesh.edge_count() / 2, kNoBound},
           Bound{"peak_wavefront", r.peak_wavefront, 3, thrice},
           // A geodesic on this rough sphere crosses several faces and none twice.
           Bound{"strip_depth", r.strip_depth, 4, mesh.face_count()},
           Bound{"window_bytes", r.window_bytes, 4 * sizeof(double), 512},
       }) {
    if (!bound.value || (*bound.value >= bound.least && *bound.value <= bound.most)) continue;
    return Failure{.what = std::string(bound.counter) + " is " + std::to_string(*bound.value) +
                           ", not between " + std::to_string(bound.least) + " and " +
                           std::to_string(bound.most)};
  }
  return require(!r.wavefront_sd || (*r.wavefront_sd > 0 && *r.wavefront_sd < 4),
                 "wavefront_sd is not between 0 and the diameter");
}

// On one triangle a window starts opposite to the source and is propagated across no face.
Finding count_nothing_beyond_a_triangle(const Trial& trial) {
  Recording r;
  ask(*trial.prepare(), trial.mesh(), trial.query(), &r);
  if (r.window_propagations.value_or(0) > 1)
    return Failure{.what = "there are " + std::to_string(*r.window_propagations) +
                           " window propagations"};
  return require(r.strip_depth.value_or(0) <= 1, "a strip is longer than the triangle");
}

Finding phase_times_change_nothing(const Trial& trial) {
  const Mesh& mesh = trial.mesh();
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  Recording before, after, timed;
  timed.what = Record::phase_times;
  const auto counted = ask(*solver, mesh, query, &before);
  if (auto wrong = identical(query, ask(*solver, mesh, query, &timed), counted))
    return in("with phases timed", wrong);
  if (auto wrong = identical(query, ask(*solver, mesh, query), counted))
    return in("after phases were timed", wrong);
  ask(*solver, mesh, query, &after);
  if (before != after) return Failure{.what = "a counter changed after phases were timed"};
  return require(!before.phase_times, "phase times were recorded unasked");
}

Finding phase_times_hold_nothing_else(const Trial& trial) {
  const Mesh& mesh = trial.mesh();
  Recording counters, timed;
  timed.what = Record::phase_times;
  ask(*trial.prepare(), mesh, trial.query(), &counters);
  ask(*trial.prepare(), mesh, trial.query(), &timed);
  if (timed.phase_times.has_value() != counters.window_propagations.has_value())
    return Failure{.what = "a solver that counts windows knows its phases, and no other does"};
  if (!timed.phase_times) return {};
  const PhaseTimes& phases = *timed.phase_times;
  const bool complete = phases.propagation.readings > 0 && phases.trimming.readings > 0 &&
                        phases.queue.readings > mesh.vertex_count() &&
                        phases.propagation.seconds > 0;
  if (!complete) return Failure{.what = "a phase was never entered"};
  Recording only;
  only.what = timed.what;
  only.phase_times = timed.phase_times;
  return require(timed == only, "something else was recorded beside the phase times");
}

// On every edge: in order, without overlap, no nearer than the vertices are, and at a vertex the
// nearest of all its edges is as near as the vertex.
class WindowsCheck {
 public:
  WindowsCheck(const Mesh& mesh, const Query& query)
      : mesh_(mesh), nearest_(mesh.vertex_count(), kInfinity) {
    for (const Source& source : query.sources) nearest_[source.vertex] = source.distance;
  }

  void read(const FinalWindows& windows_on) {
    ++calls_;
    std::vector<Window> windows;
    for (Index h = 0; h < mesh_.half_edge_count() && !finding_; ++h) {
      windows_on(h, windows);
      check_edge(h, windows);
    }
  }

  Finding finding() const {
    return finding_ ? finding_
                    : require(calls_ == 1,
                              "the windows were handed over " + std::to_string(calls_) + " times");
  }
  /// By vertex, by the windows alone.
  const std::vector<double>& nearest() const { return nearest_; }

 private:
  void check_edge(Index h, const std::vector<Window>& windows) {
    const Index own = std::min(h, mesh_.twin(h));
    const double length = mesh_.half_edge(own).length;
    double end = 0;
    for (const Window& w : windows) {
      if (!(end <= w.begin && w.begin < w.end && w.end <= length)) {
        finding_ = Failure{.what = "half-edge " + std::to_string(h) +
                                   " has windows that overlap, are empty or leave the edge"};
        return;
      }
      end = w.end;
      double& at_origin = nearest_[mesh_.origin(own)];
      double& at_head = nearest_[mesh_.head(own)];
      at_origin = std::min(at_origin, distance_at(w, w.begin) + w.begin);
      at_head = std::min(at_head, distance_at(w, w.end) + length - w.end);
    }
  }

  const Mesh& mesh_;
  std::vector<double> nearest_;
  Finding finding_;
  int calls_ = 0;
};

Finding windows_give_the_distances(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  const auto distances = ask(*solver, trial.mesh(), query);
  WindowsCheck check(trial.mesh(), query);
  const ReadWindows read = [&](const FinalWindows& windows_on) { check.read(windows_on); };
  Recording recording;
  recording.what = Record::windows;
  recording.read_windows = &read;
  if (auto wrong = identical(query, ask(*solver, trial.mesh(), query, &recording), distances))
    return in("with windows handed over", wrong);
  if (auto wrong = check.finding()) return wrong;
  return in("by the windows alone", agree(query, check.nearest(), distances));
}

Finding windows_are_refused(const Trial& trial) {
  bool called = false;
  const ReadWindows read = [&](const FinalWindows&) { called = true; };
  Recording recording;
  recording.what = Record::windows;
  recording.read_windows = &read;
  if (auto wrong = refused("the wish for windows",
                           [&] { ask(*trial.prepare(), trial.mesh(), trial.query(), &recording); }))
    return wrong;
  return require(!called, "windows were handed over before the refusal");
}

std::vector<Case> sphere(std::uint64_t seed, int levels) {
  return {{"sphere", rough_sphere(seed, levels, 0.3), {from(4)}}};
}

std::vector<Case> random_meshes_from_vertex_4() { return random_mesh_cases({from(4)}); }

}  // namespace

std::vector<Property> recording_properties() {
  return {
      {"recordings-of-a-single-triangle-count-no-propagation-beyond-it",
       "on one triangle at most one window is propagated",
       {},
       [] {
         return std::vector<Case>{
             {"triangle", {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}, {from(0)}}};
       },
       count_nothing_beyond_a_triangle,
       /*on_any_mesh=*/false},
      {"recordings-of-windows-are-refused-by-solvers-that-keep-none",
       "a solver that declares no final windows throws std::invalid_argument when asked for them",
       {kNoFinalWindows},
       [] { return sphere(54, 0); },
       windows_are_refused},
      {"recordings-are-the-same-on-every-run",
       "counters are the same from one solve to the next",
       {},
       [] { return sphere(51, 2); },
       repeat_on_every_run},
      {"recordings-of-what-is-counted-are-positive-and-bounded",
       "every counter lies between bounds that follow from its definition",
       {},
       [] { return sphere(52, 2); },
       are_bounded,
       /*on_any_mesh=*/false},
      {"recordings-of-phase-times-hold-nothing-else-and-lose-none",
       "timing the phases enters each of them and records nothing beside",
       {},
       [] { return sphere(53, 2); },
       phase_times_hold_nothing_else,
       /*on_any_mesh=*/false},
      {"recordings-change-no-distance",
       "a recorded solve gives the bits of a timed one",
       {},
       random_meshes_from_vertex_4,
       change_no_distance},
      {"recordings-of-phase-times-change-no-distance-and-no-counter",
       "timing the phases changes no bit of a distance and no later counter",
       {},
       random_meshes_from_vertex_4,
       phase_times_change_nothing},
      {"recordings-of-windows-hand-over-those-that-give-the-distances",
       "the windows of every edge are in order and give the distances of its ends",
       {kFinalWindows},
       random_meshes_from_vertex_4,
       windows_give_the_distances},
  };
}

}  // namespace geodesic::conformance
