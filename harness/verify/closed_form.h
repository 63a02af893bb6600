// Distances that are known without any solver: those of generated meshes with a closed form.
#pragma once

#include <optional>
#include <vector>

#include "harness/corpus/manifest.h"

namespace geodesic::harness {

/// What stands in a row's `reference`, in place of a solver's name.
inline constexpr const char* kClosedForm = "closed-form";

/// Whether the mesh's generator states a closed form.
bool has_closed_form(const MeshEntry& entry);

/// The known distances from `source`; nothing when there is no closed form.
/// @param soup the mesh as it was read from the entry's file
/// @throws HarnessError when the file holds another mesh than the manifest's generator and
///         parameters make, or these are wrong
std::optional<std::vector<double>> closed_form_distances(const MeshEntry& entry,
                                                         const TriangleSoup& soup, Index source);

}  // namespace geodesic::harness
