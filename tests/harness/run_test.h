// Fixture for tests of whole runs into the folder out_, with quick measurements.
#pragma once

#include "tests/harness/program.h"

namespace geodesic::harness {

class RunTest : public ProgramTest {
 protected:
  Output run_suite(const Program& program, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "run");
    arguments.insert(arguments.end(),
                     {"--out", out_.string(), "--min-time", "0.0001", "--repetitions", "2"});
    return run(program, arguments);
  }
  /// Runs the program and asserts that it succeeds.
  void measure(const std::vector<std::string>& arguments) const {
    const Output run = run_suite(PROGRAM, arguments);
    ASSERT_EQ(run.code, 0) << run.err;
  }
  nlohmann::json run_context() const {
    return read_json(out_ / "run.json").at("context").at("geodesic_bench");
  }
  nlohmann::json rows() const { return read_json(out_ / "run.json").at("benchmarks"); }
  // The first row of the cell `name`.
  nlohmann::json row(const std::string& name) const {
    for (const nlohmann::json& each : rows()) {
      if (each.at("name") == name) return each;
    }
    ADD_FAILURE() << "no row is named " << name;
    return nlohmann::json::object();
  }
  static std::string message(const nlohmann::json& row) { return row.value("error_message", ""); }

  const std::filesystem::path out_ = folder_ / "out";
};

}  // namespace geodesic::harness
