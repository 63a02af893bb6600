// The graph: straight links between vertices, and for each vertex those that go straight on.
//
// Paths are concatenations of links. A shortest path is straight at every vertex that is not a
// saddle, so that of the many links of a vertex only few continue a given path. The directions
// around a vertex are counted in sectors (sectors.h): a link knows in which sector it arrives, and
// the vertex there, which of its own links leave nearly opposite to that sector.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solvers/core/geometry.h"
#include "solvers/core/prefetch.h"
#include "solvers/core/prepared_arrays.h"

namespace geodesic::straight_graph {

/// Number of equal sectors into which the directions around a vertex are divided: as many as make
/// the header of a block fill a cache line.
inline constexpr unsigned kSectors = 53;

/// Stands for an arrival after which a path may go on in every direction.
inline constexpr unsigned kAnySector = 63;

/// A straight line over the surface to another vertex.
class Link {
 public:
  Link() = default;
  /// @param length rounded up by less than 2^-17 = 7.7e-6 of it
  /// @param sector in which the link arrives, at most kAnySector
  Link(Index target, double length, unsigned sector) : target_(target) {
    const auto nearest = static_cast<float>(length);
    const std::uint32_t up =
        std::bit_cast<std::uint32_t>(nearest) + (static_cast<double>(nearest) < length ? 1U : 0U);
    packed_ = ((up + kSectorBits) & ~kSectorBits) | sector;
  }

  Index target() const { return target_; }
  /// In the mesh's unit of length; at least that of the line, and 0 only if that is 0.
  double length() const {
    return static_cast<double>(std::bit_cast<float>(packed_ & ~kSectorBits));
  }
  unsigned sector() const { return packed_ & kSectorBits; }

 private:
  static constexpr std::uint32_t kSectorBits = 63;

  Index target_;
  std::uint32_t packed_;  // a float whose last bits are the sector
};

inline constexpr std::size_t kCacheLine = 64;  ///< bytes

/// What leaves a vertex: this header, the links along its edges, then all others in the order of
/// their directions. They lie in memory one after the other.
struct alignas(kCacheLine) Block {
  std::uint32_t edge_count;
  std::uint32_t link_count;  ///< of the other links
  /// A path that arrives in sector s goes on in the sectors from s + shift on, `width` of them;
  /// all numbers are modulo kSectors.
  std::uint8_t shift, width;
  std::uint8_t unit;  ///< logarithm to base 2 of the unit of `before`
  /// By sector: how many links leave in earlier ones, in whole units, rounded down.
  std::array<std::uint8_t, kSectors> before;

  std::span<const Link> edges() const { return {first(), edge_count}; }
  std::span<const Link> links() const { return {first() + edge_count, link_count}; }

  /// Calls scan(std::span<const Link>) once or twice: for the links, edges excepted, that continue
  /// a path that arrives in a sector. Where the unit is above 1, there may be some more.
  /// @param sector below kSectors
  template <class Scan>
  void for_straight_on(unsigned sector, const Scan& scan) const {
    const unsigned from = in_circle(sector + shift), to = from + width;
    if (to < kSectors) return scan(between(begin_of(from), end_of(to)));
    scan(between(begin_of(from), link_count));
    scan(between(0, end_of(to - kSectors)));
  }

  /// Starts to load the links that continue a path that arrives in a sector, kAnySector included.
  void prefetch_for(unsigned sector) const {
    if (sector >= kSectors) return;
    const Link* straight = links().data() + begin_of(in_circle(sector + shift));
    prefetch(straight);
    prefetch(straight + kCacheLine / sizeof(Link) - 1);
  }

 private:
  static unsigned in_circle(unsigned s) { return s < kSectors ? s : s - kSectors; }
  const Link* first() const { return reinterpret_cast<const Link*>(this + 1); }
  std::uint32_t begin_of(unsigned s) const { return std::uint32_t{before[s]} << unit; }
  std::uint32_t end_of(unsigned s) const {
    return std::min(begin_of(s) + (1U << unit) - 1, link_count);
  }
  std::span<const Link> between(std::uint32_t begin, std::uint32_t end) const {
    return links().subspan(begin, end - begin);
  }
};
static_assert(sizeof(Block) == kCacheLine && sizeof(Link) == 8);

/// The blocks of all vertices. Successive vertices lie in one piece of memory.
class Graph {
 public:
  static constexpr Index kPiece = 512;  ///< vertices

  explicit Graph(Index vertices) : pieces_(vertices / kPiece + 1), places_(vertices) {}
  Graph(Graph&&) = default;
  Graph& operator=(Graph&&) = default;

  /// Reads what `save` wrote for a mesh of that many vertices.
  /// @throws std::invalid_argument as PreparedReader; no link leads out of the mesh, and no block
  ///         out of its piece
  Graph(Index vertices, PreparedReader& from);
  void save(PreparedWriter& to) const;

  std::size_t piece_count() const { return pieces_.size(); }
  const Block& block(Index v) const { return pieces_[v / kPiece][places_[v]]; }
  /// Starts to load a block and its first edges.
  void prefetch_block(Index v) const {
    const Block* at = &block(v);
    prefetch(at);
    prefetch(at + 1);
  }

  /// Sets the blocks of the vertices from piece * kPiece on. Threads may set different pieces.
  /// @param lines the blocks, each followed by its links
  /// @param begins for each block, the index of its line
  void set_piece(std::size_t piece, std::span<const Block> lines,
                 std::span<const std::uint32_t> begins) {
    pieces_[piece].assign(lines.begin(), lines.end());
    std::ranges::copy(begins, places_.begin() + static_cast<std::ptrdiff_t>(piece * kPiece));
  }

 private:
  std::vector<std::vector<Block>> pieces_;  // of cache lines, most of which hold links
  std::vector<std::uint32_t> places_;       // by vertex: the line of its block in its piece
};

}  // namespace geodesic::straight_graph
