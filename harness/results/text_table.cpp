#include "harness/results/text_table.h"

#include <algorithm>

#include "harness/base/error.h"

namespace geodesic::harness {

std::string as_text(TextTable table) {
  for (auto& row : table) {
    for (std::string& cell : row) cell = harmless(cell);  // names from files
  }
  std::vector<std::size_t> widths;
  for (const auto& row : table) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const auto& row : table) {
    std::string line = " ";
    for (std::size_t c = 0; c < row.size(); ++c) {
      line += ' ' + row[c] + std::string(widths[c] - row[c].size() + 1, ' ');
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace geodesic::harness
