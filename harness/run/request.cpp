#include "harness/run/request.h"

#include <array>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace {

constexpr std::array<std::string_view, 3> kRecordings{"none", "auto", "all"};  // in enum order

}  // namespace

Recordings recordings_named(const std::string& word) {
  return static_cast<Recordings>(&named("choice of recordings", kRecordings, word) -
                                 kRecordings.data());
}

void to_json(Json& json, Recordings choice) {
  json = kRecordings[static_cast<std::size_t>(choice)];
}

void from_json(const Json& json, Recordings& choice) { choice = recordings_named(json); }

}  // namespace geodesic::harness
