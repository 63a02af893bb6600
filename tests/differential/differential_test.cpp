// The differential test finds a faulty solver, makes its mesh small and saves it.
#include "tests/differential/perturb.h"

#include <set>
#include <sstream>

#include "harness/verify/property.h"
#include "meshes/mesh_file.h"
#include "solvers/core/registry.h"
#include "solvers/core/thread_team.h"
#include "tests/harness/temporary_folder.h"

namespace geodesic::differential {
namespace {

using harness::Case;

class Differential : public harness::TemporaryFolder {
 protected:
  Request request(const std::string& solver, std::uint64_t meshes) const {
    return {.meshes = meshes, .only = {}, .solvers = {solver}, .out = folder_ / "failures"};
  }

  /// @param solver registered; it agrees on `meshes` meshes or not
  bool agrees(const std::string& solver, std::uint64_t meshes) {
    std::ostringstream report;
    const bool agreed = run_differential(request(solver, meshes), report);
    report_ = report.str();
    return agreed;
  }

  /// The one that was saved.
  Case saved() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "failures")) {
      return {
          .mesh = entry.path().string(), .soup = read_mesh_file(entry.path()).soup, .queries = {}};
    }
    ADD_FAILURE() << "no mesh was saved\n" << report_;
    return {};
  }

  bool fails_on(const Case& given, const std::string& solver) const {
    const auto& property = *harness::find_property(harness::kDistancesProperty);
    return harness::check_case(property, *find_solver(solver), given).has_value();
  }

  std::string report_;
};

TEST_F(Differential, finds_shrinks_and_saves_where_a_solver_knows_no_bends_at_boundaries) {
  ASSERT_FALSE(agrees("boundary-blind", 20));
  Case small = saved();
  EXPECT_LE(small.soup.triangles.size(), 4u) << report_;
  bool fails = false;
  for (Index v = 0; v < small.soup.positions.size(); ++v) {
    small.queries = {harness::from(v)};
    fails |= fails_on(small, "boundary-blind");
  }
  EXPECT_TRUE(fails) << report_;
  EXPECT_NE(report_.find("geodesic-bench verify --solver boundary-blind"), std::string::npos);
  EXPECT_NE(report_.find("--meshes " + small.mesh), std::string::npos) << report_;
  EXPECT_NE(report_.find("differential --seed 1 --only "), std::string::npos) << report_;
}

TEST_F(Differential, reports_a_solver_that_throws) {
  ASSERT_FALSE(agrees("throwing", 3));
  EXPECT_NE(report_.find("threw: ran out of luck"), std::string::npos) << report_;
  EXPECT_EQ(saved().soup.triangles.size(), 1u);
}

TEST_F(Differential, holds_inexact_solvers_to_what_they_promise_and_no_more) {
  for (const auto& [solver, keeps] : {std::pair{"bounded?off=0.09", true},
                                      {"bounded?off=0.11", false},
                                      {"upper?off=0.5", true},
                                      {"upper?off=-0.01", false},
                                      {"unbounded?off=-0.5", true}}) {
    Request asked = request(solver, 2);
    asked.shrink = 0;
    std::ostringstream report;
    EXPECT_EQ(run_differential(asked, report), keeps) << solver << '\n' << report.str();
  }
}

TEST_F(Differential, sends_a_judge_that_is_wrong_to_the_arbiter_and_blames_no_solver) {
  Request asked = request("mmp", 1);
  asked.seed = 3;
  asked.only = 513;  // too large for brute force to be asked first
  asked.shrink = 0;
  for (const char* judge : {"oracle?off=1e-6", "oracle?off=-1e-6"}) {
    for (const auto& [solver, right] : {std::pair{"mmp", true}, {"bounded?off=0.11", false}}) {
      asked.solvers = {judge, solver};
      std::ostringstream report;
      EXPECT_EQ(run_differential(asked, report), right) << report.str();
      EXPECT_NE(report.str().find(" went to the arbiter on 1"), std::string::npos) << report.str();
    }
  }
}

TEST_F(Differential, saves_nothing_where_solvers_agree) {
  for (const Description* solver : registered_solvers()) {
    if (solver->family == "test-only" || solver->exactness != Exactness::exact) continue;
    EXPECT_TRUE(agrees(solver->name, 3)) << report_;
    break;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "failures"));
}

TEST_F(Differential, right_distances_move_less_than_the_bound_when_coordinates_are_rounded) {
  std::ostringstream report;
  perturb({.meshes = 5, .seed = 5, .only = {}, .solvers = {}, .out = {}}, 2, report);
  EXPECT_NE(report.str().find("seed 5: 3 meshes, moved 2 times"), std::string::npos)
      << report.str();
  EXPECT_NE(report.str().find("0 on 0 meshes by more than 1e-12"), std::string::npos)
      << report.str();
}

TEST_F(Differential, makes_the_same_mesh_of_a_seed_and_a_number_every_time) {
  for (std::uint64_t number = 0; number < 40; ++number) {
    const Case one = random_case(7, number, folder_), other = random_case(7, number, folder_);
    EXPECT_EQ(one.mesh, other.mesh);
    EXPECT_EQ(one.soup.positions, other.soup.positions) << one.mesh;
    EXPECT_EQ(one.soup.triangles, other.soup.triangles) << one.mesh;
  }
}

TEST_F(Differential, of_edge_based_the_number_of_threads_changes_no_bit) {
  constexpr std::uint64_t kMeshes = 100;
  const DelayedPieces delayed;
  for (std::uint64_t number = 0; number < kMeshes; ++number) {
    const Case given = random_case(1, number, folder_);
    const Mesh mesh = given.build();
    Query query = given.queries.front();
    query.limit = kInfinity;  // where a query ends early, there is one thread
    std::vector<double> expected(mesh.vertex_count()), got(mesh.vertex_count());
    make_solver("edge-based?threads=2&region-size=8", mesh)->solve(query, expected);
    for (const char* solver :
         {"edge-based?threads=3&region-size=8", "edge-based?threads=16&region-size=8"}) {
      make_solver(solver, mesh)->solve(query, got);
      EXPECT_EQ(got, expected) << solver << " on mesh " << number << ", " << given.mesh;
    }
  }
}

TEST_F(Differential, makes_meshes_of_every_kind) {
  std::set<Kind> kinds;
  for (std::uint64_t number = 0; number < 200; ++number) {
    kinds.insert(kind_of(Mesh(random_case(8, number, folder_).soup)));
  }
  EXPECT_EQ(kinds.size(), static_cast<std::size_t>(kKinds));
}

}  // namespace
}  // namespace geodesic::differential
