// A faulty solver spoils only its own cells: limits, and the messages about them.
#include <map>

#include "harness/base/process.h"
#include "tests/harness/run_test.h"

namespace geodesic::harness {
namespace {

using nlohmann::json;

// Number of processes whose command line contains the words.
int processes_with(const std::string& words) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "cmdline");
    const std::string line((std::istreambuf_iterator<char>(file)), {});
    if (line.find(words) != std::string::npos) ++count;
  }
  return count;
}

class IsolationTest : public RunTest {
 protected:
  void SetUp() override {
    if (!kLimitsMemory) GTEST_SKIP() << "sanitizers take signals, memory and time themselves";
    RunTest::SetUp();
  }
  // Runs the hostile solver first, so that whatever it leaves behind could affect the sound one.
  Output run_beside_a_sound_one(const std::string& hostile, std::vector<std::string> limits) const {
    limits.insert(limits.end(), {"--solvers", hostile + ",dijkstra", "--meshes", "tetrahedron",
                                 "--sources", "1", "--reference", exact_solver()});
    return run_suite(kFaultyProgram, limits);
  }
  void expect_outcome(const std::string& hostile, const std::vector<std::string>& limits,
                      const std::string& outcome, const std::string& words) {
    std::filesystem::remove_all(out_);
    const Output run = run_beside_a_sound_one(hostile, limits);
    EXPECT_EQ(run.code, 1) << run.err;
    const json failed = row(hostile + "/tetrahedron/src:0");
    EXPECT_EQ(failed.value("outcome", ""), outcome) << failed;
    expect_words(message(failed), {words});
    EXPECT_EQ(row("dijkstra/tetrahedron/src:0").value("outcome", ""), "ok");
    EXPECT_EQ(processes_with(out_.string()), 0) << "something was left running";
  }
};

TEST_F(IsolationTest, a_crash_is_a_row_with_the_signal_and_the_last_words) {
  expect_outcome("stack-overflow", {}, "crashed", "killed by signal 11");
  expect_outcome("talkative", {}, "crashed", R"(the \x1b[31mlast\xff words)");
  expect_outcome("parent", {}, "crashed", "killed by signal 6");
}

TEST_F(IsolationTest, memory_beyond_the_limit_is_out_of_memory) {
  for (const char* hostile : {"hungry", "hungry-and-blind"}) {
    expect_outcome(hostile, {"--memory-limit", "300M"}, "out of memory", "memory limit 300 MiB");
  }
}

TEST_F(IsolationTest, what_does_not_end_is_a_time_out) {
  for (const char* hostile : {"looping", "mute", "deaf", "chatterbox"}) {
    expect_outcome(hostile, {"--time-limit", "0.5"}, "time-out", "not finished after 0.5 s");
  }
}

TEST_F(IsolationTest, other_sources_of_what_ran_out_of_time_or_memory_are_skipped) {
  const Output run = run_suite(
      kFaultyProgram, {"--solvers", "looping,dijkstra", "--meshes", "tetrahedron", "--sources", "3",
                       "--reference", exact_solver(), "--time-limit", "0.3"});
  EXPECT_EQ(run.code, 1) << run.err;
  std::map<std::string, int> outcomes;
  for (const json& each : rows()) {
    if (each.at("solver") == "looping") ++outcomes[each.at("outcome")];
  }
  EXPECT_EQ(outcomes, (std::map<std::string, int>{{"skipped", 2}, {"time-out", 1}}));
}

TEST_F(IsolationTest, an_expected_outcome_is_no_failure_and_another_one_is) {
  const auto run_expecting = [&](const std::string& outcome) {
    std::filesystem::remove_all(out_);
    const auto suite =
        write("suite.json",
              R"({"time_limit": 0.3, "expected": {"looping/tetrahedron": ")" + outcome + R"("}})");
    return run_suite(kFaultyProgram, {suite.string(), "--solvers", "looping", "--meshes",
                                      "tetrahedron", "--sources", "2"});
  };
  EXPECT_EQ(run_expecting("time-out").code, 0);
  EXPECT_EQ(run_context().at("expected"), json({{"looping/tetrahedron", "time-out"}}));
  EXPECT_EQ(run_expecting("out of memory").code, 1);
}

TEST_F(IsolationTest, limits_are_checked_and_recorded) {
  const Output run =
      run_suite(PROGRAM, {"--solvers", "dijkstra", "--memory-limit", "1G", "--time-limit", "77"});
  EXPECT_EQ(run.code, 0) << run.err;
  const json context = run_context();
  EXPECT_EQ(context.at("memory_limit"), 1 << 30);
  EXPECT_EQ(context.at("time_limit"), 77);
  for (const auto& [flag, value] : {std::pair{"--memory-limit", "1M"},
                                    {"--memory-limit", "much"},
                                    {"--time-limit", "0"},
                                    {"--time-limit", "nan"}}) {
    std::filesystem::remove_all(out_);
    EXPECT_EQ(run_suite(PROGRAM, {"--solvers", "dijkstra", flag, value}).code, 1) << value;
    EXPECT_FALSE(std::filesystem::exists(out_)) << value;
  }
}

TEST_F(IsolationTest, a_reference_that_takes_too_long_is_replaced_by_the_next) {
  const Output run =
      run_suite(kFaultyProgram, {"--solvers", "dijkstra", "--meshes", "tetrahedron", "--sources",
                                 "1", "--reference", "looping", "--time-limit", "0.5"});
  EXPECT_EQ(run.code, 0) << run.err;
}

}  // namespace
}  // namespace geodesic::harness
