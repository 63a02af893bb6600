// Tables as a terminal and as Markdown show them.
#pragma once

#include <string>
#include <vector>

namespace geodesic::harness {

/// Rows of cells; the first row is the heading. Rows may be of different length.
using TextTable = std::vector<std::vector<std::string>>;

/// Columns under each other, two spaces before and between them.
std::string as_text(const TextTable& table);

std::string as_markdown(const TextTable& table);

}  // namespace geodesic::harness
