// Texts that are numbers.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace geodesic {

/// Returns the number that the whole text represents: decimal, with a point in every locale. Empty
/// when the text is no number or out of range.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return number;
}

}  // namespace geodesic
