// The steps of a crossing over whole lists, compiled for several instruction sets (kernels-inl.h).
#pragma once

#include "solvers/core/instruction_set.h"
#include "solvers/edge_based/batch.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// Those of one instruction set. All sets give the same bits, those of the scalar functions that
/// are named here.
struct Kernels {
  /// Of a vector.
  std::size_t lanes;

  /// Appends the windows that EndpointBounds::beat does not.
  void (*gather)(const Segment& segment, const EndpointBounds& bounds, Batch& batch);

  /// Strategy I over the whole list: applies trim_pair to the pairs that are not `in_order`. What
  /// is beaten wholly is struck out.
  void (*trim)(Batch& batch, const EdgeBelow& edge);

  /// Marks the sides of the apex that the lines of windows pass.
  /// @return the window that gives the least distance to the apex
  ApexWinner (*classify)(Batch& batch, const FaceFrame& face);

  /// Unfolds onto the left edge, or the right one, the windows that are marked in `to_edge`. One
  /// that passes the apex on both sides reaches up to it.
  /// @param out room for the marked windows and lanes - 1 more; it is empty
  void (*unfold_left)(const Batch& batch, const FaceFrame& face, const Marks& to_edge,
                      Segment& out);
  void (*unfold_right)(const Batch& batch, const FaceFrame& face, const Marks& to_edge,
                       Segment& out);
};

/// The instruction set nearest to `wanted` that the kernels are compiled for.
InstructionSet compiled_for(InstructionSet wanted);

/// @param set one that compiled_for gives
/// @param carried by the windows of all batches and segments
const Kernels& kernels_of(InstructionSet set, Carried carried);

}  // namespace geodesic::edge_based
