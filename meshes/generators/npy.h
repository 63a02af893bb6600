// Two-dimensional arrays of numbers in numpy's .npy files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic::generators {

/// Numbers in rows, one row after the other.
struct Array {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;

  double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// Reads format version 1.0 with little-endian '<i2', '<i4', '<f4' or '<f8' in C order.
/// @param name what messages call the file
/// @throws harness::HarnessError for anything else, a shape that does not fit the file's size, and
///         numbers that are not finite
Array parse_npy(std::string_view bytes, const std::string& name);

}  // namespace geodesic::generators
