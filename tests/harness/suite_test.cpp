// Valid suites; invalid ones are in tests/bad_inputs/bad_suites.py.
#include "harness/corpus/suite.h"

#include <gtest/gtest.h>

namespace geodesic::harness {
namespace {

TEST(Suite, SetsEveryKey) {
  const Json all = Json::parse(R"({
    "solvers": ["a", "b"], "corpus": "real", "meshes": ["m"], "sources": 5,
    "source_sets": ["random:8", "boundary"], "repetitions": 7, "seed": 18446744073709551615,
    "other_queries": 4, "path_targets": 6, "further_sources": 7, "min_time": 0.25, "vectors": "plain", "time_limit": 9.5,
    "expected": {"a/m": "time-out"}, "reference": "b", "memory_limit": 8589934592})");
  EXPECT_EQ(Json(parse_suite(all, "suite.json")), all);
}

TEST(Suite, LeavesOutWhatItDoesNotChange) {
  EXPECT_EQ(Json(parse_suite(Json::object(), "suite.json")), Json(Suite()));
}

TEST(Suite, OfTheProgramIsValid) {
  EXPECT_EQ(read_suite(default_suite()).corpus, "quick");
  for (const auto& file : std::filesystem::directory_iterator(default_suite().parent_path())) {
    EXPECT_NO_THROW(read_suite(file.path())) << file.path();
  }
}

}  // namespace
}  // namespace geodesic::harness
