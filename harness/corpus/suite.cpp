#include "harness/corpus/suite.h"

#include <cmath>
#include <iostream>
#include <set>
#include <utility>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/schema.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"

namespace geodesic::harness {
namespace {

constexpr std::uint64_t kLeastMemory = std::uint64_t{128} << 20;  // of address space

std::filesystem::path suites_folder() { return data_folder() / "harness" / "suites"; }

}  // namespace

Suite read_suite(const std::filesystem::path& file) {
  return parse_suite(read_json(file, "a suite, such as " + default_suite().string()),
                     file.string());
}

Suite parse_suite(const Json& json, const std::string& name) {
  static const Json schema = read_json(data_folder() / "harness" / "suite.schema.json");
  Suite suite;
  at_place(name, [&] {
    check_schema(json, schema);
    json.get_to(suite);
    const auto expected = std::exchange(suite.expected, {});
    for (const auto& [cell, outcome] : expected) suite.expected[canonical_cell(cell)] = outcome;
    check_suite(suite);
  });
  return suite;
}

void check_suite(const Suite& suite) {
  const auto check = [](bool holds, const std::string& what) {
    if (!holds) throw HarnessError(what);
  };
  check(suite.sources >= (suite.source_sets.empty() ? 1 : 0),
        "sources: a suite needs at least one source a mesh, or a set of sources");
  std::set<std::string> names;
  for (const std::string& set : suite.source_sets) {
    const std::string name = name_of_source_set(set);
    check(names.insert(name).second, "source_sets: two sets are called '" + name + "'");
  }
  check(suite.repetitions >= 1, "repetitions: a suite needs at least one repetition");
  check(suite.min_time > 0 && std::isfinite(suite.min_time),
        "min_time: the least time of a repetition must be a positive number of seconds");
  check(suite.time_limit > 0, "time_limit: a cell needs a positive number of seconds");
  check(!suite.memory_limit || *suite.memory_limit >= kLeastMemory,
        "memory_limit: a cell needs at least " + std::to_string(kLeastMemory >> 20) +
            " MiB: the program itself takes that");
  check_name("corpus name", suite.corpus);
  instruction_set_named(suite.vectors);
}

std::filesystem::path default_suite() { return suites_folder() / "default.json"; }

Suite suite_of_corpus(const std::string& corpus) {
  check_name("corpus name", corpus);
  const std::filesystem::path file = suites_folder() / (corpus + ".json");
  if (!std::filesystem::exists(file)) return read_suite(default_suite());
  std::cerr << "the options of " << file.string() << " are used, where no other ones are given\n";
  return read_suite(file);
}

}  // namespace geodesic::harness
