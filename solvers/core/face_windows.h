// The windows of one solve that cross faces, from which the distance of any point of these faces
// follows without another solve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "solvers/core/query.h"
#include "solvers/core/recording.h"

namespace geodesic {

/// A shortest path to a point of a face comes from a corner of the face, from a source in the face,
/// or straight through one of the windows that cross the face (Mitchell, Mount, Papadimitriou 1987,
/// section 3). The solver adds the windows in any order, trimmed or not: each is a bundle of lines
/// that exist, so the least distance over all of them is exact if the solver's distances are.
/// Windows take 32 bytes each. After `finish` the object is constant: any number of threads may use
/// it. Vertices, faces and half-edges have internal numbers.
class FaceWindows {
 public:
  /// @param mesh must outlive this object
  explicit FaceWindows(const Mesh& mesh) : mesh_(mesh) {}

  /// Adds windows that cross the face of h.
  /// @param for_each_window calls its argument as (const Window&, Index root) for each of them: in
  ///        the frame of h; the root as in LastSegment
  template <class ForEachWindow>
  void add(Index h, const ForEachWindow& for_each_window) {
    const double steps = kSteps / mesh_.half_edge(h).length;  // per unit of length
    Packed *first = next_, *next = next_, *end = block_end_;
    for_each_window([&](const Window& w, Index root) {
      if (next == end) [[unlikely]] {
        end_run(h, first, next);
        open_block();
        first = next = next_;
        end = block_end_;
      }
      *next++ = {w.x, w.y, packed(w.begin * steps + 0.5, root >> kRootBits),
                 packed(w.end * steps + 0.5, root & 0xffff)};
    });
    end_run(h, first, next);
  }

  /// Call once, after the solve.
  /// @param query the query that was solved
  /// @param distances, last_segments by vertex
  void finish(const InternalQuery& query, std::span<const double> distances,
              std::span<const LastSegment> last_segments);

  /// The least distance of a point, and the last segment of a path of this length. Call `finish`
  /// first.
  /// @param point not a vertex, in faces all of whose windows were added
  /// @param known of another path to the point, which only a shorter one replaces
  AtTarget nearest(const InternalPoint& point, const AtTarget& known = {}) const;

  std::size_t window_count() const;

 private:
  /// A window without sigma, which is the final distance of its root. The ends of its interval are
  /// multiples of the edge's length over kSteps, in 47 bits; 16 bits below them are half of the
  /// root. This moves an end by at most 4e-15 of the edge.
  struct Packed {
    double x, y;
    std::int64_t begin, end;
  };
  static_assert(sizeof(Packed) == 32);

  /// Successive windows of one half-edge.
  struct Run {
    Index half_edge;
    std::uint32_t count;
    const Packed* first;
  };

  /// A source in one of the faces that contain it.
  struct SourceImage {
    InternalPoint at;
    Index source;
    Index face() const { return at.face; }
  };

  /// Memory for some windows.
  struct Block {
    struct Free {
      void operator()(void* block) const { std::free(block); }
    };
    std::unique_ptr<void, Free> memory;
    std::size_t windows;
  };

  static constexpr unsigned kRootBits = 16;
  static constexpr double kSteps = (std::int64_t{1} << 47) - 1;
  // Windows of a block: each has twice as many as the one before, up to 2 MB, a large page.
  static constexpr std::size_t kFirstBlock = std::size_t{1} << 8;
  static constexpr std::size_t kLargestBlock = std::size_t{1} << 16;

  // Signed, since their conversions are single instructions.
  static std::int64_t packed(double steps, Index half_root) {
    return static_cast<std::int64_t>(steps) << kRootBits | half_root;
  }
  static Index root_of(const Packed& w) {
    return static_cast<Index>((w.begin & 0xffff) << kRootBits | (w.end & 0xffff));
  }

  void open_block();
  void end_run(Index h, const Packed* first, Packed* end);
  void sort_runs_by_face();
  std::span<const Run> runs_of(Index face) const {
    return {runs_.data() + first_run_[face], runs_.data() + first_run_[face + 1]};
  }
  void offer_windows(const InternalPoint& point, AtTarget& best) const;
  void offer_corners(const InternalPoint& point, AtTarget& best) const;
  void offer_sources(const InternalPoint& point, AtTarget& best) const;

  const Mesh& mesh_;
  std::vector<Block> blocks_;
  Packed *next_ = nullptr, *block_end_ = nullptr;  // in the last block
  std::vector<Run> runs_;
  // Set by `finish`.
  std::vector<std::uint64_t> first_run_;  // by face, then their number
  std::vector<double> root_distances_;    // by root, as in LastSegment
  std::vector<bool> sends_lines_;         // by vertex: a pseudo-source, or a source of the query
  std::vector<SourceImage> sources_;      // by face
};

}  // namespace geodesic
