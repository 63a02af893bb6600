// Conversion of numbers to and from the bytes and the text of files.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <string>

namespace geodesic {

/// Reads a number of type T from `bytes` in the given byte order.
template <class T>
T load_number(const char* bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

/// Stores a number at `bytes` in little-endian order.
template <class T>
void store_little_endian(T number, char* bytes) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
  if (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  std::memcpy(bytes, raw.data(), sizeof(T));
}

/// Appends a number in little-endian order.
template <class T>
void append_little_endian(std::string& bytes, T number) {
  std::array<char, sizeof(T)> raw;
  store_little_endian(number, raw.data());
  bytes.append(raw.data(), raw.size());
}

/// Appends a number in big-endian order.
template <class T>
void append_big_endian(std::string& bytes, T number) {
  append_little_endian(bytes, number);
  std::reverse(bytes.end() - sizeof(T), bytes.end());
}

/// Appends a number as text, independently of the locale, unlike streams. Without a format, a real
/// number is written with the fewest digits that restore it exactly.
template <class Number, class... Format>
void append_text(std::string& text, Number number, Format... format) {
  std::array<char, 40> digits;
  const auto [end, error] =
      std::to_chars(digits.data(), digits.data() + digits.size(), number, format...);
  text.append(digits.data(), end);
}

}  // namespace geodesic
