// Counters: recording changes no distance, and what is counted makes sense.
#include "tests/conformance/solver_test.h"
#include "tests/oracles/random_meshes.h"

namespace geodesic::conformance {
namespace {

class Recordings : public SolverTest {};

TEST_P(Recordings, change_no_distance) {
  for (const auto& [name, soup] : oracles::random_meshes()) {
    const Mesh mesh(soup);
    const auto solver = prepare(mesh);
    Recording recording;
    const auto recorded = ask(*solver, mesh, from(4), &recording);
    EXPECT_TRUE(identical(recorded, ask(*solver, mesh, from(4)))) << name;
  }
}

TEST_P(Recordings, are_the_same_on_every_run) {
  const Mesh mesh(oracles::rough_sphere(51, 2, 0.3));
  const auto solver = prepare(mesh);
  Recording first, second;
  ask(*solver, mesh, from(4), &first);
  ask(*solver, mesh, from(4), &second);
  EXPECT_EQ(first.window_propagations, second.window_propagations);
  EXPECT_EQ(first.valid_windows, second.valid_windows);
  EXPECT_EQ(first.window_limit, second.window_limit);
  EXPECT_EQ(first.peak_wavefront, second.peak_wavefront);
  EXPECT_EQ(first.strip_depth, second.strip_depth);
  EXPECT_EQ(first.wavefront_sd, second.wavefront_sd);
}

TEST_P(Recordings, of_what_is_counted_are_positive_and_bounded) {
  const Mesh mesh(oracles::rough_sphere(52, 2, 0.3));
  Recording r;
  ask(*prepare(mesh), mesh, from(4), &r);
  const auto between = [](const auto& counter, std::uint64_t least, std::uint64_t most) {
    return !counter || (*counter >= least && *counter <= most);
  };
  const std::uint64_t propagations = r.window_propagations.value_or(~std::uint64_t{0});
  EXPECT_PRED3(between, r.window_propagations, mesh.vertex_count(), ~std::uint64_t{0});
  EXPECT_PRED3(between, r.valid_windows, 1, 3 * propagations);
  EXPECT_PRED3(between, r.window_limit, mesh.edge_count() / 2, ~std::uint64_t{0});
  EXPECT_PRED3(between, r.peak_wavefront, 3, 3 * propagations);
  // A geodesic on a rough sphere of 320 faces crosses several and never the same one twice.
  EXPECT_PRED3(between, r.strip_depth, 4, mesh.face_count());
  EXPECT_PRED3(between, r.window_bytes, 4 * sizeof(double), 512);
  if (r.wavefront_sd) {
    EXPECT_GT(*r.wavefront_sd, 0);
    EXPECT_LT(*r.wavefront_sd, 4);
  }
}

// On one triangle a window starts opposite to the source and is propagated across no face.
TEST_P(Recordings, of_a_single_triangle_count_no_propagation_beyond_it) {
  const Mesh mesh(TriangleSoup{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  Recording r;
  ask(*prepare(mesh), mesh, from(0), &r);
  EXPECT_LE(r.window_propagations.value_or(0), 1);
  EXPECT_LE(r.strip_depth.value_or(0), 1);
}

TEST_P(Recordings, of_phase_times_change_no_distance_and_no_counter) {
  for (const auto& [name, soup] : oracles::random_meshes()) {
    const Mesh mesh(soup);
    const auto solver = prepare(mesh);
    Recording before, after, timed;
    timed.what = Record::phase_times;
    const auto counted = ask(*solver, mesh, from(4), &before);
    EXPECT_TRUE(identical(ask(*solver, mesh, from(4), &timed), counted)) << name;
    EXPECT_TRUE(identical(ask(*solver, mesh, from(4)), counted)) << name;
    ask(*solver, mesh, from(4), &after);
    EXPECT_EQ(before, after) << name;
    EXPECT_FALSE(before.phase_times) << name;
  }
}

TEST_P(Recordings, of_phase_times_hold_nothing_else_and_lose_none) {
  const Mesh mesh(oracles::rough_sphere(53, 2, 0.3));
  Recording counters, timed;
  timed.what = Record::phase_times;
  ask(*prepare(mesh), mesh, from(4), &counters);
  ask(*prepare(mesh), mesh, from(4), &timed);
  ASSERT_EQ(timed.phase_times.has_value(), counters.window_propagations.has_value())
      << "a solver that counts windows knows its phases";
  if (!timed.phase_times) GTEST_SKIP() << GetParam() << " records nothing";
  EXPECT_GT(timed.phase_times->propagation.readings, 0u);
  EXPECT_GT(timed.phase_times->trimming.readings, 0u);
  EXPECT_GT(timed.phase_times->queue.readings, mesh.vertex_count());
  EXPECT_GT(timed.phase_times->propagation.seconds, 0);
  Recording only;
  only.what = timed.what;
  only.phase_times = timed.phase_times;
  EXPECT_EQ(timed, only);
}

// On every edge: in order, without overlap, no nearer than the vertices are, and at a vertex the
// nearest of all its edges is as near as the vertex.
TEST_P(Recordings, of_windows_hand_over_those_that_give_the_distances) {
  NEEDS(description().final_windows);
  for (const auto& [name, soup] : oracles::random_meshes()) {
    const Mesh mesh(soup);
    const auto solver = prepare(mesh);
    const auto distances = ask(*solver, mesh, from(4));
    std::vector<double> nearest(mesh.vertex_count(), kInfinity);
    nearest[4] = 0;
    int calls = 0;
    const ReadWindows read = [&](const FinalWindows& windows_on) {
      ++calls;
      std::vector<Window> windows;
      for (Index h = 0; h < mesh.half_edge_count(); ++h) {
        windows_on(h, windows);
        const Index own = std::min(h, mesh.twin(h));
        double end = 0;
        for (const Window& w : windows) {
          ASSERT_LE(end, w.begin) << name << ", half-edge " << h;
          ASSERT_LT(w.begin, w.end) << name << ", half-edge " << h;
          end = w.end;
          double& at_origin = nearest[mesh.origin(own)];
          double& at_head = nearest[mesh.head(own)];
          at_origin = std::min(at_origin, distance_at(w, w.begin) + w.begin);
          at_head = std::min(at_head, distance_at(w, w.end) + mesh.half_edge(own).length - w.end);
        }
        ASSERT_LE(end, mesh.half_edge(own).length) << name << ", half-edge " << h;
      }
    };
    Recording recording;
    recording.what = Record::windows;
    recording.read_windows = &read;
    EXPECT_TRUE(identical(ask(*solver, mesh, from(4), &recording), distances)) << name;
    EXPECT_EQ(calls, 1) << name;
    EXPECT_TRUE(agree(nearest, distances)) << name;
  }
}

TEST_P(Recordings, of_windows_are_refused_by_solvers_that_keep_none) {
  NEEDS(!description().final_windows);
  const Mesh mesh(oracles::rough_sphere(54, 0, 0.3));
  const ReadWindows read = [](const FinalWindows&) { FAIL() << "handed over none"; };
  Recording recording;
  recording.what = Record::windows;
  recording.read_windows = &read;
  EXPECT_THROW(ask(*prepare(mesh), mesh, from(4), &recording), std::invalid_argument);
}

FOR_EVERY_SOLVER(Recordings);

}  // namespace
}  // namespace geodesic::conformance
