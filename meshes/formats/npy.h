// Arrays in numpy's .npy files, format version 1.0, little-endian.
//
// `numpy.load(file)` returns an array of numbers, of one or two dimensions, or a structured array:
// a table whose columns have their own names and types.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meshes/formats/bytes.h"

namespace geodesic {

/// numpy's name of a number's type: "<f8".
template <class T>
constexpr std::string_view npy_type() {
  if constexpr (std::same_as<T, std::int16_t>) return "<i2";
  if constexpr (std::same_as<T, std::int32_t>) return "<i4";
  if constexpr (std::same_as<T, std::int64_t>) return "<i8";
  if constexpr (std::same_as<T, std::uint32_t>) return "<u4";
  if constexpr (std::same_as<T, std::uint64_t>) return "<u8";
  if constexpr (std::same_as<T, float>) return "<f4";
  if constexpr (std::same_as<T, double>) return "<f8";
}

/// Returns the bytes that precede the numbers of an array in a file.
/// @param description numpy's type of an entry: "'<f8'", "[('face', '<u4'), ('level', '<f4')]"
/// @param shape "(7,)", "(7, 3)"
std::string npy_header(std::string_view description, std::string_view shape);

/// Returns the bytes of a file with an array of numbers. The array has one dimension or, if
/// `columns` is not 0, two: the numbers are then its rows, one after the other.
template <class T>
std::string npy_bytes(std::span<const T> numbers, std::size_t columns = 0) {
  const std::string shape =
      columns == 0 ? std::to_string(numbers.size()) + ","
                   : std::to_string(numbers.size() / columns) + ", " + std::to_string(columns);
  std::string bytes = npy_header("'" + std::string(npy_type<T>()) + "'", "(" + shape + ")");
  for (const T number : numbers) append_little_endian(bytes, number);
  return bytes;
}

/// One column of a table: its name in the file and the member of the rows, stored as type T.
template <class T, class Row, class Member>
struct NpyColumn {
  using Type = T;
  std::string_view name;
  Member Row::*member;
};

/// `npy_column<float>("level", &Row::level)`
template <class T, class Row, class Member>
NpyColumn<T, Row, Member> npy_column(std::string_view name, Member Row::*member) {
  return {name, member};
}

/// Returns the bytes of a file with a table, as a structured array.
template <class Row, class... Columns>
std::string npy_table_bytes(const std::vector<Row>& rows, const Columns&... columns) {
  std::string description;
  const auto describe = [&](std::string_view name, std::string_view type) {
    description += description.empty() ? "[" : ", ";
    description.append("('").append(name).append("', '").append(type).append("')");
  };
  (describe(columns.name, npy_type<typename Columns::Type>()), ...);
  std::string bytes = npy_header(description + "]", "(" + std::to_string(rows.size()) + ",)");
  for (const Row& row : rows) {
    (append_little_endian(bytes, static_cast<typename Columns::Type>(row.*columns.member)), ...);
  }
  return bytes;
}

/// Numbers in rows, one row after the other.
struct Array {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> values;

  double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// Reads a two-dimensional array of little-endian '<i2', '<i4', '<f4' or '<f8' in C order.
/// @param name the file's name, for messages
/// @throws MeshError for any other array, for a shape that does not fit the file's size, and for
///         numbers that are not finite
Array parse_npy(std::string_view bytes, const std::string& name);

/// Returns whether the bytes begin like a .npy file.
bool is_npy(std::string_view bytes);

/// Reads all numbers of an array of any shape, in the order of the file; they need not be finite.
/// @param name the file's name, for messages
/// @throws MeshError for anything but an array of the types of parse_npy
std::vector<double> parse_npy_numbers(std::string_view bytes, const std::string& name);

}  // namespace geodesic
