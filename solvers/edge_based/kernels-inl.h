// The kernels of one instruction set, for eight (AVX-512) or four (AVX2) windows at once. What they
// compute: plain_kernels.h.
//
// Included once per instruction set (kernels.cpp). All operations are correctly rounded IEEE
// operations in a fixed order, without contraction, and minima are exact: all instruction sets give
// the same bits. Needs Google Highway.
#if defined(GEODESIC_EDGE_BASED_KERNELS) == defined(HWY_TARGET_TOGGLE)
#ifdef GEODESIC_EDGE_BASED_KERNELS
#undef GEODESIC_EDGE_BASED_KERNELS
#else
#define GEODESIC_EDGE_BASED_KERNELS
#endif

#include <hwy/highway.h>

#include "solvers/core/tolerance.h"
#include "solvers/edge_based/kernels.h"
#include "solvers/edge_based/plain_kernels.h"

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
HWY_BEFORE_NAMESPACE();
namespace geodesic::edge_based::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, kMostLanes>;
using Vec = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

inline constexpr std::size_t kLanes = hn::MaxLanes(Tag());

inline unsigned bits(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), mask, bytes);
  return bytes[0];
}

#if HWY_TARGET == HWY_AVX3
/// Stores the lanes of a mask contiguously, by an instruction that Highway 1.0 does not use.
class Packer {
 public:
  explicit Packer(unsigned mask) : mask_(static_cast<__mmask8>(mask)) {}
  std::size_t count() const { return hwy::PopCount(mask_); }
  /// Writes a whole vector; only its first count() lanes are meaningful.
  void store(Vec v, double* to) const {
    hn::StoreU(Vec{_mm512_maskz_compress_pd(mask_, v.raw)}, Tag(), to);
  }

 private:
  __mmask8 mask_;
};
#else
using Halves = hn::Repartition<std::int32_t, Tag>;  // of doubles: AVX2 permutes no wider lanes

/// For each mask, the order of halves that moves the lanes of the mask to the front.
struct PackingOrder {
  alignas(32) std::int32_t halves[std::size_t{1} << kLanes][2 * kLanes];

  constexpr PackingOrder() : halves() {
    for (unsigned mask = 0; mask < (1u << kLanes); ++mask) {
      unsigned to = 0;
      for (unsigned half = 0; half < 2 * kLanes; ++half) {
        if ((mask >> (half / 2) & 1) != 0) halves[mask][to++] = static_cast<std::int32_t>(half);
      }
    }
  }
};
static constexpr PackingOrder kPackingOrder;  // static: read without an indirection

/// Stores the lanes of a mask contiguously. One look-up serves all fields of a window.
class Packer {
 public:
  explicit Packer(unsigned mask)
      : count_(hwy::PopCount(mask)),
        order_(hn::SetTableIndices(Halves(), kPackingOrder.halves[mask])) {}
  std::size_t count() const { return count_; }
  /// Writes a whole vector; only its first count() lanes are meaningful.
  void store(Vec v, double* to) const {
    hn::StoreU(hn::BitCast(Tag(), hn::TableLookupLanes(hn::BitCast(Halves(), v), order_)), Tag(),
               to);
  }

 private:
  std::size_t count_;
  decltype(hn::SetTableIndices(Halves(), kPackingOrder.halves[0])) order_;
};
#endif

inline constexpr Tag kTag{};

inline Vec all(double value) { return hn::Set(kTag, value); }

/// The marks of windows i to i + kLanes - 1; i is a multiple of kLanes (Marks).
inline unsigned marks_at(const Marks& marks, std::size_t i) { return marks.groups()[i / kLanes]; }

inline Mask mask_of(unsigned marks) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(marks)};
  return hn::LoadMaskBits(kTag, bytes);
}

/// One vector of windows of a segment or batch.
struct Windows {
  Vec begin, end, x, y, sigma;
};

inline Windows windows_at(const Batch& batch, std::size_t i) {
  return {hn::LoadU(kTag, batch.array(kBegin) + i), hn::LoadU(kTag, batch.array(kEnd) + i),
          hn::LoadU(kTag, batch.array(kX) + i), hn::LoadU(kTag, batch.array(kY) + i),
          hn::LoadU(kTag, batch.array(kSigma) + i)};
}

/// EndpointBounds::beat for a vector of windows.
HWY_INLINE Mask beaten(const Windows& w, const EndpointBounds& ends) {
  const Vec zero = hn::Zero(kTag);
  const Vec y2 = hn::Mul(w.y, w.y);
  const Vec over_origin = hn::Sub(hn::Add(all(ends.at_origin), w.end), w.sigma);
  const Vec over_head =
      hn::Sub(hn::Add(all(ends.at_head), hn::Sub(all(ends.length), w.begin)), w.sigma);
  const Vec to_end = hn::Sub(w.end, w.x), to_begin = hn::Sub(w.begin, w.x);
  const Vec end2 = hn::Add(hn::Mul(to_end, to_end), y2);
  const Vec begin2 = hn::Add(hn::Mul(to_begin, to_begin), y2);
  const Mask by_origin =
      hn::Or(hn::Lt(over_origin, zero), hn::Lt(hn::Mul(over_origin, over_origin), end2));
  const Mask by_head =
      hn::Or(hn::Lt(over_head, zero), hn::Lt(hn::Mul(over_head, over_head), begin2));
  return hn::Or(by_origin, by_head);
}

template <Carried carried>
void gather(const Segment& segment, const EndpointBounds& bounds, Batch& batch) {
  batch.reserve(batch.count + segment.count);
  constexpr unsigned kFields = fields_with(carried);
  const double* from[kFields];
  double* to[kFields];
  for (unsigned f = 0; f < kFields; ++f) {
    from[f] = segment.array(f);
    to[f] = batch.array(f);
  }
  std::size_t out = batch.count;
  for (std::size_t i = 0; i < segment.count; i += kLanes) {
    const Windows w{hn::Load(kTag, from[kBegin] + i), hn::Load(kTag, from[kEnd] + i),
                    hn::Load(kTag, from[kX] + i), hn::Load(kTag, from[kY] + i),
                    hn::Load(kTag, from[kSigma] + i)};
    const Mask keep = hn::AndNot(beaten(w, bounds), hn::FirstN(kTag, segment.count - i));
    const Packer pack(bits(keep));
    pack.store(w.begin, to[kBegin] + out);
    pack.store(w.end, to[kEnd] + out);
    pack.store(w.x, to[kX] + out);
    pack.store(w.y, to[kY] + out);
    pack.store(w.sigma, to[kSigma] + out);
    for (unsigned f = kRoot; f < kFields; ++f) {
      pack.store(hn::Load(kTag, from[f] + i), to[f] + out);
    }
    out += pack.count();
  }
  batch.count = out;
}

/// The neighbours among windows `base` to `last`, at most kTrimmedAtOnce after it, that are
/// out_of_order: bit i for windows base + i and base + i + 1.
HWY_INLINE std::uint64_t find_suspects(const Batch& batch, std::size_t base, std::size_t last) {
  const double *begins = batch.array(kBegin), *ends = batch.array(kEnd);
  std::uint64_t suspects = 0;
  for (std::size_t i = base; i < last; i += kLanes) {
    const Vec begin1 = hn::LoadU(kTag, begins + i), begin2 = hn::LoadU(kTag, begins + i + 1);
    const Vec end1 = hn::LoadU(kTag, ends + i), end2 = hn::LoadU(kTag, ends + i + 1);
    const Vec narrower = hn::Min(hn::Sub(end1, begin1), hn::Sub(end2, begin2));
    const Vec protrusion = hn::Max(hn::Sub(begin1, begin2), hn::Sub(end1, end2));
    const Mask suspect =
        hn::Or(hn::Le(end2, begin1), hn::Gt(protrusion, hn::Mul(all(kLeastProtrusion), narrower)));
    suspects |= std::uint64_t{bits(hn::And(suspect, hn::FirstN(kTag, last - i)))} << (i - base);
  }
  return suspects;
}

inline void trim(Batch& batch, const EdgeBelow& edge) {
  for (std::size_t base = 0, last; base + 1 < batch.count; base = last) {
    last = std::min(base + kTrimmedAtOnce, batch.count - 1);
    for (std::uint64_t suspects = find_suspects(batch, base, last); suspects != 0;) {
      const std::uint64_t lowest = suspects & (~suspects + 1);
      suspects ^= lowest;
      const std::size_t i = base + static_cast<std::size_t>(std::countr_zero(lowest)) + 1;
      // Compiled here, because scalar code of AVX2 has fewer moves.
      const bool has_changed = plain::trim_against_earlier(batch, i, edge);
      if (has_changed && i < last) suspects |= lowest << 1;
    }
  }
}

HWY_INLINE bool find_contested(Batch& batch, const ApexWinner& winner) {
  const Vec position = all(winner.position);
  unsigned any = 0;
  for (std::size_t i = 0; i < batch.count; i += kLanes) {
    const unsigned l = marks_at(batch.passes_left, i), r = marks_at(batch.passes_right, i);
    const unsigned beyond = bits(hn::Ge(hn::LoadU(kTag, batch.array(kBegin) + i), position));
    const unsigned before = bits(hn::Le(hn::LoadU(kTag, batch.array(kEnd) + i), position));
    unsigned group = (l & (r | beyond)) | (r & before);
    if (winner.window - i < kLanes) group &= ~(1u << (winner.window - i));
    batch.contested.groups()[i / kLanes] = static_cast<std::uint8_t>(group);
    any |= group;
  }
  return any != 0;
}

/// The left one of the two edges onto which a face unfolds windows.
struct LeftEdge {
  /// FaceFrame::on_left; the apex where `at_apex`.
  static Vec along(const FaceFrame& f, Vec x, Vec y, Vec t, Mask at_apex) {
    const Vec depth = hn::Neg(y);
    const Vec denominator =
        hn::Sub(hn::Mul(depth, all(f.left_x)), hn::Mul(hn::Sub(t, x), all(f.left_y)));
    const Vec u = hn::Div(hn::Mul(depth, t), denominator);
    const Vec within = hn::Min(hn::Max(u, hn::Zero(kTag)), all(f.left));
    return hn::IfThenElse(hn::AndNot(at_apex, hn::Gt(denominator, hn::Zero(kTag))), within,
                          all(f.left));
  }
  static double length(const FaceFrame& f) { return f.left; }
  static Vec begin(const FaceFrame& f, const Windows& w, Mask /*other*/) {
    return along(f, w.x, w.y, w.begin, hn::FirstN(kTag, 0));
  }
  static Vec end(const FaceFrame& f, const Windows& w, Mask other) {
    return along(f, w.x, w.y, w.end, other);
  }
  static Vec source_x(const FaceFrame& f, const Windows& w) {
    return hn::Add(hn::Mul(w.x, all(f.left_x)), hn::Mul(w.y, all(f.left_y)));
  }
  static Vec source_y(const FaceFrame& f, const Windows& w) {
    return hn::Sub(hn::Mul(w.y, all(f.left_x)), hn::Mul(w.x, all(f.left_y)));
  }
};

struct RightEdge {
  /// FaceFrame::on_right; the apex where `at_apex`.
  static Vec along(const FaceFrame& f, Vec x, Vec y, Vec t, Mask at_apex) {
    const Vec depth = hn::Neg(y);
    const Vec denominator =
        hn::Sub(hn::Mul(depth, all(f.right_x)), hn::Mul(hn::Sub(t, x), all(f.right_y)));
    const Vec u = hn::Div(hn::Mul(depth, hn::Sub(all(f.length), t)), denominator);
    const Vec within = hn::Min(hn::Max(hn::Sub(all(f.right), u), hn::Zero(kTag)), all(f.right));
    return hn::IfThenElse(hn::AndNot(at_apex, hn::Gt(denominator, hn::Zero(kTag))), within,
                          hn::Zero(kTag));
  }
  static double length(const FaceFrame& f) { return f.right; }
  static Vec begin(const FaceFrame& f, const Windows& w, Mask other) {
    return along(f, w.x, w.y, w.begin, other);
  }
  static Vec end(const FaceFrame& f, const Windows& w, Mask /*other*/) {
    return along(f, w.x, w.y, w.end, hn::FirstN(kTag, 0));
  }
  static Vec source_x(const FaceFrame& f, const Windows& w) {
    return hn::Add(hn::Mul(hn::Sub(w.x, all(f.apex_x)), all(f.right_x)),
                   hn::Mul(hn::Sub(w.y, all(f.apex_y)), all(f.right_y)));
  }
  static Vec source_y(const FaceFrame& f, const Windows& w) {
    return hn::Sub(hn::Mul(hn::Sub(w.y, all(f.apex_y)), all(f.right_x)),
                   hn::Mul(hn::Sub(w.x, all(f.apex_x)), all(f.right_y)));
  }
};

/// Appends what a vector of windows sends to one edge of a face to the arrays `to` of a segment.
/// @param i the first of the windows in the batch
/// @param wanted those that go to this edge
/// @param sees_other those that pass the apex on the other side
/// @param count of windows in the segment
/// @return the new count
template <class Edge, unsigned kFields>
HWY_INLINE std::size_t unfold_onto(const FaceFrame& face, const Batch& batch, std::size_t i,
                                   const Windows& w, Mask wanted, Mask sees_other,
                                   double* const (&to)[kFields], std::size_t count) {
  const Vec begin = Edge::begin(face, w, sees_other), end = Edge::end(face, w, sees_other);
  const Mask wide = hn::Gt(hn::Sub(end, begin), all(kWindowWidth * Edge::length(face)));
  const Vec x = Edge::source_x(face, w), y = hn::Min(Edge::source_y(face, w), hn::Zero(kTag));
  const Packer pack(bits(hn::And(wanted, wide)));
  pack.store(begin, to[kBegin] + count);
  pack.store(end, to[kEnd] + count);
  pack.store(x, to[kX] + count);
  pack.store(y, to[kY] + count);
  pack.store(w.sigma, to[kSigma] + count);
  for (unsigned f = kRoot; f < kFields; ++f) {
    const Vec value = hn::LoadU(kTag, batch.array(f) + i);
    pack.store(f == kDepth ? hn::Add(value, all(1)) : value, to[f] + count);
  }
  return count + pack.count();
}

template <Carried carried>
void unfold_marked(const Batch& batch, const FaceFrame& face, const Marks& to_left,
                   const Marks& to_right, Segment& left, Segment& right) {
  constexpr unsigned kFields = fields_with(carried);
  double *left_arrays[kFields], *right_arrays[kFields];
  for (unsigned f = 0; f < kFields; ++f) {
    left_arrays[f] = left.array(f);
    right_arrays[f] = right.array(f);
  }
  std::size_t left_count = 0, right_count = 0;
  for (std::size_t i = 0; i < batch.count; i += kLanes) {
    const Windows w = windows_at(batch, i);
    const unsigned wanted_left = marks_at(to_left, i), wanted_right = marks_at(to_right, i);
    const Mask passes_left = mask_of(marks_at(batch.passes_left, i));
    const Mask passes_right = mask_of(marks_at(batch.passes_right, i));
    if (wanted_left != 0) {
      left_count = unfold_onto<LeftEdge>(face, batch, i, w, mask_of(wanted_left), passes_right,
                                         left_arrays, left_count);
    }
    if (wanted_right != 0) {
      right_count = unfold_onto<RightEdge>(face, batch, i, w, mask_of(wanted_right), passes_left,
                                           right_arrays, right_count);
    }
  }
  left.count = static_cast<std::uint32_t>(left_count);
  right.count = static_cast<std::uint32_t>(right_count);
}

/// Puts the distances to the apex of windows that miss it, over the ends of their intervals, in
/// place of those of lines.
/// @param misses those windows among windows i to i + kLanes - 1
[[gnu::cold, gnu::noinline]] inline void bend(const Batch& batch, const FaceFrame& face,
                                              std::size_t i, unsigned misses, double* distance) {
  for (; misses != 0; misses &= misses - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(misses));
    const Sides seen{batch.passes_left[i + lane], batch.passes_right[i + lane]};
    distance[lane] = distance_to_apex(batch.window(i + lane), seen, face);
  }
}

template <Carried carried>
ApexWinner unfold(Batch& batch, const FaceFrame& face, Segment& left, Segment& right) {
  constexpr unsigned kFields = fields_with(carried);
  double *left_arrays[kFields], *right_arrays[kFields];
  for (unsigned f = 0; f < kFields; ++f) {
    left_arrays[f] = left.array(f);
    right_arrays[f] = right.array(f);
  }
  std::size_t left_count = 0, right_count = 0;
  std::uint8_t* left_groups = batch.passes_left.groups();
  std::uint8_t* right_groups = batch.passes_right.groups();
  const Vec apex_x = all(face.apex_x), apex_y = all(face.apex_y);
  const Vec reach = all(kApexReach);
  ApexWinner best;
  HWY_ALIGN double distance[kLanes];
  const std::size_t count = batch.count;
  for (std::size_t i = 0; i < count; i += kLanes) {
    const Windows w = windows_at(batch, i);
    // WindowSight, lane by lane. A window that misses the apex does so at one end of its interval.
    const Vec across = hn::Sub(apex_x, w.x), up = hn::Sub(apex_y, w.y), down = hn::Neg(w.y);
    const Vec begin = hn::Sub(w.begin, w.x), end = hn::Sub(w.end, w.x);
    const Vec leaning = hn::Mul(across, down);
    const Vec at_begin = hn::Mul(begin, up), at_end = hn::Mul(end, up);
    const Mask inside = hn::FirstN(kTag, count - i);
    const Mask to_left = hn::And(hn::Gt(leaning, at_begin), inside);
    const Mask to_right = hn::And(hn::Lt(leaning, at_end), inside);
    const unsigned passes_left = bits(to_left), passes_right = bits(to_right);
    const Vec squared = hn::Add(hn::Mul(across, across), hn::Mul(up, up));
    const Vec by = hn::Sub(leaning, hn::IfThenElse(to_left, at_end, at_begin));
    const Mask is_at = hn::Le(hn::Abs(by), hn::Mul(reach, squared));
    left_groups[i / kLanes] = static_cast<std::uint8_t>(passes_left);
    right_groups[i / kLanes] = static_cast<std::uint8_t>(passes_right);
    if (passes_left != 0) {
      left_count =
          unfold_onto<LeftEdge>(face, batch, i, w, to_left, to_right, left_arrays, left_count);
    }
    if (passes_right != 0) {
      right_count =
          unfold_onto<RightEdge>(face, batch, i, w, to_right, to_left, right_arrays, right_count);
    }
    const unsigned sees = passes_left & passes_right;
    const unsigned misses = (passes_left ^ passes_right) & bits(is_at);
    unsigned reaching = sees | misses;
    if (reaching == 0) continue;
    hn::Store(hn::Add(w.sigma, hn::Sqrt(squared)), kTag, distance);
    if (misses != 0) [[unlikely]] {
      bend(batch, face, i, misses, distance);
    }
    for (; reaching != 0; reaching &= reaching - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(reaching));
      const bool is_less = distance[lane] < best.distance;
      best.window = is_less ? i + lane : best.window;
      best.distance = is_less ? distance[lane] : best.distance;
    }
  }
  left.count = static_cast<std::uint32_t>(left_count);
  right.count = static_cast<std::uint32_t>(right_count);
  if (best.window == SIZE_MAX) return best;
  best.position = apex_line_in(batch.window(best.window), face);
  best.is_contested = find_contested(batch, best);
  return best;
}

template <Carried carried>
inline constexpr Kernels kKernels = {kLanes, gather<carried>, trim, unfold<carried>,
                                     unfold_marked<carried>};

}  // namespace geodesic::edge_based::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#endif
