// Reference distances between two processes: raw doubles of this machine, one a vertex.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

namespace geodesic::harness {

/// Writes whole or not at all. @throws HarnessError
void write_distances(const std::filesystem::path& file, std::span<const double> distances);

/// @throws HarnessError when the file does not hold `vertices` distances
std::vector<double> read_distances(const std::filesystem::path& file, std::size_t vertices);

}  // namespace geodesic::harness
