// The steps of a crossing over whole lists: window by window (plain_kernels.h), and by the vector
// instructions of several sets (kernels-inl.h).
#pragma once

#include "solvers/core/instruction_set.h"
#include "solvers/edge_based/batch.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// Neighbours of a list that trimming compares before it trims any of them: a mask of 64 bits.
inline constexpr std::size_t kTrimmedAtOnce = 64;

/// The kernels of one instruction set. All sets give the same bits.
struct Kernels {
  /// Number of lanes of a vector; 1 without vectors.
  std::size_t lanes;

  /// Appends the windows of a segment that EndpointBounds::beat does not reject.
  void (*gather)(const Segment& segment, const EndpointBounds& bounds, Batch& batch);

  /// Strategy I over the whole list: applies trim_pair to the neighbours that are
  /// `out_of_order`, and strikes out windows that are beaten wholly.
  void (*trim)(Batch& batch, const EdgeBelow& edge);

  /// Marks the sides on which the lines of each window pass the apex, and unfolds the windows onto
  /// the left and right edges. A window that passes the apex on both sides reaches up to it.
  /// @param left, right empty segments with room for all windows, in whole vectors
  /// @return the window that gives the least distance to the apex
  ApexWinner (*unfold)(Batch& batch, const FaceFrame& face, Segment& left, Segment& right);

  /// Does so again, with only the windows marked in `to_left` and `to_right`: subsets of those
  /// that `unfold` has marked.
  void (*unfold_marked)(const Batch& batch, const FaceFrame& face, const Marks& to_left,
                        const Marks& to_right, Segment& left, Segment& right);
};

/// The widest instruction set up to `wanted` that the kernels are compiled for.
InstructionSet compiled_for(InstructionSet wanted);

/// @param set a result of compiled_for
/// @param carried data of the windows of all batches and segments
const Kernels& kernels_of(InstructionSet set, Carried carried);

}  // namespace geodesic::edge_based
