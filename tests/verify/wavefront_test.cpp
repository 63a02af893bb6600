// Samples and snapshots of the wavefront: windows lie on edges, at possible distances.
#include <numeric>

#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/random_meshes.h"
#include "solvers/core/progress.h"
#include "tests/verify/solver_test.h"

namespace geodesic::harness {
namespace {

const std::vector<double> kMoments{0.25, 0.5, 0.75};

Recording wish_for_wavefront() {
  Recording recording;
  recording.kind = RecordingKind::wavefront;
  recording.snapshots_at = kMoments;
  return recording;
}

// The recording with the counters only.
Recording without_wavefront(Recording recording) {
  recording.kind = RecordingKind::counters;
  recording.snapshots_at.clear();
  recording.curve.clear();
  recording.snapshots.clear();
  recording.reached_by.clear();
  return recording;
}

std::vector<Index> reached_of_curve(const Recording& recording) {
  std::vector<Index> counts;
  for (const WavefrontSample& sample : recording.curve) counts.push_back(sample.reached);
  return counts;
}

// The same counts, from Recording::reached_by.
std::vector<Index> reached_by_sample(const Recording& recording) {
  std::vector<Index> counts(recording.curve.size());
  for (const Index by : recording.reached_by) {
    if (by != kNone) ++counts.at(by);
  }
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
  return counts;
}

class Wavefronts : public SolverTest {
 protected:
  Recording record(const Mesh& mesh, Index source) const {
    Recording recording = wish_for_wavefront();
    distances_ = solve_with(*prepare(mesh), mesh, from(source), &recording);
    return recording;
  }
  mutable std::vector<double> distances_;  // of the last recorded solve
};

std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> all = random_meshes();
  all.push_back(
      {"two components", side_by_side(rough_sphere(61, 2, 0.3), rough_sphere(62, 3, 0.3))});
  return all;
}

TEST_P(Wavefronts, change_no_distance_and_no_counter) {
  for (const auto& [name, soup] : meshes()) {
    for (const Numbering numbering : {Numbering::as_given, Numbering::along_surface}) {
      const Mesh mesh(soup, numbering);
      const auto solver = prepare(mesh);
      Recording counters, wavefront = wish_for_wavefront();
      const auto plain = solve_with(*solver, mesh, from(4));
      const auto counted = solve_with(*solver, mesh, from(4), &counters);
      const auto sampled = solve_with(*solver, mesh, from(4), &wavefront);
      EXPECT_TRUE(nothing(check_distances(from(4), counted, plain, Relation::same_bits))) << name;
      EXPECT_TRUE(nothing(check_distances(from(4), sampled, plain, Relation::same_bits))) << name;
      EXPECT_EQ(without_wavefront(wavefront), counters) << name;
      EXPECT_TRUE(counters.curve.empty() && counters.snapshots.empty()) << name;
      EXPECT_EQ(wavefront.curve.empty(), !counters.wavefront_sd) << name;
    }
  }
}

TEST_P(Wavefronts, are_the_same_in_a_recording_that_was_used_before) {
  for (const auto& [name, soup] : meshes()) {
    const Mesh mesh(soup);
    Recording used = record(mesh, 0);
    solve_with(*prepare(mesh), mesh, from(4), &used);
    EXPECT_EQ(used, record(mesh, 4)) << name;
  }
}

TEST_P(Wavefronts, have_a_curve_of_progress_whose_sds_have_the_counted_mean) {
  for (const auto& [name, soup] : meshes()) {
    const Mesh mesh(soup);
    const Recording recording = record(mesh, 4);
    if (recording.curve.empty()) GTEST_SKIP() << GetParam() << " records no wavefront";
    EXPECT_LE(recording.curve.size(), Progress::kSteps) << name;
    EXPECT_GE(recording.curve.size(), 8u) << name;
    Index reached = 0;
    double sd_sum = 0;
    const auto finite = std::ranges::count_if(distances_, [](double d) { return d < kInfinity; });
    for (const WavefrontSample& sample : recording.curve) {
      EXPECT_GT(sample.reached, reached) << name;
      reached = sample.reached;
      EXPECT_GT(sample.windows, 0u) << name;
      EXPECT_LE(sample.windows, recording.peak_wavefront) << name;
      EXPECT_GE(sample.least, 0) << name;
      EXPECT_LE(sample.least, sample.mean) << name;
      EXPECT_GE(sample.sd, 0) << name;
      sd_sum += sample.sd;
    }
    EXPECT_LE(reached, finite) << name;
    EXPECT_EQ(reached_by_sample(recording), reached_of_curve(recording)) << name;
    EXPECT_EQ(recording.wavefront_sd, sd_sum / static_cast<int>(recording.curve.size())) << name;
  }
}

TEST_P(Wavefronts, of_a_snapshot_are_those_of_the_sample_at_that_moment) {
  for (const auto& [name, soup] : meshes()) {
    const Mesh mesh(soup);
    const Recording recording = record(mesh, 4);
    if (recording.curve.empty()) GTEST_SKIP() << GetParam() << " records no wavefront";
    const auto reachable =
        std::ranges::count_if(distances_, [](double d) { return d < kInfinity; });
    EXPECT_EQ(recording.snapshots.size(), kMoments.size()) << name;
    for (const WavefrontSnapshot& snapshot : recording.snapshots) {
      const auto sample = std::ranges::find_if(recording.curve, [&](const WavefrontSample& each) {
        return each.reached >= snapshot.share * static_cast<double>(reachable);
      });
      ASSERT_NE(sample, recording.curve.end()) << name << " at " << snapshot.share;
      ASSERT_EQ(snapshot.windows.size(), sample->windows) << name << " at " << snapshot.share;
      double sum = 0, least = kInfinity;
      for (const WavefrontWindow& w : snapshot.windows) {
        sum += w.distance;
        least = std::min(least, w.distance);
      }
      EXPECT_EQ(least, sample->least) << name;
      EXPECT_NEAR(sum / static_cast<double>(sample->windows), sample->mean, 1e-12 * sum) << name;
    }
  }
}

TEST_P(Wavefronts, lie_on_edges_no_nearer_than_the_truth) {
  // The distances and windows of a bounded solver may have errors in opposite directions.
  const Description& solver = solver_named(GetParam());
  const double slack = solver.exactness == Exactness::bounded ? 2 * solver.error_bound(solver) : 0;
  for (const auto& [name, soup] : meshes()) {
    const Mesh mesh(soup);
    const Recording recording = record(mesh, 4);
    for (const WavefrontSnapshot& snapshot : recording.snapshots) {
      for (const WavefrontWindow& w : snapshot.windows) {
        ASSERT_LT(w.half_edge, mesh.half_edge_count()) << name;
        const double length = mesh.half_edge(w.half_edge).length;
        EXPECT_GE(w.begin, 0) << name;
        EXPECT_LT(w.begin, w.end) << name;
        EXPECT_LE(w.end, length) << name;
        // A point of the edge is nearer than an end of it by at most their distance on the edge.
        const double from_origin = distances_[mesh.origin(w.half_edge)] - w.end;
        const double from_head = distances_[mesh.head(w.half_edge)] - (length - w.begin);
        EXPECT_GE(w.distance * (1 + slack), std::max(from_origin, from_head) - 1e-9)
            << name << ", half-edge " << w.half_edge << " at " << snapshot.share;
      }
    }
  }
}

TriangleSoup plane() { return generate("grid", {{"columns", 32}, {"rows", 32}}); }

// A quarter of a circle around the corner. In the order of least distance, the wavefront is as wide
// as an edge is long. In the plane FIFO order has the same effect, since the number of faces that a
// window has crossed is proportional to its distance.
TEST_P(Wavefronts, on_a_plane_lie_near_a_circle) {
  const Mesh mesh(plane());
  if (mesh.vertex_count() > abilities().max_vertices) GTEST_SKIP() << "too many vertices";
  const Recording recording = record(mesh, 0);
  for (const WavefrontSnapshot& snapshot : recording.snapshots) {
    double sum = 0;
    for (const WavefrontWindow& w : snapshot.windows) sum += w.distance;
    const double radius = sum / static_cast<double>(snapshot.windows.size());
    for (const WavefrontWindow& w : snapshot.windows) {
      EXPECT_NEAR(w.distance, radius, 2 * mesh.mean_edge_length()) << "at " << snapshot.share;
    }
  }
}

FOR_EVERY_SOLVER(Wavefronts);

// In the order of least distance, the wavefront is at most as wide as with buckets.
TEST(WavefrontSd, is_least_in_the_order_of_distance) {
  const Mesh mesh(plane());
  const auto sd = [&](const char* solver) {
    Recording recording;
    solve_once(solver, mesh, from(0), &recording);
    return recording.wavefront_sd.value();
  };
  for (const auto& [by_distance, by_bucket] :
       {std::pair("mmp", "fwp-mmp"), std::pair("ich", "fwp-ch")}) {
    EXPECT_LE(sd(by_distance), sd(by_bucket)) << by_distance << " and " << by_bucket;
  }
}

}  // namespace
}  // namespace geodesic::harness
