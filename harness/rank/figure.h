// The figure of a ranking, drawn by Python.
#pragma once

#include <filesystem>
#include <string>

namespace geodesic::harness {

/// Draws rank.pdf and rank.png from the folder's rank.json by plots/rank.py.
/// @return a line to show: where the figure is, or why there is none and how to draw it later
std::string draw_rank_figure(const std::filesystem::path& folder);

}  // namespace geodesic::harness
