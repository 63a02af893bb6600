#include "harness/results/text_table.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "harness/base/error.h"

namespace geodesic::harness {

namespace {

// Names out of files, shown as they are only where they are harmless.
TextTable to_show(TextTable table) {
  for (auto& row : table) {
    for (std::string& cell : row) cell = harmless(cell);
  }
  return table;
}

}  // namespace

std::string as_text(const TextTable& given) {
  const TextTable table = to_show(given);
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

std::string as_markdown(const TextTable& given) {
  const TextTable table = to_show(given);
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

std::string as_latex(const TextTable& table) {
  std::size_t columns = 0;
  for (const auto& row : table) columns = std::max(columns, row.size());
  std::string text = "\\begin{tabular}{l" + std::string(columns - 1, 'r') + "}\n\\toprule\n";
  for (const auto& row : table) {
    for (std::size_t c = 0; c < row.size(); ++c)
      text += (c > 0 ? " & " : "") + escape_latex(row[c]);
    text += " \\\\\n";
    if (&row == &table.front()) text += "\\midrule\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string escape_latex(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '\\':
        escaped += "\\textbackslash{}";
        break;
      case '~':
        escaped += "$\\sim$";
        break;
      case '^':
        escaped += "\\textasciicircum{}";
        break;
      case '<':
        escaped += "$<$";
        break;
      case '>':
        escaped += "$>$";
        break;
      default:
        if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
  }
  return escaped;
}

std::string number(double value, const char* pattern) {
  char text[40];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

}  // namespace geodesic::harness
