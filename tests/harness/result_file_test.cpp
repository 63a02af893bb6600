// Result files that somebody else wrote: what the numbers and words in them must be.
#include <gtest/gtest.h>

#include "harness/results/context.h"
#include "harness/results/read.h"
#include "tests/harness/expect_error.h"

namespace geodesic::harness {
namespace {

Json result_file() {
  const Json ours{{"schema_version", kSchemaVersion},
                  {"corpus", "quick"},
                  {"processor", "one"},
                  {"compiler", "GNU"},
                  {"compiler_flags", "-O3"},
                  {"build_type", "Release"},
                  {"meshes", {{{"name", "cube"}, {"sha256", "00"}}}}};
  const Json row{{"run_name", "mmp/cube/src:0"},
                 {"solver", "mmp"},
                 {"mesh", "cube"},
                 {"outcome", "ok"},
                 {"cpu_time", 1.5},
                 {"window_propagations", 1000}};
  return {{"context", {{"geodesic_bench", ours}}}, {"benchmarks", {row}}};
}

struct Change {
  std::string at;  // JSON pointer
  Json value;
  std::string message;
};

TEST(ResultFile, IsReadByCells) {
  const ResultFile result = parse_result_file(result_file(), "run.json");
  ASSERT_EQ(result.cells.size(), 1u);
  EXPECT_EQ(result.cells[0].name, "mmp/cube/src:0");
  EXPECT_EQ(result.cells[0].values("cpu_time"), std::vector<double>{1.5});
}

TEST(ResultFile, IsRefusedWhenWhatIsComparedIsNotThere) {
  const std::string ours = "/context/geodesic_bench";
  const std::vector<Change> changes{
      {ours + "/schema_version", 1e300, "schema version 1e+300, and this program reads 2"},
      {ours + "/compiler", 7, "must be string"},
      {ours + "/corpus", "a\nb", "\"corpus\" has control characters"},
      {ours + "/meshes", {1}, "cannot use at()"},
      {ours + "/meshes/0/sha256", nullptr, "must be string"},
      {"/benchmarks/0/solver", nullptr, "must be string"},
      {"/benchmarks/0/run_name", "a\x1b[2J", "\"run_name\" has control characters"},
      {"/benchmarks/0/cpu_time", "1.5", "cpu_time is no number but string"},
      {"/benchmarks/0/cpu_time", 0, "the cpu_time is not above 0"},
      {"/benchmarks/0/window_propagations", nullptr, "is no number but null"},
      {"/benchmarks/0/solver_peak_bytes", Json::array(), "is no number but array"}};
  for (const Change& change : changes) {
    SCOPED_TRACE(change.at + " = " + change.value.dump());
    Json json = result_file();
    json[Json::json_pointer(change.at)] = change.value;
    expect_error([&] { parse_result_file(json, "run.json"); },
                 {"'run.json' is no result file of geodesic-bench: ", change.message});
  }
}

TEST(ResultFile, IsRefusedWhenACellThatIsOkHasNoTime) {
  Json json = result_file();
  json["benchmarks"][0].erase("cpu_time");
  expect_error([&] { parse_result_file(json, "run.json"); }, {"key 'cpu_time' not found"});
}

TEST(ResultFile, ACellThatFailedNeedsNoNumbers) {
  Json json = result_file();
  json["benchmarks"][0]["outcome"] = "crashed";
  json["benchmarks"][0].erase("cpu_time");
  const ResultFile result = parse_result_file(json, "run.json");
  EXPECT_TRUE(result.cells.front().values("cpu_time").empty());

  json["benchmarks"][0]["cpu_time"] = "fast";  // but what it has, exports order its rows by
  expect_error([&] { parse_result_file(json, "run.json"); }, {"cpu_time is no number but string"});
}

}  // namespace
}  // namespace geodesic::harness
