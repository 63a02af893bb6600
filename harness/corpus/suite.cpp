#include "harness/corpus/suite.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"

namespace geodesic::harness {
namespace {

constexpr std::uint64_t kLeastMemory = std::uint64_t{128} << 20;  // of address space

using Setter = std::function<void(Suite&, const Json&)>;
using Setters = std::map<std::string, Setter>;

// A whole number that fits; nlohmann would turn 2.5 into 2 and -1 into a large one.
template <class Integer>
void set_integer(Integer& into, const Json& value) {
  if (!value.is_number_unsigned()) throw HarnessError("is not a non-negative integer");
  if (!std::in_range<Integer>(value.get<std::uint64_t>())) {
    throw HarnessError("is too large: at most " +
                       std::to_string(std::numeric_limits<Integer>::max()));
  }
  into = value.get<Integer>();
}

void set_expected(Suite& suite, const Json& value) {
  for (const auto& [cell, name] : value.get<std::map<std::string, std::string>>()) {
    if (cell.find('/') == std::string::npos) {
      throw HarnessError("expected: '" + cell + "' is not solver/mesh, such as mmp/horse");
    }
    suite.expected[canonical_cell(cell)] =
        named("outcome that can be expected", kExpectable, name, name_of);
  }
}

const Setters& setters() {
  static const Setters all{
      {"solvers", [](Suite& s, const Json& v) { v.get_to(s.solvers); }},
      {"corpus", [](Suite& s, const Json& v) { v.get_to(s.corpus); }},
      {"meshes", [](Suite& s, const Json& v) { v.get_to(s.meshes); }},
      {"sources", [](Suite& s, const Json& v) { set_integer(s.sources, v); }},
      {"source_sets", [](Suite& s, const Json& v) { v.get_to(s.source_sets); }},
      {"repetitions", [](Suite& s, const Json& v) { set_integer(s.repetitions, v); }},
      {"seed", [](Suite& s, const Json& v) { set_integer(s.seed, v); }},
      {"other_queries", [](Suite& s, const Json& v) { set_integer(s.other_queries, v); }},
      {"path_targets", [](Suite& s, const Json& v) { set_integer(s.path_targets, v); }},
      {"min_time", [](Suite& s, const Json& v) { v.get_to(s.min_time); }},
      {"reference", [](Suite& s, const Json& v) { s.reference = v.get<std::string>(); }},
      {"vectors", [](Suite& s, const Json& v) { v.get_to(s.vectors); }},
      {"time_limit", [](Suite& s, const Json& v) { v.get_to(s.time_limit); }},
      {"memory_limit", [](Suite& s, const Json& v) { set_integer(s.memory_limit.emplace(), v); }},
      {"expected", set_expected},
  };
  return all;
}

void set(Suite& suite, const std::string& key, const Json& value) {
  const Setter& setter =
      named("key of a suite", setters(), key, &Setters::value_type::first).second;
  try {
    setter(suite, value);
  } catch (const Json::exception& error) {
    throw HarnessError("\"" + key + "\": " + shown(value) + ": " + reason_of(error));
  } catch (const HarnessError& error) {
    throw HarnessError("\"" + key + "\": " + shown(value) + ' ' + error.what());
  }
}

std::filesystem::path suites_folder() { return data_folder() / "harness" / "suites"; }

}  // namespace

Suite read_suite(const std::filesystem::path& file) {
  return parse_suite(read_json(file, "a suite, such as " + default_suite().string()),
                     file.string());
}

Suite parse_suite(const Json& json, const std::string& name) {
  Suite suite;
  at_place(name, [&] {
    if (!json.is_object()) throw HarnessError("a suite is a JSON object");
    for (const auto& [key, value] : json.items()) set(suite, key, value);
    check_suite(suite);
  });
  return suite;
}

void to_json(Json& json, const Suite& suite) {
  json = {{"solvers", suite.solvers},
          {"corpus", suite.corpus},
          {"meshes", suite.meshes},
          {"sources", suite.sources},
          {"source_sets", suite.source_sets},
          {"repetitions", suite.repetitions},
          {"seed", suite.seed},
          {"other_queries", suite.other_queries},
          {"path_targets", suite.path_targets},
          {"min_time", suite.min_time},
          {"vectors", suite.vectors},
          {"time_limit", suite.time_limit},
          {"expected", Json::object()}};
  for (const auto& [cell, outcome] : suite.expected) json["expected"][cell] = name_of(outcome);
  if (suite.reference) json["reference"] = *suite.reference;
  if (suite.memory_limit) json["memory_limit"] = *suite.memory_limit;
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
  return read_suite(std::filesystem::exists(file) ? file : default_suite());
}

}  // namespace geodesic::harness
