#include "harness/cells/request.h"

#include <algorithm>
#include <array>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace {

constexpr std::array<std::string_view, 3> kRecordings{"none", "auto", "all"};  // as the enum

}  // namespace

Recordings recordings_named(const std::string& word) {
  const auto at = std::ranges::find(kRecordings, word);
  if (at == kRecordings.end()) {
    throw HarnessError(
        unknown_name("choice of recordings", word, {kRecordings.begin(), kRecordings.end()}));
  }
  return static_cast<Recordings>(at - kRecordings.begin());
}

void to_json(Json& json, const RunRequest& request) {
  Json programs = Json::object();
  for (const auto& [name, file] : request.programs) programs[name] = file.string();
  json = {{"suite", request.suite},
          {"manifest", request.manifest.string()},
          {"recordings", kRecordings[static_cast<std::size_t>(request.recordings)]},
          {"benchmark_flags", request.benchmark_flags},
          {"repair", request.repair},
          {"interleave", request.interleave},
          {"programs", programs},
          {"cells", request.cells}};
}

void from_json(const Json& json, RunRequest& request) {
  request.suite = parse_suite(json.at("suite"), "the suite");
  request.manifest = json.at("manifest").get<std::string>();
  request.recordings = recordings_named(json.at("recordings"));
  json.at("benchmark_flags").get_to(request.benchmark_flags);
  json.at("repair").get_to(request.repair);
  json.at("interleave").get_to(request.interleave);
  for (const auto& [name, file] : json.at("programs").items()) {
    request.programs.push_back({name, file.get<std::string>()});
  }
  json.at("cells").get_to(request.cells);
}

}  // namespace geodesic::harness
