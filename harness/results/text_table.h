// Tables as a terminal, Markdown and LaTeX show them.
#pragma once

#include <string>
#include <vector>

namespace geodesic::harness {

/// Rows of cells; the first row is the heading. Rows may be of different length.
using TextTable = std::vector<std::vector<std::string>>;

/// Columns under each other, two spaces before and between them.
std::string as_text(const TextTable& table);

std::string as_markdown(const TextTable& table);

/// A `tabular` with the rules of package booktabs, every text escaped; the first column is flush
/// left, numbers in the others flush right.
std::string as_latex(const TextTable& table);

/// Text in which no character means anything to LaTeX.
std::string escape_latex(const std::string& text);

/// As printf writes it.
std::string number(double value, const char* pattern = "%.4g");

}  // namespace geodesic::harness
