#include "harness/verify/distance_file.h"

#include <fstream>

#include "harness/base/error.h"
#include "harness/base/files.h"

namespace geodesic::harness {

void write_distances(const std::filesystem::path& file, std::span<const double> distances) {
  write_bytes(file, {reinterpret_cast<const char*>(distances.data()), distances.size_bytes()});
}

std::vector<double> read_distances(const std::filesystem::path& file, std::size_t vertices) {
  std::vector<double> distances(vertices);
  const auto bytes = static_cast<std::streamsize>(vertices * sizeof(double));
  std::ifstream in(file, std::ios::binary);
  in.read(reinterpret_cast<char*>(distances.data()), bytes);
  if (in.gcount() != bytes || in.peek() != std::ifstream::traits_type::eof()) {
    throw HarnessError("'" + file.string() + "' does not hold " + std::to_string(vertices) +
                       " distances");
  }
  return distances;
}

}  // namespace geodesic::harness
