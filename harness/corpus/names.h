// What corpora and meshes of a manifest may be called.
#pragma once

#include <string_view>

namespace geodesic::harness {

/// Files and folders of a run are called by these names: letters, digits, '.', '_' and '-', the
/// first a letter or digit, at most 100 of them.
/// @param kind "name", "file name"
/// @throws HarnessError naming kind and name
void check_name(std::string_view kind, std::string_view name);

}  // namespace geodesic::harness
