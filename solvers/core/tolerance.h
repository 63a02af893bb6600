// All tolerances of the solvers, and what each is relative to. None depends on the unit of length.
#pragma once

#include <limits>

namespace geodesic {

/// A total vertex angle counts as above 2 pi, or at a boundary above pi, if it exceeds that by
/// this, in radians. Rounding in the sum of the angles of a flat vertex stays near 1e-15. A smaller
/// excess bends a path by less than this angle, which changes a length by its square.
inline constexpr double kSaddleAngleExcess = 1e-12;

/// A total vertex angle this near to a multiple of pi, in radians, is computed from arc tangents.
/// Elsewhere a vector is turned once per face; the rounding of all turns stays below this.
inline constexpr double kNearTurn = 1e-9;

/// The weights of a point in a face have the sum 1 up to this: a few units in the last place.
inline constexpr double kWeightSum = 1e-15;

/// A source is next to a corner of its face when it is nearer than this times two sides of the
/// face. In a face of extent 1, rounding of the coordinates of a source r from the corner turns its
/// lines by 1e-16 / r. At a distance D the lines on both sides of the corner leave a gap of up to
/// 1e-14 D, far less than kApexReach.
inline constexpr double kNextToCorner = 1e-2;

/// Lines that pass an apex on both sides of it less than this apart, relative to the lengths at
/// hand, have no sides.
inline constexpr double kApexTolerance = 1e-10;

/// A window reaches the apex of a face, over the end of its interval, if that end lies off the line
/// from its source to the apex by less than this, relative to the line's length. The path that
/// bends there is a real one, so no value makes a distance too short. It must cover the gaps
/// between windows that rounding opens: paths whose directions differ by an angle t differ in
/// length by about t^2 / 2, so below t = 1e-8 it is chance which of two windows is dropped.
inline constexpr double kApexReach = 1e-6;

/// A pseudo-source in the interior of an edge (the apex of a zero-area face) is moved off the edge
/// by this times the edge's length, to its own side. Unfolding across the next face then has a
/// direction, whether or not that face has an area. No distance changes: the square of the shift is
/// zero, in units in which a mesh is of ordinary extent (mesh_input.h).
inline constexpr double kTouchingHeight = 1e-200;

/// Least height of an apex above a window's source. Where both lie on the edge's line, the line
/// between them has no single crossing with the edge. With this height it crosses at the source. If
/// the source lies inside the interval, it sees the apex along the edge; otherwise its lines pass
/// the apex on the interval's side.
inline constexpr double kLeastHeight = std::numeric_limits<double>::min();

/// A face lower than this times one of its sides has no reliable angles. It is not known whether a
/// path may bend at its corners, so all of them send out windows.
inline constexpr double kFlatFace = 1e-9;

/// A face lower than this times one of its sides is thin: straight lines may wind around a vertex,
/// or a tube, of such faces more often than rounding allows to tell their lengths apart.
inline constexpr double kThinFace = 1.0 / 256;

/// A window narrower than this times the length of its edge is dropped.
inline constexpr double kWindowWidth = 1e-14;

/// A window is discarded only if a rival path is shorter than its own by more than this, relative
/// to its length. Equal paths (symmetric meshes, a window's own generating vertex) are both kept.
inline constexpr double kPathMargin = 1e-14;

/// The same margin for a distance far shorter than the edges whose frames its window has come
/// through, relative to the longest edge: see coordinate_rounding (window_predicates.h). 13 units
/// in the last place, and less than the accuracy of such distances, 1e-12 of a 256th of that edge.
inline constexpr double kCoordinateRounding = 3e-15;

/// A source is next to an edge when it is nearer than this times the rounding of coordinates. That
/// rounding then turns its lines by more than 3e-10.
inline constexpr double kNextToEdge = 3e9;

/// A shadow (chen_han/shadow.h) begins earlier by this angle, in radians. Paths whose lengths are
/// equal up to rounding differ in direction by less (see kApexReach).
inline constexpr double kShadowMargin = 1e-6;

/// Shift of a source by rounding, relative to its distance, after 9,000 faces at 2^-53 each:
/// distances are accurate to 1e-12 up to this number of faces.
inline constexpr double kSourceRounding = 1e-12;

/// A source lies on a line that bounds another window's pencil when it is off by less than this,
/// relative to the lengths whose products are compared. This is frequent: the vertex that split the
/// pencil became a source itself.
inline constexpr double kOnLine = 1e-11;

/// Two lines that bound windows count as crossing in the third vertex of the face below when they
/// cross within this share of its height.
inline constexpr double kNearVertex = 1e-9;

/// The source of a merged window (edge_based/merge.h) lies off the edge by at least this, relative
/// to the edge's length: windows of a source on a vertex would wind round it without end.
inline constexpr double kLeastAway = 1e-6;

/// With a smaller tolerance windows are not merged: it does not pay, and comes near to rounding.
inline constexpr double kLeastMerging = 1e-9;

/// The shortfall of a merged window is stored in 32 bits, rounded up by less than this, relatively.
inline constexpr double kShortfallRounding = 1e-6;

/// MMP discards the windows of an edge once the wavefront has passed it by this, relative to
/// distances: far above their rounding, far below a step of the wavefront.
inline constexpr double kPassedMargin = 1e-6;

/// A line from a virtual source (virtual_source/) may miss the edge that it crosses by this,
/// relative to the edge's length. Sources are approximate, and lines that pass a vertex would be
/// lost on both sides of it: with less, distances are too long on rough surfaces (by 0.8% at 0.2,
/// by 0.3% at 0.5), with more they are too short on smooth ones.
inline constexpr double kSourceSlack = 0.5;

/// A distance must decrease by this, relatively, before waves propagate from it again: far less
/// than its error.
inline constexpr double kSourceGain = 1e-6;

/// As kSourceSlack, where the line leads to a vertex nearer than one end of the edge. Values
/// derived from that vertex return to it, and errors would reinforce themselves.
inline constexpr double kSourceSlackBetween = 0.1;

/// Largest relative error of a product with the reciprocal of a bucket's width.
inline constexpr double kKeyRounding = 1e-15;

/// A traced path runs through a vertex that its line misses by less than this, relative to the
/// length of the straight piece: the effect of rounding on the piece's unfolded root.
inline constexpr double kPathThrough = 1e-14;

/// The same, relative to the edge through which the piece leaves its first face. That edge may be
/// far longer than the piece: a few units in the last place of a position on it.
inline constexpr double kPathRounding = 4e-15;

/// Two paths are equally short when their lengths differ by less than this, relatively. A traced
/// path may follow either.
inline constexpr double kPathTie = 1e-13;

/// A line that misses its root, or the faces on its way, by less than this, relative to its length,
/// counts as straight. A recomputed piece may be longer than the recorded one by as much.
inline constexpr double kPathStray = 5e-13;

/// A traced path is wrong when its length differs from its end's distance by more than this,
/// relative to the distance plus a mean edge. Well above the remaining rounding.
inline constexpr double kPathWrong = 1e-9;

/// A path is searched for among points whose distances fit it up to this, relative to its length
/// plus the mean edge: the accuracy of distances. Among needles, up to kPathWrong, thousands of
/// times as many points fit.
inline constexpr double kPathSearch = 1e-12;

/// The same where distances are upper bounds of unknown accuracy: errors of neighbours differ by
/// about this. With more the search takes longer, in proportion to the square root.
inline constexpr double kPathSearchOfBounds = 1e-4;

/// A straightened curve (straighten.h) is moved over a vertex where the angle on one side is less
/// than pi by more than this, in radians: far more than the rounding of a vertex's total angle.
inline constexpr double kStraightenAngle = 1e-12;

/// The same, where a line next to the vertex is short: the vertex lies off the straight line by
/// more than this, relative to the lengths of both lines. Well above kPathThrough.
inline constexpr double kStraightenOffset = 2e-13;

/// The same, relative to the length of the curve, by whose rounding the vertex may be off.
inline constexpr double kStraightenRounding = 1e-14;

/// A closed sleeve is straight when its ends, laid out in the plane, are turned by less than this,
/// in radians: rounding over a thousand faces.
inline constexpr double kStraightSleeve = 1e-12;

/// A source was misplaced when its own solver gives it a distance above this, in edge lengths.
inline constexpr double kElsewhere = 1e-12;

/// A path of flipped edges counts as straight at an angle of pi minus this. Straightening it would
/// shorten it by the square of this, which is less than rounding. Lines of flipped edges also stay
/// clear of vertices by as much.
inline constexpr double kFlipStraight = 1e-8;

/// A traced line of such an edge ends in its vertex when it misses the vertex by less than this,
/// relative to its length: far more than rounding, far less than the distance of two vertices on
/// one line.
inline constexpr double kFlipEndReach = 1e-6;

}  // namespace geodesic
