#include "harness/results/text_table.h"

#include <algorithm>

namespace geodesic::harness {

std::string as_text(const TextTable& table) {
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

std::string as_markdown(const TextTable& table) {
  std::string text;
  for (const auto& row : table) {
    text += "|";
    for (const std::string& cell : row) text += ' ' + cell + " |";
    text += '\n';
    if (&row == &table.front()) {
      text += "|";
      for (std::size_t c = 0; c < row.size(); ++c) text += " --- |";
      text += '\n';
    }
  }
  return text;
}

}  // namespace geodesic::harness
