// Assembles a graph from the links of its vertices.
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include "solvers/core/thread_team.h"
#include "solvers/straight_graph/graph.h"

namespace geodesic::straight_graph {

/// Appends a block in whole cache lines.
/// @param block its header
/// @param links edge_count along edges, then link_count others
inline void append_block(const Block& block, std::span<const Link> links,
                         std::vector<Block>& lines) {
  lines.push_back(block);
  const std::size_t at = lines.size(), bytes = links.size_bytes();
  lines.resize(at + (bytes + kCacheLine - 1) / kCacheLine);
  if (bytes > 0) std::memcpy(&lines[at], links.data(), bytes);
}

/// Builds a graph. It is the same to the last bit with any number of threads.
/// @param threads at least 1
/// @param make_builder called as () by each thread. The result is called as (Index v,
///        std::vector<Block>& lines) and appends the block of v
template <class MakeBuilder>
Graph assemble(Index vertices, unsigned threads, const MakeBuilder& make_builder) {
  Graph graph(vertices);
  const std::size_t count = graph.piece_count();
  ThreadTeam::run(threads, count, [&](ThreadTeam& team, unsigned thread) {
    auto builder = make_builder();
    std::vector<Block> lines;
    std::vector<std::uint32_t> begins;
    const auto build = [&](std::size_t piece) {
      lines.clear();
      begins.clear();
      const std::size_t first = piece * Graph::kPiece;
      const std::size_t end = std::min<std::size_t>(first + Graph::kPiece, vertices);
      for (std::size_t v = first; v < end; ++v) {
        begins.push_back(static_cast<std::uint32_t>(lines.size()));
        builder(static_cast<Index>(v), lines);
      }
      graph.set_piece(piece, lines, begins);
    };
    team.share(thread, count, team.in_equal_parts(count), build, [] {});
  });
  return graph;
}

}  // namespace geodesic::straight_graph
