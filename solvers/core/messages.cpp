#include "solvers/core/messages.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <utility>

namespace geodesic {
namespace {

// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other;
// no letter is edited twice (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({last[j] + (a[i] == b[j] ? 0 : 1), row[j] + 1, last[j + 1] + 1});
      const bool swapped = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (swapped) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
    before = std::exchange(last, row);
  }
  return last.back();
}

// Number of bytes of the first character of the text if it can be shown: well-formed UTF-8 (The
// Unicode Standard, table 3-7) and no control character. Otherwise 0.
std::size_t bytes_to_show(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  unsigned least = 0x80, most = 0xbf;  // of the second byte
  if (lead == 0xc2) least = 0xa0;      // below are control characters
  if (lead == 0xe0) least = 0xa0;      // below are characters of two bytes
  if (lead == 0xed) most = 0x9f;       // above are surrogates
  if (lead == 0xf0) least = 0x90;      // below are characters of three bytes
  if (lead == 0xf4) most = 0x8f;       // above is the end of Unicode
  if (byte(1) < least || byte(1) > most) return 0;
  const std::size_t size = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  for (std::size_t i = 2; i < size; ++i) {
    if (byte(i) < 0x80 || byte(i) > 0xbf) return 0;
  }
  return size;
}

}  // namespace

std::string harmless(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string shown;
  while (!text.empty()) {
    const std::size_t size = bytes_to_show(text);
    if (size > 0) {
      shown += text.substr(0, size);
    } else {
      const auto byte = static_cast<unsigned char>(text.front());
      shown += {'\\', 'x', kDigits[byte / 16], kDigits[byte % 16]};
    }
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return shown;
}

std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known) {
  constexpr std::size_t kListed = 50, kNearest = 8;
  std::string message = "no " + std::string(kind) + " named '" + excerpt(name) + "'";
  if (known.empty()) return message + "; there are: none";
  // For a name longer than any known one, only its beginning counts.
  const std::string_view compared = name.substr(0, 100);
  std::vector<std::pair<std::size_t, std::string>> nearest;
  nearest.reserve(known.size());
  for (const std::string& each : known) nearest.emplace_back(edit_distance(compared, each), each);
  std::stable_sort(nearest.begin(), nearest.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto& [distance, best] = nearest.front();
  if (distance <= 1 + compared.size() / 4) message += " (did you mean '" + best + "'?)";
  if (known.size() <= kListed) return message + "; there are: " + join(known);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kNearest; ++i) names.push_back(nearest[i].second);
  return message + "; the nearest of " + std::to_string(known.size()) + ": " + join(names);
}

std::string excerpt(std::string_view text, std::size_t longest) {
  std::size_t end = std::min(text.size(), longest);
  const auto continues = [&] { return (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80; };
  while (end < text.size() && end > 0 && continues()) --end;  // do not cut a UTF-8 character
  return harmless(text.substr(0, end)) + (end < text.size() ? "..." : "");
}

std::string significant(double x, int digits) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, x);
  return text.data();
}

std::string join(const std::vector<std::string>& words, std::string_view separator) {
  std::string all;
  for (const std::string& word : words) {
    if (!all.empty()) all += separator;
    all += word;
  }
  return all;
}

}  // namespace geodesic
