#include "solvers/straight_graph/graph.h"

#include <cmath>

namespace geodesic::straight_graph {
namespace {

/// Whether a block lies within its lines and leads to vertices only.
bool is_sound(std::span<const Block> lines, Index vertices) {
  const Block& block = lines.front();
  const std::uint64_t room = (lines.size() - 1) * (kCacheLine / sizeof(Link));
  if (std::uint64_t{block.edge_count} + block.link_count > room) return false;
  if (block.shift >= kSectors || block.width > kSectors || block.unit > 31) return false;
  if (!std::ranges::is_sorted(block.before)) return false;
  if ((std::uint64_t{block.before.back()} << block.unit) > block.link_count) return false;
  const auto leads_on = [vertices](const Link& link) {
    return link.target() < vertices && std::isfinite(link.length()) && !(link.length() < 0);
  };
  return std::ranges::all_of(block.edges(), leads_on) &&
         std::ranges::all_of(block.links(), leads_on);
}

}  // namespace

Graph::Graph(Index vertices, PreparedReader& from) : Graph(vertices) {
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    const std::vector<std::uint32_t> begins = from.read<std::uint32_t>();
    const std::vector<Block> lines = from.read<Block>();
    const std::size_t first = piece * kPiece;
    PreparedReader::check(begins.size() == std::min<std::size_t>(kPiece, vertices - first));
    for (std::size_t i = 0; i < begins.size(); ++i) {
      const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : lines.size();
      PreparedReader::check(begins[i] < end && end <= lines.size());
      PreparedReader::check(
          is_sound(std::span(lines).subspan(begins[i], end - begins[i]), vertices));
    }
    set_piece(piece, lines, begins);
  }
}

void Graph::save(PreparedWriter& to) const {
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    const std::size_t first = piece * kPiece;
    to.write(
        std::span(places_).subspan(first, std::min<std::size_t>(kPiece, places_.size() - first)));
    to.write(std::span<const Block>(pieces_[piece]));
  }
}

}  // namespace geodesic::straight_graph
