#include "solvers/core/face_windows.h"

#include <algorithm>
#include <new>
#include <utility>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include "solvers/core/window_predicates.h"

namespace geodesic {
namespace {

void offer(AtTarget& best, double distance, const LastSegment& last_segment) {
  if (distance < best.distance) best = {distance, last_segment};
}

}  // namespace

void FaceWindows::end_run(Index h, const Packed* first, Packed* end) {
  next_ = end;
  const auto count = static_cast<std::uint32_t>(end - first);
  if (!runs_.empty() && runs_.back().half_edge == h &&
      runs_.back().first + runs_.back().count == first) {
    runs_.back().count += count;
  } else if (count > 0) {
    runs_.push_back({h, count, first});
  }
}

/// Without large pages, obtaining the memory takes twice as long.
void FaceWindows::open_block() {
  const std::size_t windows =
      blocks_.empty() ? kFirstBlock : std::min(2 * blocks_.back().windows, kLargestBlock);
  const std::size_t bytes = windows * sizeof(Packed);
  void* memory = std::aligned_alloc(bytes, bytes);
  if (memory == nullptr) throw std::bad_alloc();
  blocks_.push_back({decltype(Block::memory)(memory), windows});
#ifdef __linux__
  if (windows == kLargestBlock) madvise(memory, bytes, MADV_HUGEPAGE);  // a request
#endif
  next_ = static_cast<Packed*>(memory);
  block_end_ = next_ + windows;
}

void FaceWindows::finish(const InternalQuery& query, std::span<const double> distances,
                         std::span<const LastSegment> last_segments) {
  sort_runs_by_face();
  root_distances_.assign(distances.begin(), distances.end());
  sends_lines_.resize(distances.size());
  for (Index v = 0; v < distances.size(); ++v) {
    sends_lines_[v] = mesh_.is_pseudo_source(v) || last_segments[v].root == v;
  }
  for (Index i = 0; i < query.sources.size(); ++i) {
    const InternalSource& source = query.sources[i];
    root_distances_.push_back(source.distance);
    if (source.at.is_vertex()) continue;
    for (const InternalPoint& image : in_every_face(mesh_, source.at)) {
      sources_.push_back({image, i});
    }
  }
  std::ranges::stable_sort(sources_, {}, &SourceImage::face);
}

void FaceWindows::sort_runs_by_face() {
  first_run_.assign(mesh_.face_count() + std::size_t{1}, 0);
  for (const Run& run : runs_) ++first_run_[run.half_edge / 3];
  std::uint64_t sum = 0;
  for (std::uint64_t& first : first_run_) sum += std::exchange(first, sum);
  std::vector<Run> sorted(runs_.size());
  for (const Run& run : runs_) sorted[first_run_[run.half_edge / 3]++] = run;
  // Each entry is now that of the next face.
  std::shift_right(first_run_.begin(), first_run_.end(), 1);
  first_run_.front() = 0;
  runs_ = std::move(sorted);
}

AtTarget FaceWindows::nearest(const InternalPoint& point, const AtTarget& known) const {
  AtTarget best = known;
  const auto offer_all = [&](const InternalPoint& image) {
    offer_windows(image, best);
    offer_corners(image, best);
    offer_sources(image, best);
  };
  if (edge_under(point) == kNone && !mesh_.crosses_non_manifold_edges()) {
    offer_all(point);
  } else {
    for (const InternalPoint& image : in_every_face(mesh_, point)) offer_all(image);
  }
  return best;
}

void FaceWindows::offer_windows(const InternalPoint& point, AtTarget& best) const {
  const Index under = edge_under(point);
  for (const Run& run : runs_of(point.face)) {
    const Index h = run.half_edge;
    if (h == under) continue;  // these lines come to the point through the face below
    const double step = mesh_.half_edge(h).length / kSteps;
    const Point2 at = in_frame(mesh_, point, h);
    for (const Packed& packed : std::span(run.first, run.count)) {
      Window w{.begin = step * static_cast<double>(packed.begin >> kRootBits),
               .end = step * static_cast<double>(packed.end >> kRootBits),
               .x = packed.x,
               .y = packed.y,
               .sigma = 0};
      if (!WindowSight(w, at).reaches()) continue;
      const Index root = root_of(packed);
      w.sigma = root_distances_[root];
      offer(best, least_distance_to(w, at.x, at.y), {h, root, {w.x, w.y}});
    }
  }
}

void FaceWindows::offer_corners(const InternalPoint& point, AtTarget& best) const {
  for (Index h = 3 * point.face; h < 3 * point.face + 3; ++h) {
    const Index corner = mesh_.origin(h);
    const double distance = root_distances_[corner] + norm(in_frame(mesh_, point, h));
    // At a corner where no path bends, the line through it belongs to a window, which keeps a tie.
    if (!sends_lines_[corner] && distance > best.distance * (1 - kPathMargin)) continue;
    offer(best, distance, {h, corner, {0, 0}});
  }
}

void FaceWindows::offer_sources(const InternalPoint& point, AtTarget& best) const {
  for (const SourceImage& source :
       std::ranges::equal_range(sources_, point.face, {}, &SourceImage::face)) {
    // In the frame at the nearest corner: near it, coordinates have all digits of the weights.
    const auto largest = std::ranges::max_element(point.weights) - point.weights.begin();
    const Index h = 3 * point.face + static_cast<Index>(largest);
    const Point2 start = in_frame(mesh_, source.at, h), end = in_frame(mesh_, point, h);
    const Index root = mesh_.vertex_count() + source.source;
    offer(best, root_distances_[root] + norm(Point2{end.x - start.x, end.y - start.y}),
          {h, root, start});
  }
}

std::size_t FaceWindows::window_count() const {
  std::size_t count = 0;
  for (const Run& run : runs_) count += run.count;
  return count;
}

}  // namespace geodesic
