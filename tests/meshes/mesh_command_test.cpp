#include "harness/commands/commands.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "harness/base/json.h"
#include "harness/commands/values.h"
#include "tests/harness/temporary_folder.h"
#include "tests/meshes/mesh_samples.h"

namespace geodesic::harness {
namespace {

using MeshCommand = TemporaryFolder;

struct Outcome {
  std::string output, error;
};

Outcome run(std::vector<std::string> arguments) {
  CLI::App app;
  add_mesh_command(app);
  arguments.insert(arguments.begin(), "mesh");
  std::reverse(arguments.begin(), arguments.end());  // the order that CLI11 expects
  testing::internal::CaptureStdout();
  std::string error;
  try {
    app.parse(arguments);
  } catch (const std::exception& e) {
    error = e.what();
  }
  return {testing::internal::GetCapturedStdout(), error};
}

TEST_F(MeshCommand, PrintsCountsTopologyLengthsAndAngles) {
  const Outcome outcome = run({write("a.off", kOff)});
  EXPECT_EQ(outcome.error, "");
  for (const char* part :
       {"OFF", "vertices            4", "faces               4", "edges               6",
        "components          1", "boundary loops      0", "genus               0",
        "edge length         1 to 1.41421", "smallest angle      45 degrees",
        "saddle vertices     0", "defects             none"}) {
    EXPECT_TRUE(contains(outcome.output, part)) << part << " in\n" << outcome.output;
  }
}

TEST_F(MeshCommand, PrintsJson) {
  const Json json = Json::parse(run({write("a.obj", kObj), "--json"}).output);
  EXPECT_EQ(json["vertices"], 4);
  EXPECT_EQ(json["genus"], 0);
  EXPECT_EQ(json["edge_length"]["min"], 1);
  EXPECT_EQ(json["defects"], Json::array());
}

TEST_F(MeshCommand, DescribesABadMeshAndThenFails) {
  const Outcome outcome = run({write("a.obj", kMisoriented), "--json"});
  EXPECT_TRUE(contains(outcome.error, "distances would be meaningless")) << outcome.error;
  const Json json = Json::parse(outcome.output);
  EXPECT_EQ(json["defects"][0]["kind"], "inconsistent_orientation");
  EXPECT_EQ(json["defects"][0]["severity"], "error");
  EXPECT_EQ(json["defects"][0]["count"], 1);
}

TEST_F(MeshCommand, RepairsReportsAndWrites) {
  const auto bad = write("a.obj", kMisoriented);
  const auto good = folder_ / "b.ply";
  EXPECT_NE(run({bad, "--output", good}).error, "");
  EXPECT_FALSE(std::filesystem::exists(good));
  const Outcome outcome = run({bad, "--repair", "--output", good});
  EXPECT_EQ(outcome.error, "");
  EXPECT_TRUE(contains(outcome.output, "neighbours: 1")) << outcome.output;
  EXPECT_TRUE(contains(run({good}).output, "defects             none"));
  EXPECT_TRUE(contains(run({good, "--repair"}).output, "nothing needed it"));
}

TEST_F(MeshCommand, AMeshWithoutUsableFacesStillGivesJson) {
  const auto bad = write("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\n");
  const Outcome outcome = run({bad, "--json", "--repair"});
  EXPECT_TRUE(contains(outcome.error, "no usable face is left")) << outcome.error;
  EXPECT_TRUE(Json::parse(outcome.output)["edge_length"].is_null());
}

TEST_F(MeshCommand, WeldsAndReportsIt) {
  const auto file =
      write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nf 1 2 3\nf 5 4 6\n");
  const std::string seam =
      "2 vertices where an earlier one lies (first: vertex 3 (line 4) at the "
      "place of vertex 1 (line 2)): paths do not cross there; --weld joins";
  EXPECT_TRUE(contains(run({file}).output, seam)) << run({file}).output;
  const std::string welded = run(with_weld_distance({file, "--weld"})).output;
  EXPECT_TRUE(contains(welded, "welded              vertices joined to an earlier one: 2\n"));
  EXPECT_TRUE(contains(welded, "components          1\n")) << welded;
  EXPECT_TRUE(contains(welded, "defects             none")) << welded;
  const Json json = Json::parse(run({file, "--weld", "1e-3", "--json"}).output);
  EXPECT_EQ(json["weld_distance"], 1e-3);
  EXPECT_EQ(json["welds"][0]["count"], 2);
  EXPECT_EQ(json["isolated_vertices"], 0);
  EXPECT_TRUE(contains(run({file, "--weld=-1"}).error, "'-1' is not 0 or greater"));
}

TEST_F(MeshCommand, LeavesOutAvoidedFacesReportsAndWritesTheRest) {
  const auto file = write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
  const auto rest = folder_ / "b.obj";
  const auto vertices = write("vertices", "[3]"), faces = write("faces", "1\n");
  for (const std::vector<std::string>& avoid :
       {std::vector<std::string>{"--avoid", vertices}, {"--avoid-faces", faces}}) {
    const Outcome outcome = run({file, avoid[0], avoid[1], "-o", rest});
    EXPECT_EQ(outcome.error, "");
    EXPECT_TRUE(contains(outcome.output, "faces left out      1\n")) << outcome.output;
    EXPECT_TRUE(contains(outcome.output, "defects             none")) << outcome.output;
    const Json json = Json::parse(run({rest, "--json"}).output);
    EXPECT_EQ(json["faces"], 1);
    EXPECT_EQ(json["vertices"], 4);
  }
}

TEST(WeldOption, takes_the_next_word_only_if_it_is_a_number) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(with_weld_distance({"mesh", "--weld", "a.obj"}), (Words{"mesh", "--weld=0", "a.obj"}));
  EXPECT_EQ(with_weld_distance({"a", "--weld", "0.5", "b"}), (Words{"a", "--weld", "0.5", "b"}));
  EXPECT_EQ(with_weld_distance({"a", "--weld"}), (Words{"a", "--weld=0"}));
  EXPECT_EQ(with_weld_distance({"--weld", "--json"}), (Words{"--weld=0", "--json"}));
}

}  // namespace
}  // namespace geodesic::harness
