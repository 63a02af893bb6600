// The JSON type of the whole harness: keys stay in the order in which they were written.
#pragma once

#include <nlohmann/json.hpp>

namespace geodesic::harness {

using Json = nlohmann::ordered_json;

}  // namespace geodesic::harness
