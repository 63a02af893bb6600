#include "harness/error.h"

#include <algorithm>
#include <numeric>

namespace geodesic::harness {
namespace {

// Levenshtein 1966: insertions, deletions and substitutions that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known) {
  std::string message = "no " + std::string(kind) + " named '" + printable(name) + "'";
  const std::size_t tolerated = 1 + name.size() / 4;
  std::size_t least = tolerated + 1;
  std::string_view nearest;
  for (const std::string& candidate : known) {
    // The distance is no less than that of the lengths, and not looked for in vain.
    if (candidate.size() > name.size() + tolerated || name.size() > candidate.size() + tolerated) {
      continue;
    }
    const std::size_t distance = edit_distance(name, candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  if (least <= tolerated) message += " (did you mean '" + std::string(nearest) + "'?)";
  return message + "; there are: " + (known.empty() ? "none" : join(known));
}

std::string printable(std::string_view text) {
  constexpr std::size_t kLongest = 200;
  std::size_t end = std::min(text.size(), kLongest);
  const auto continues = [&] { return (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80; };
  while (end < text.size() && end > 0 && continues()) --end;  // not inside a character of UTF-8
  std::string shown(text.substr(0, end));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return end < text.size() ? shown + "..." : shown;
}

std::string join(const std::vector<std::string>& words, std::string_view separator) {
  std::string all;
  for (const std::string& word : words) {
    if (!all.empty()) all += separator;
    all += word;
  }
  return all;
}

}  // namespace geodesic::harness
