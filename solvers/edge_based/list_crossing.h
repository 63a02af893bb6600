// The crossing of the exact solver: takes the whole list of windows of an edge, in order along the
// edge, trimmed by Strategy I (trim.h) and divided by Strategy II (split.h), across a face.
#pragma once

#include <algorithm>
#include <span>

#include "solvers/core/recorders.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/batch.h"
#include "solvers/edge_based/kernels.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"
#include "solvers/edge_based/window_lists.h"

namespace geodesic::edge_based {

/// The fields that windows on a mesh need in addition (core/window_bound.h).
inline Carried carried_on(const Mesh& mesh) {
  return mesh.has_thin_faces() ? Carried::depth : Carried::nothing;
}

/// Implements a Crossing (wavefront.h).
class ListCrossing {
 public:
  ListCrossing(const Mesh& mesh, InstructionSet set, Carried carried)
      : ListCrossing(mesh, set, carried, coordinate_rounding(mesh), WindowBudget(mesh)) {}
  /// @param rounding, budget of the larger mesh of which this one is a part
  ListCrossing(const Mesh& mesh, InstructionSet set, Carried carried, double rounding,
               const WindowBudget& budget)
      : mesh_(mesh),
        kernels_(kernels_of(set, carried)),
        carried_(carried),
        lists_(mesh.half_edge_count(), fields_with(carried), kernels_.lanes),
        budget_(budget),
        rounding_(rounding),
        batch_(fields_with(carried), kernels_.lanes),
        kept_left_(kernels_.lanes),
        kept_right_(kernels_.lanes) {}

  void start(std::span<const double> distances) {
    distances_ = distances;
    lists_.clear();
    budget_.start();
  }
  void follow_edge(Index /*from*/, Index /*to*/) {}
  void finish() {}
  double rounding() const { return rounding_; }
  std::uint64_t window_count() const { return lists_.window_count(); }
  /// The waiting windows. Callers may remove or add some.
  WindowLists& lists() { return lists_; }
  const WindowBudget& budget() const { return budget_; }

  template <class Visit>
  void for_each_window(Index h, const Visit& visit) const {
    lists_.for_each_segment(h, [&](const Segment& segment) {
      for (std::size_t i = 0; i < segment.count; ++i) visit(window_of(segment, i));
    });
  }

  template <class Wavefront>
  void emit(Index side, const Point2& from, double distance, Index root, Wavefront& wavefront) {
    const HalfEdge& e = mesh_.half_edge(side);
    if (e.twin == kNone || !(e.length > 0)) return;
    Segment* segment = lists_.allocate(1);
    segment->add({0, e.length, from.x, from.y, distance});
    if (carried_ != Carried::nothing) segment->array(kRoot)[0] = root;
    if (carried_ == Carried::depth) segment->array(kDepth)[0] = 1;
    land(side, segment, Place::back, wavefront);
  }

  template <class Wavefront>
  void emit_from_apex(bool wanted, Index side, Wavefront& wavefront) {
    if (!wanted) return;
    const Index v = mesh_.apex(side);
    emit(side, apex_from_beyond(mesh_.half_edge(side)), distances_[v], v, wavefront);
  }

  template <class Wavefront>
  void cross(Index h, Wavefront& wavefront) {
    auto& recorder = wavefront.recorder();
    gather_and_trim(h, recorder);
    if (batch_.count == 0) return;
    budget_.spend(batch_.count);
    hand_over(h, recorder);

    const FaceFrame face = face_frame(mesh_, h);
    Segment* left = lists_.allocate(batch_.count);
    Segment* right = lists_.allocate(batch_.count);
    const ApexWinner winner = kernels_.unfold(batch_, face, *left, *right);
    if (winner.window != SIZE_MAX) {
      wavefront.improve(mesh_.apex(h), winner.distance, [&] { return last_segment(h, winner); });
    }
    if (winner.is_contested && !mesh_.crosses_non_manifold_edges()) {
      choose_sides(winner, face, recorder);
      kernels_.unfold_marked(batch_, face, kept_left_, kept_right_, *left, *right);
      count(kept_left_, kept_right_, recorder);
    } else {
      count(batch_.passes_left, batch_.passes_right, recorder);
    }
    land(Mesh::previous(h), left, Place::front, wavefront);
    land(Mesh::next(h), right, Place::back, wavefront);
  }

 private:
  /// Moves the list of h into the batch, without windows or parts that paths over the ends of h or
  /// other windows of the list beat.
  template <class Recorder>
  void gather_and_trim(Index h, Recorder& recorder) {
    const auto timed = recorder.enter(Phase::trimming);
    const HalfEdge& edge = mesh_.half_edge(h);
    const EndpointBounds bounds(edge.length, distances_[edge.origin], distances_[mesh_.head(h)]);
    batch_.count = 0;
    lists_.consume(h, [&](const Segment& segment) {
      recorder.created(segment.count);
      kernels_.gather(segment, bounds, batch_);
    });
    const EdgeBelow below = edge_below(mesh_, h, rounding_);
    if (mesh_.crosses_non_manifold_edges()) [[unlikely]] {
      trim_sheets(below);
    } else {
      kernels_.trim(batch_, below);
    }
    if (carried_ == Carried::depth) drop_long_strips();
  }

  /// Strategy I if windows of one edge may have come through different sheets. Lines that cross
  /// when unfolded need not cross on the surface then, so only points of the edge decide.
  [[gnu::cold, gnu::noinline]] void trim_sheets(const EdgeBelow& edge) {
    for (std::size_t i = 1; i < batch_.count; ++i) {
      for (std::size_t before = 0; before < i && !batch_.is_struck_out(i); ++before) {
        if (batch_.is_struck_out(before)) continue;
        Window first = batch_.window(before), second = batch_.window(i);
        trim_overlap(first, second, edge);
        batch_.put_back(before, first, edge.length);
        batch_.put_back(i, second, edge.length);
      }
    }
  }

  [[gnu::noinline]] void drop_long_strips() {
    for (std::size_t i = 0; i < batch_.count; ++i) {
      if (is_strip_too_long(budget_.face_count(), depth_of(i))) batch_.strike_out(i);
    }
  }

  /// Strategy II: marks in kept_left_ and kept_right_ to which edges each window goes. Not if
  /// windows may have come through different sheets: all go where their lines lead then.
  template <class Recorder>
  void choose_sides(const ApexWinner& winner, const FaceFrame& face, Recorder& recorder) {
    const auto timed = recorder.enter(Phase::trimming);
    kept_left_.copy(batch_.passes_left, batch_.count);
    kept_right_.copy(batch_.passes_right, batch_.count);
    const Window best = batch_.window(winner.window);
    const std::size_t count = batch_.count;
    for (std::size_t i = batch_.contested.next(0, count); i < count;
         i = batch_.contested.next(i + 1, count)) {
      const Sides seen{batch_.passes_left[i], batch_.passes_right[i]};
      const Sides kept = sides_kept(batch_.window(i), seen, winner, best, face, rounding_);
      if (!kept.left) kept_left_.clear(i);
      if (!kept.right) kept_right_.clear(i);
    }
  }

  /// @param segment windows that leave a face through `side`; released if it is empty, or if there
  /// is no face beyond
  template <class Wavefront>
  void land(Index side, Segment* segment, Place place, Wavefront& wavefront) {
    if (segment->count == 0 || mesh_.twin(side) == kNone) return lists_.release(segment);
    if (mesh_.crosses_non_manifold_edges()) [[unlikely]] {
      land_on_other_sheets(side, *segment, place, wavefront);
    }
    lists_.add(mesh_.twin(side), segment, place);
    wavefront.land(mesh_.twin(side));
  }

  /// Copies windows that leave a face where several others meet it into each of the others.
  template <class Wavefront>
  [[gnu::cold, gnu::noinline]] void land_on_other_sheets(Index side, const Segment& segment,
                                                         Place place, Wavefront& wavefront) {
    mesh_.for_each_sheet(side, [&](Index g) {
      if (g == side) return;
      lists_.add(mesh_.twin(g), lists_.copy(segment), place);
      wavefront.land(mesh_.twin(g));
    });
  }

  Index root_of(std::size_t i) const { return static_cast<Index>(batch_.array(kRoot)[i]); }

  /// Faces in the strip of a window of the batch, including the one that it enters.
  std::uint32_t depth_of(std::size_t i) const {
    return static_cast<std::uint32_t>(batch_.array(kDepth)[i]) + 1;
  }

  /// Last segment of the winner's line to the apex of h.
  LastSegment last_segment(Index h, const ApexWinner& winner) const {
    const Window best = batch_.window(winner.window);
    return {h, root_of(winner.window), {best.x, best.y}};
  }

  template <class Recorder>
  void hand_over(Index h, Recorder& recorder) const {
    recorder.crosses(h, [&](const auto& crosses) {
      for (std::size_t i = 0; i < batch_.count; ++i) {
        if (!batch_.is_struck_out(i)) crosses(batch_.window(i), root_of(i));
      }
    });
  }

  template <class Recorder>
  void count(const Marks& to_left, const Marks& to_right, Recorder& recorder) const {
    if constexpr (!Recorder::kRecords) return;
    for (std::size_t i = 0; i < batch_.count; ++i) {
      if (batch_.is_struck_out(i)) continue;
      recorder.propagated(1, StripDepth{depth_of(i)});
      if (to_left[i] || to_right[i]) recorder.valid(1);
    }
  }

  const Mesh& mesh_;
  const Kernels& kernels_;
  Carried carried_;
  std::span<const double> distances_;
  WindowLists lists_;
  WindowBudget budget_;
  double rounding_;  // of coordinates
  // Scratch memory for one list.
  Batch batch_;
  Marks kept_left_, kept_right_;
};

}  // namespace geodesic::edge_based
