#include "harness/corpus/names.h"

#include <algorithm>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace {

constexpr std::size_t kLongest = 100;

// Of ASCII, whatever the locale.
bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

void check_name(std::string_view kind, std::string_view name) {
  const bool fits = !name.empty() && name.size() <= kLongest && is_letter_or_digit(name[0]) &&
                    std::all_of(name.begin(), name.end(), [](char c) {
                      return is_letter_or_digit(c) || c == '.' || c == '_' || c == '-';
                    });
  if (fits) return;
  throw HarnessError("invalid " + std::string(kind) + " '" + excerpt(name) + "': use at most " +
                     std::to_string(kLongest) +
                     " letters, digits, '.', '_' and '-', and begin with a letter or digit");
}

}  // namespace geodesic::harness
