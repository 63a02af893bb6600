#include "harness/run/plan.h"

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
  plan.meshes[0].sources = {single_source(0), single_source(7)};
  plan.meshes[1].entry.name = "n";
  plan.meshes[1].sources = {single_source(3)};
  std::vector<std::string> order;
  for (const Cell& cell : plan.cells()) {
    order.push_back(cell.name());
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

TEST(InterleavedCells, AlternateTheOrderOfSolversAndProgramsFromRepetitionToRepetition) {
  Description a{}, b{};
  a.name = "a";
  b.name = "b";
  Plan plan{.solvers = {&a, &b},
            .programs = {{.name = "x", .file = {}}, {.name = "y", .file = {}}}};
  plan.meshes.resize(1);
  plan.meshes[0].entry.name = "m";
  plan.meshes[0].sources = {single_source(0), single_source(7)};
  plan.only = {"a/m/src:0", "b/m/src:7"};
  std::string order;
  for (const Cell& cell : plan.interleaved_cells(3)) {
    EXPECT_EQ(cell.repetitions, 3);
    order += cell.name() + " " + std::to_string(cell.repetition) + cell.program->name + "\n";
  }
  EXPECT_EQ(order,
            "a/m/src:0 0x\na/m/src:0 0y\na/m/src:0 1y\na/m/src:0 1x\na/m/src:0 2x\na/m/src:0 2y\n"
            "b/m/src:7 0x\nb/m/src:7 0y\nb/m/src:7 1y\nb/m/src:7 1x\nb/m/src:7 2x\nb/m/src:7 2y\n");
  plan.only.clear();
  const std::vector<Cell> all = plan.interleaved_cells(2);
  ASSERT_EQ(all.size(), 16u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(all[i].solver, all[7 - i].solver) << i;
    EXPECT_EQ(all[i].program, all[7 - i].program) << i;
  }
}

TEST(Row, OfAFailureHasNoTimeAndASingleLine) {
  const Json json = Row{.solver = "s",
                        .mesh = "m",
                        .source = "4",
                        .outcome = Outcome::error,
                        .error_message = "first\nsecond"};
  EXPECT_EQ(json["name"], "s/m/src:4");
  EXPECT_EQ(json["error_occurred"], true);
  EXPECT_EQ(json["error_message"], "first second");
  EXPECT_EQ(json["real_time"], 0.0);
  EXPECT_EQ(json["cpu_time"], 0.0);
  EXPECT_EQ(json["iterations"], 0);
}

TEST(Row, NamesASetOfSourcesAndNumbersAVertex) {
  const Json vertex = Row{.solver = "s", .mesh = "m", .source = "4"};
  const Json set = Row{.solver = "s", .mesh = "m", .source = "random:8"};
  EXPECT_EQ(vertex["source"], 4);
  EXPECT_EQ(set["source"], "random:8");
  EXPECT_EQ(set["name"], "s/m/src:random:8");
  EXPECT_EQ(vertex.get<Row>().source, "4");
  EXPECT_EQ(set.get<Row>().source, "random:8");
}

TEST(Row, IsReadAsItWasWritten) {
  Row row{.solver = "s", .mesh = "m", .source = "4", .program = "base"};
  row.repetitions = 3;
  row.repetition_index = 2;
  row.iterations = 7;
  row.cpu_time = 0.1;
  row.real_time = 0.2;
  row.stolen_share = 0.25;
  row.counters.window_limit = 12;
  row.counters.strip_b = 1.5;
  row.phase_seconds = PhaseSeconds{.propagation = 1, .trimming = 2, .queue = 3};
  row.reference = "t";
  const Json json = row;
  EXPECT_EQ(Json(json.get<Row>()), json);
  EXPECT_EQ(json["cpu_time"], 0.1);
  EXPECT_EQ(json["real_time"], 0.2);
  EXPECT_FALSE(json.contains("peak_wavefront")) << "absent where the solver has none";
}

}  // namespace
}  // namespace geodesic::harness
