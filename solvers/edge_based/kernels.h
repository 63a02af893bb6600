// The steps of a crossing over whole lists, compiled for several instruction sets (kernels-inl.h).
#pragma once

#include "solvers/core/instruction_set.h"
#include "solvers/edge_based/batch.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// The kernels of one instruction set. All sets give the same bits as the scalar functions named
/// here.
struct Kernels {
  /// Number of lanes of a vector.
  std::size_t lanes;

  /// Appends the windows of a segment that EndpointBounds::beat does not reject.
  void (*gather)(const Segment& segment, const EndpointBounds& bounds, Batch& batch);

  /// Strategy I over the whole list: applies trim_pair to the neighbours that are
  /// `out_of_order`, and strikes out windows that are beaten wholly.
  void (*trim)(Batch& batch, const EdgeBelow& edge);

  /// Marks the sides on which the lines of each window pass the apex.
  /// @return the window that gives the least distance to the apex
  ApexWinner (*classify)(Batch& batch, const FaceFrame& face);

  /// Unfolds the windows marked in `to_edge` onto the left or right edge. A window that passes the
  /// apex on both sides reaches up to it.
  /// @param out an empty segment with room for the marked windows and lanes - 1 more
  void (*unfold_left)(const Batch& batch, const FaceFrame& face, const Marks& to_edge,
                      Segment& out);
  void (*unfold_right)(const Batch& batch, const FaceFrame& face, const Marks& to_edge,
                       Segment& out);
};

/// The instruction set nearest to `wanted` that the kernels are compiled for.
InstructionSet compiled_for(InstructionSet wanted);

/// @param set a result of compiled_for
/// @param carried data of the windows of all batches and segments
const Kernels& kernels_of(InstructionSet set, Carried carried);

}  // namespace geodesic::edge_based
