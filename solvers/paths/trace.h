// One path of a solve, from its end back to its source.
#pragma once

#include <span>
#include <string>

#include "solvers/core/path.h"
#include "solvers/core/recording.h"
#include "solvers/paths/search.h"

namespace geodesic {

/// Traces a path over the faces.
///
/// A straight piece is followed with its root unfolded: where the line enters a face, the direction
/// to the root selects the side by which it leaves, and the root is unfolded into the next face.
/// Errors do not accumulate, since every face aims at the root again. A face that contains the root
/// ends the piece, since nothing is shorter than a straight line in space.
///
/// A line is followed until it meets a vertex where paths may bend, a boundary or an edge of
/// several faces, where it may be wrong. Such pieces are searched (search.h).
///
/// The result is as long as the distance of its end, or shorter if paths are not shortest ones. If
/// lines failed, over needles and faces without area, every piece is searched.
/// @param last_segments by vertex
/// @param end, distance, last_segment of the path; the last piece to a point of a face without a
///        segment is searched
/// @param last that piece, if it is known
/// @throws std::runtime_error if the last segments do not describe a path of this mesh
Path trace_path(const DistanceField& field, std::span<const LastSegment> last_segments,
                const InternalPoint& end, double distance, const LastSegment& last_segment,
                const PathSearch::Piece* last = nullptr);

/// What messages call a point.
std::string name_of(const Mesh& mesh, const InternalPoint& own);

}  // namespace geodesic
