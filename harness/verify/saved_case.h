// A check in a file of JSON beside its mesh: the solver, the property, and the queries.
#pragma once

#include <filesystem>
#include <string>

#include "harness/verify/property.h"

namespace geodesic::harness {

struct SavedCase {
  std::string solver, property, vectors;
  Case given;
};

/// The mesh file of a case: FILE with the suffix .obj.
std::filesystem::path mesh_beside(const std::filesystem::path& file);

/// @throws HarnessError when it cannot be written
void write_mesh(const Case& given, const std::filesystem::path& file);

/// Writes FILE and the mesh beside it.
/// @throws HarnessError when one of them cannot be written
void write_case(const SavedCase& saved, const std::filesystem::path& file);

/// @throws HarnessError when a file cannot be read or is not one that write_case wrote
SavedCase read_case(const std::filesystem::path& file);

}  // namespace geodesic::harness
