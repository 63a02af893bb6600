#include "harness/run/progress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <set>
#include <tuple>

namespace geodesic::harness {
namespace {

// The captured standard error is no terminal, so the lines are those of a log.
TEST(Progress, IsALineACellThatNamesItAndHowLongItTook) {
  Description solver{};
  solver.name = "s";
  PlannedMesh mesh;
  mesh.entry.name = "m";
  mesh.vertices = 100;
  const SourceSet seven = single_source(7), nine = single_source(9);
  const std::vector<Cell> cells{{&mesh, &seven, &solver}, {&mesh, &nine, &solver}};
  Progress progress(cells, {.repetitions = 1, .min_time = 0.001});
  ::testing::internal::CaptureStderr();
  progress.working("reference by r");
  progress.ended("ok");
  progress.working("measuring");
  progress.ended("crashed");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "[1/2] s/m/src:7  ok  (0 s, about 0 s left)\n[2/2] s/m/src:9  crashed  (0 s)\n")
      << "a line while a cell is measured comes after a minute";
}

// CPU milliseconds of a solve from the first source, in a run of corpus quick on a virtual machine
// (AMD EPYC); 0: unsupported. The knot takes nine tenths of the run, in the middle of it.
struct RecordedSolver {
  const char* name;
  const char* family;
  int untimed_solves;  // warm-up, counters, phases
};
constexpr std::array<RecordedSolver, 8> kSolvers{{{"cgal", "CH", 2},
                                                  {"ch", "CH", 5},
                                                  {"dijkstra", "Dijkstra", 2},
                                                  {"edge-based", "edge-based", 5},
                                                  {"fwp-ch", "CH", 5},
                                                  {"fwp-mmp", "MMP", 5},
                                                  {"ich", "CH", 5},
                                                  {"mmp", "MMP", 5}}};
struct RecordedMesh {
  const char* name;
  Index vertices;
  bool closed_form;
  std::array<double, 8> ms;  // by solver
};
const std::vector<RecordedMesh> kMeshes{
    {"flat-grid", 1681, true, {138.6, 0, 0.04153, 1.271, 2.198, 3.963, 3.278, 5.183}},
    {"cube", 602, true, {16.93, 198.8, 0.01451, 0.2072, 0.3532, 0.5207, 0.5013, 0.6943}},
    {"icosphere", 1442, false, {20.7, 0, 0.04063, 0.9951, 2.976, 4.091, 4.835, 6.301}},
    {"torus", 1152, false, {29.63, 1603, 0.03186, 0.9202, 2.253, 4.734, 3.336, 5.761}},
    {"knot", 28800, false, {6405, 0, 3.47, 33.44, 157.7, 421, 227.5, 477}},
    {"terrain", 2601, false, {40.68, 0, 0.1779, 2.144, 3.491, 7.008, 4.665, 8.015}},
    {"egg-carton", 2401, false, {47.89, 0, 0.07807, 1.352, 2.817, 6.175, 4.174, 7.216}},
    {"holed-plate", 2068, false, {43.57, 0, 0.05814, 1.123, 3.003, 7.617, 4.263, 8.625}},
    {"needles", 2160, false, {309.4, 0, 0.07529, 3.786, 11.12, 21.5, 18.5, 25.94}},
    {"two-components", 1389, false, {21.56, 0, 0.02838, 0.6844, 1.792, 2.521, 2.827, 3.606}},
};

// Replays the run: three repetitions of at least 0.05 s, two sources per mesh.
class Replay {
 public:
  Replay() {
    for (const RecordedSolver& recorded : kSolvers) {
      Description& solver = descriptions_.emplace_back();
      solver.name = recorded.name;
      solver.family = recorded.family;
      solver.independent_oracle = solver.name == "cgal";
      if (solver.name == "dijkstra") solver.exactness = Exactness::upper_bound;
      plan_.solvers.push_back(&solver);
    }
    for (const RecordedMesh& recorded : kMeshes) {
      PlannedMesh& mesh = plan_.meshes.emplace_back();
      mesh.entry.name = recorded.name;
      if (recorded.closed_form) mesh.entry.recipe = Recipe{.generator = "box", .parameters = {}};
      mesh.vertices = recorded.vertices;
      mesh.sources = {single_source(0), single_source(1)};
      if (recorded.ms[1] == 0) mesh.unsupported["ch"] = "too large";
    }
    cells_ = plan_.cells();
    for (const Cell& cell : cells_) seconds_.push_back(seconds_of(cell));
  }

  // The largest factor between the estimated and the true remaining time.
  // @param from share of the run's time before the first comparison; the last 3% are left out
  double worst_factor(double from) const {
    Forecast forecast(cells_, suite_, plan_.solvers);
    double all = 0, elapsed = 0, worst = 1;
    for (const double seconds : seconds_) all += seconds;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      elapsed += seconds_[i];
      forecast.measured(i, seconds_[i]);
      const double left = all - elapsed, estimated = forecast.seconds_left(i + 1);
      if (elapsed < from * all || left < 0.03 * all) continue;
      worst = std::max({worst, estimated / left, left / estimated});
    }
    return worst;
  }

 private:
  static double solve_seconds(const Cell& cell, std::string_view solver) {
    const auto mesh = std::ranges::find(kMeshes, cell.mesh->entry.name, &RecordedMesh::name);
    const auto at = std::ranges::find(kSolvers, solver, &RecordedSolver::name);
    return 1e-3 * mesh->ms[static_cast<std::size_t>(at - kSolvers.begin())];
  }

  double seconds_of(const Cell& cell) {
    if (cell.unsupported() != nullptr) return 0;
    constexpr double kProcess = 0.15, kSearch = 1.35;  // measured on tiny meshes
    const std::string& name = cell.solver->name;
    const double solve = solve_seconds(cell, name);
    const auto untimed = std::ranges::find(kSolvers, name, &RecordedSolver::name)->untimed_solves;
    double seconds = kProcess + untimed * solve;
    seconds += 3 * (solve < suite_.min_time ? kSearch * (suite_.min_time + solve / 2) : solve);
    const std::string reference = name == "cgal" ? "edge-based" : "cgal";
    if (!cell.mesh->entry.recipe &&
        references_.insert({cell.mesh, cell.source, reference}).second) {
      seconds += solve_seconds(cell, reference);
    }
    return seconds;
  }

  const Suite suite_{.repetitions = 3, .min_time = 0.05};
  std::deque<Description> descriptions_;
  Plan plan_;
  std::vector<Cell> cells_;
  std::vector<double> seconds_;
  std::set<std::tuple<const PlannedMesh*, const SourceSet*, std::string>> references_;
};

TEST(Forecast, IsWithinAFactorOfOneAndAHalfAfterATenthOfTheTime) {
  EXPECT_LT(Replay().worst_factor(0.1), 1.5);
}

}  // namespace
}  // namespace geodesic::harness
