// Tables on a terminal.
#pragma once

#include <string>
#include <vector>

namespace geodesic::harness {

/// Rows of cells; the first row is the heading. Rows may be of different length.
using TextTable = std::vector<std::vector<std::string>>;

/// The table with columns aligned at the left, two spaces before and between them.
std::string as_text(TextTable table);

}  // namespace geodesic::harness
