#include "harness/corpus/suite.h"

#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "harness/corpus/vectors.h"
#include "harness/error.h"
#include "harness/folders.h"
#include "harness/results/atomic_file.h"

namespace geodesic::harness {
namespace {

using Setter = std::function<void(Suite&, const Json&)>;

// A whole number that fits; nlohmann would turn 2.5 into 2 and -1 into a large one.
template <class Integer>
void set_integer(Integer& into, const Json& value) {
  if (!value.is_number_unsigned()) throw HarnessError("is no whole number of 0 or more");
  if (!std::in_range<Integer>(value.get<std::uint64_t>())) throw HarnessError("is too large");
  into = value.get<Integer>();
}

const std::map<std::string, Setter>& setters() {
  static const std::map<std::string, Setter> all{
      {"solvers", [](Suite& s, const Json& v) { v.get_to(s.solvers); }},
      {"corpus", [](Suite& s, const Json& v) { v.get_to(s.corpus); }},
      {"meshes", [](Suite& s, const Json& v) { v.get_to(s.meshes); }},
      {"sources", [](Suite& s, const Json& v) { set_integer(s.sources, v); }},
      {"repetitions", [](Suite& s, const Json& v) { set_integer(s.repetitions, v); }},
      {"seed", [](Suite& s, const Json& v) { set_integer(s.seed, v); }},
      {"min_time", [](Suite& s, const Json& v) { v.get_to(s.min_time); }},
      {"reference", [](Suite& s, const Json& v) { s.reference = v.get<std::string>(); }},
      {"vectors", [](Suite& s, const Json& v) { v.get_to(s.vectors); }},
  };
  return all;
}

void set(Suite& suite, const std::string& key, const Json& value) {
  const auto at = setters().find(key);
  if (at == setters().end()) {
    std::vector<std::string> known;
    for (const auto& [name, setter] : setters()) known.push_back(name);
    throw HarnessError(unknown_name("key of a suite", key, known));
  }
  try {
    at->second(suite, value);
  } catch (const std::exception& error) {
    throw HarnessError("\"" + key + "\": " + value.dump() + ' ' + error.what());
  }
}

}  // namespace

Suite read_suite(const std::filesystem::path& file) {
  const Json json = read_json(file);
  Suite suite;
  try {
    if (!json.is_object()) throw HarnessError("a suite is a JSON object");
    for (const auto& [key, value] : json.items()) set(suite, key, value);
    check_suite(suite);
  } catch (const HarnessError& error) {
    throw HarnessError(file.string() + ": " + error.what());
  }
  return suite;
}

void check_suite(const Suite& suite) {
  if (suite.sources < 1) throw HarnessError("a suite needs at least one source a mesh");
  if (suite.repetitions < 1) throw HarnessError("a suite needs at least one repetition");
  if (!(suite.min_time > 0) || !std::isfinite(suite.min_time)) {
    throw HarnessError("the least time of a repetition must be a positive number of seconds");
  }
  instruction_set_named(suite.vectors);
}

std::filesystem::path default_suite() {
  return data_folder() / "harness" / "suites" / "default.json";
}

}  // namespace geodesic::harness
