// Properties of recordings: they change no distance, and their values are plausible.
#include <algorithm>

#include "harness/verify/properties/properties.h"

namespace geodesic::harness {
namespace {

void change_no_distance(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  Recording recording;
  const auto recorded = trial.solve(*solver, query, &recording);
  require("recorded, beside a timed solve",
          same_bits(query, recorded, trial.solve(*solver, query)));
}

void repeat_on_every_run(const Trial& trial) {
  const auto solver = trial.prepare();
  Recording first, second;
  trial.solve(*solver, trial.query(), &first);
  trial.solve(*solver, trial.query(), &second);
  if (first == Recording{}) return;  // it counts nothing
  require(first == second, "a counter changed from one solve to the next");
  trial.solve(*solver, trial.query(), &second);
  require(first == second, "a recording that is used again keeps what it counted before");
}

// The value of a counter, with the least and the largest value that its definition allows.
struct Bound {
  const char* counter;
  std::optional<std::uint64_t> value;
  std::uint64_t least;
  std::optional<std::uint64_t> most = {};

  void check() const {
    if (!value) return;
    const bool below = *value < least, above = most && *value > *most;
    require(!below && !above,
            std::string(counter) + ": expected " +
                (above ? "at most " + std::to_string(*most) : "at least " + std::to_string(least)) +
                ", got " + std::to_string(*value));
  }
};

void are_bounded(const Trial& trial) {
  const Mesh& mesh = trial.mesh();
  Recording r;
  trial.solve(mesh, trial.query(), &r);
  std::optional<std::uint64_t> thrice;  // a propagated window and at most two children
  if (r.window_propagations) thrice = 3 * *r.window_propagations;
  for (const Bound& bound : {
           Bound{"window_propagations", r.window_propagations, mesh.vertex_count()},
           Bound{"valid_windows", r.valid_windows, 1, thrice},
           Bound{"window_limit", r.window_limit, mesh.edge_count() / 2},
           Bound{"peak_wavefront", r.peak_wavefront, 3, thrice},
           // A geodesic on this rough sphere crosses several faces and none twice.
           Bound{"strip_depth", r.strip_depth, 4, mesh.face_count()},
           Bound{"window_bytes", r.window_bytes, 4 * sizeof(double), 512},
       }) {
    bound.check();
  }
  if (!r.wavefront_sd) return;
  require(*r.wavefront_sd > 0 && *r.wavefront_sd < 4,
          "wavefront_sd is not between 0 and the diameter");
}

// On one triangle a window starts opposite to the source and is propagated across no face.
void count_nothing_beyond_a_triangle(const Trial& trial) {
  Recording r;
  trial.solve(trial.mesh(), trial.query(), &r);
  for (const Bound& bound : {Bound{"window_propagations", r.window_propagations, 0, 1},
                             Bound{"strip_depth", r.strip_depth, 0, 1}}) {
    bound.check();
  }
}

void phase_times_change_nothing(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  Recording before, after, timed;
  timed.kind = RecordingKind::phase_times;
  const auto counted = trial.solve(*solver, query, &before);
  require("with phases timed", same_bits(query, trial.solve(*solver, query, &timed), counted));
  require("after phases were timed", same_bits(query, trial.solve(*solver, query), counted));
  trial.solve(*solver, query, &after);
  require(before == after, "a counter changed after phases were timed");
  require(!before.phase_times, "phase times were recorded without being requested");
}

void phase_times_hold_nothing_else(const Trial& trial) {
  Recording counters, timed;
  timed.kind = RecordingKind::phase_times;
  trial.solve(trial.mesh(), trial.query(), &counters);
  trial.solve(trial.mesh(), trial.query(), &timed);
  if (!timed.phase_times) return;
  require(counters.window_propagations.has_value(),
          "a solver that has phase times does not count windows");
  const PhaseTimes& phases = *timed.phase_times;
  const bool complete = phases.propagation.readings > 0 && phases.trimming.readings > 0 &&
                        phases.queue.readings > trial.mesh().vertex_count() &&
                        phases.propagation.seconds > 0;
  require(complete, "a phase was never entered");
  Recording only;
  only.kind = timed.kind;
  only.phase_times = timed.phase_times;
  require(timed == only, "something else was recorded beside the phase times");
}

// Checks that the windows of every edge are in order, without overlap and within the edge. Collects
// for each vertex the least distance by the windows of its edges.
class WindowsCheck {
 public:
  WindowsCheck(const Mesh& mesh, const Query& query)
      : mesh_(mesh), nearest_(mesh.vertex_count(), kInfinity) {
    for (const Source& source : query.sources) nearest_[source.at.vertex] = source.distance;
  }

  void read(const FinalWindows& windows_on) {
    ++calls_;
    std::vector<Window> windows;
    for (Index h = 0; h < mesh_.half_edge_count(); ++h) {
      windows_on(h, windows);
      check_edge(h, windows);
    }
  }

  int calls() const { return calls_; }
  /// Distances of the vertices by the windows alone.
  const std::vector<double>& nearest() const { return nearest_; }

 private:
  void check_edge(Index h, const std::vector<Window>& windows) {
    const Index own = std::min(h, mesh_.twin(h));
    const double length = mesh_.half_edge(own).length;
    double end = 0;
    for (const Window& w : windows) {
      require(end <= w.begin && w.begin < w.end && w.end <= length,
              "half-edge " + std::to_string(h) +
                  " has windows that overlap, are empty or leave the edge");
      end = w.end;
      double& at_origin = nearest_[mesh_.origin(own)];
      double& at_head = nearest_[mesh_.head(own)];
      at_origin = std::min(at_origin, distance_at(w, w.begin) + w.begin);
      at_head = std::min(at_head, distance_at(w, w.end) + length - w.end);
    }
  }

  const Mesh& mesh_;
  std::vector<double> nearest_;
  int calls_ = 0;
};

Recording recording_of_windows(const ReadWindows& read) {
  Recording recording;
  recording.kind = RecordingKind::windows;
  recording.read_windows = &read;
  return recording;
}

void windows_give_the_distances(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  const auto distances = trial.solve(*solver, query);
  WindowsCheck check(trial.mesh(), query);
  const ReadWindows read = [&](const FinalWindows& windows_on) { check.read(windows_on); };
  Recording recording = recording_of_windows(read);
  require("with windows handed over",
          same_bits(query, trial.solve(*solver, query, &recording), distances));
  require(check.calls() == 1,
          "the windows were handed over " + std::to_string(check.calls()) + " times");
  require("by the windows alone", check_distances(query, check.nearest(), distances));
}

void windows_are_refused(const Trial& trial) {
  bool called = false;
  const ReadWindows read = [&](const FinalWindows&) { called = true; };
  Recording recording = recording_of_windows(read);
  refused("a request for windows", [&] { trial.solve(trial.mesh(), trial.query(), &recording); });
  require(!called, "windows were handed over before the refusal");
}

Cases triangle() {
  return {{"triangle", {{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}}, {from(0)}}};
}

Cases sphere(std::uint64_t seed, int levels = 2) {
  return one("sphere", rough_sphere(seed, levels, 0.3), from(4));
}

Cases random_meshes_from_vertex_4() { return random_mesh_cases({from(4)}); }

}  // namespace

std::vector<Property> recording_properties() {
  return {
      {"recordings-of-a-single-triangle-count-no-propagation-beyond-it",
       "on one triangle at most one window is propagated", triangle,
       count_nothing_beyond_a_triangle, kNoClaim,
       /*on_any_mesh=*/false},
      {"recordings-of-windows-are-refused-by-solvers-that-keep-none",
       "a solver that declares no final windows throws std::invalid_argument when asked for them",
       [] { return sphere(54, 0); }, windows_are_refused, kNoFinalWindows},
      {"recordings-are-the-same-on-every-run", "counters are the same from one solve to the next",
       [] { return sphere(51); }, repeat_on_every_run, kSameBits},
      {"recordings-of-what-is-counted-are-positive-and-bounded",
       "every counter lies between bounds that follow from its definition",
       [] { return sphere(52); }, are_bounded, kNoClaim,
       /*on_any_mesh=*/false},
      {"recordings-of-phase-times-hold-nothing-else-and-lose-none",
       "timing the phases enters each of them and records nothing beside",
       [] { return sphere(53); }, phase_times_hold_nothing_else, kNoClaim,
       /*on_any_mesh=*/false},
      {"recordings-change-no-distance", "a recorded solve gives the bits of a timed one",
       random_meshes_from_vertex_4, change_no_distance, kSameBits},
      {"recordings-of-phase-times-change-no-distance-and-no-counter",
       "timing the phases changes no bit of a distance and no later counter",
       random_meshes_from_vertex_4, phase_times_change_nothing, kSameBits},
      {"recordings-of-windows-hand-over-those-that-give-the-distances",
       "the windows of every edge are in order and give the distances of its ends",
       random_meshes_from_vertex_4, windows_give_the_distances, kFinalWindows | kSameBits},
  };
}

}  // namespace geodesic::harness
