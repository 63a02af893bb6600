// The folder that a run writes its results to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace geodesic::harness {

/// Makes the folder and in it `cells/` and `references/`.
/// @param out by default `results/<kind>/<UTC time>-<name>` of the checkout
/// @param kind "runs"
/// @throws HarnessError when it cannot be made, or holds results already: those never change
std::filesystem::path make_result_folder(const std::optional<std::filesystem::path>& out,
                                         const std::string& kind, const std::string& name);

}  // namespace geodesic::harness
