#include "harness/cells/plan.h"

#include <gtest/gtest.h>

#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

TEST(Cells, AlternateSolversOnAMeshAndSource) {
  Description a{}, b{};
  a.name = "a";
  b.name = "b";
  Plan plan;
  plan.solvers = {&a, &b};
  plan.meshes.resize(2);
  plan.meshes[0].entry.name = "m";
  plan.meshes[0].sources = {0, 7};
  plan.meshes[1].entry.name = "n";
  plan.meshes[1].sources = {3};
  std::vector<std::string> order;
  for (const Cell& cell : plan.cells()) {
    order.push_back(row_name(cell.solver->name, cell.mesh->entry.name, cell.source));
  }
  EXPECT_EQ(order, (std::vector<std::string>{"a/m/src:0", "b/m/src:0", "a/m/src:7", "b/m/src:7",
                                             "a/n/src:3", "b/n/src:3"}));
}

TEST(MissingMeshes, AreFetchedByOneCommand) {
  const std::vector<MeshEntry> meshes = {
      {.name = "a", .file = "/cache/a.ply", .kind = "generated"},
      {.name = "b", .file = "/cache/b.ply", .kind = "generated"}};
  const std::string how = how_to_get(meshes);
  EXPECT_TRUE(how.starts_with("meshes 'a', 'b' are not in the dataset cache (/cache): run "))
      << how;
  EXPECT_TRUE(how.ends_with("fetch.py a b")) << how;
}

TEST(ErrorRow, HasNoTimeAndASingleLine) {
  const Json row = error_row("s", "m", 4, outcome::kError, "first\nsecond");
  EXPECT_EQ(row["name"], "s/m/src:4");
  EXPECT_EQ(row["error_occurred"], true);
  EXPECT_EQ(row["error_message"], "first second");
  EXPECT_EQ(row["real_time"], 0.0);
  EXPECT_EQ(row["cpu_time"], 0.0);
  EXPECT_EQ(row["iterations"], 0);
}

}  // namespace
}  // namespace geodesic::harness
