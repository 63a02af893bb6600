// Every tolerance of the solvers, with what it is relative to. None depends on the unit of length.
#pragma once

#include <limits>

namespace geodesic {

/// A total vertex angle counts as above 2 pi, or at a boundary above pi, from this excess on, in
/// radians. Rounding in the sum of the angles of a flat vertex stays near 1e-15; a vertex of a
/// smaller excess bends a path by less than this angle, which changes a length by its square.
inline constexpr double kSaddleAngleExcess = 1e-12;

/// A total vertex angle this near to a multiple of pi, in radians, is computed by arcs: above what
/// rounding adds up to where a vector is turned once for each face of a vertex.
inline constexpr double kNearTurn = 1e-9;

/// The weights of a point in a face have the sum 1 up to this: a few units in the last place.
inline constexpr double kWeightSum = 1e-15;

/// A source is next to a corner of its face when it is nearer than this times two sides of the
/// face. In a face of extent 1, coordinates of a source r from the corner turn its lines by 1e-16 /
/// r. At a distance D the lines to both sides of the corner leave a gap of up to 1e-14 D, less than
/// the kApexTolerance by which lines may miss an apex as long as D is below 10^4.
inline constexpr double kNextToCorner = 1e-2;

/// A ray that misses the apex of a face by less than this, relative to the lengths at hand, passes
/// through it. Bending a path by an angle t changes its length by about t^2 / 2, so the error stays
/// below 1e-20 relative; what it buys is that a window ending exactly on a vertex reaches it.
/// Where the source or the apex is far nearer to the bend than the edge is long, the change is
/// larger: kApexExcess holds it down.
inline constexpr double kApexTolerance = 1e-10;

/// How much longer than such a ray the path may be that bends at the window's end, relative to the
/// distance: a few units in the last place.
inline constexpr double kApexExcess = 1e-15;

/// A window whose nearest line misses the apex of a face by less than this angle, in
/// radians, gives the apex the length of the path that bends at the window's end. That is a real
/// path, so no value makes a distance too short. It must cover the gaps between windows that
/// rounding opens: paths whose directions differ by an angle t differ in length by about t^2 / 2,
/// so below t = 1e-8 it is chance which of two windows is dropped.
inline constexpr double kApexReach = 1e-6;

/// A pseudo-source in the interior of an edge, the apex of a zero-area face, is taken to lie off
/// the edge by this times the edge's length, on its own side, so that unfolding across the next
/// face has a direction, whether or not that has an area. No distance changes: its square is zero,
/// in units in which a mesh is of ordinary extent (mesh_input.h).
inline constexpr double kTouchingHeight = 1e-200;

/// Of an apex above a window's source. Where both lie on the edge's line, their line crosses the
/// edge everywhere and nowhere; with this it crosses in the source, which sees the apex when it
/// lies inside the interval, along the edge, and passes it on the interval's side when it does not.
inline constexpr double kLeastHeight = std::numeric_limits<double>::min();

/// A face lower than this times one of its sides has no reliable angles: whether a path may bend at
/// its corners is not known, and every one of them sends out windows.
inline constexpr double kFlatFace = 1e-9;

/// A window narrower than this times the length of its edge is dropped.
inline constexpr double kWindowWidth = 1e-14;

/// A path must be shorter than its rival by this, relative to its length, before the rival's window
/// is discarded: equal paths (symmetric meshes, a window's own generating vertex) keep both.
inline constexpr double kPathMargin = 1e-14;

/// The same for a distance that is far shorter than the edges whose frames its window came through,
/// relative to the longest edge: see coordinate_rounding (window_predicates.h). 13 units in the
/// last place, and less than what such distances are exact to, 1e-12 of a 256th of that edge.
inline constexpr double kCoordinateRounding = 3e-15;

/// A source is next to an edge when it is nearer than this times the rounding of coordinates: then
/// these turn its lines by more than 3e-10, three times the kApexTolerance.
inline constexpr double kNextToEdge = 3e9;

/// A shadow (chen_han/shadow.h) begins earlier by this angle, in radians: above what the directions
/// of paths differ by whose lengths are equal but for rounding (see kApexReach).
inline constexpr double kShadowMargin = 1e-6;

/// How far rounding has moved a source, relative to its distance, after as many faces as distances
/// are certain to 1e-12 for: 2^-53 a face, 9,000 faces.
inline constexpr double kSourceRounding = 1e-12;

/// A source is on a line that bounds another window's pencil when it is off by less than this,
/// relative to the lengths whose products are compared. It often is: the vertex that split the
/// pencil became a source itself.
inline constexpr double kOnLine = 1e-11;

/// Two lines that bound windows cross in the third vertex of the face below when they do within
/// this share of its height.
inline constexpr double kNearVertex = 1e-9;

/// The source of a merged window (edge_based/merge.h) lies off the edge by at least this, relative
/// to the edge's length: windows of a source on a vertex would wind round it without end.
inline constexpr double kLeastAway = 1e-6;

/// A smaller tolerance of merged windows is not worth merging for, and comes near to rounding.
inline constexpr double kLeastMerging = 1e-9;

/// What merged windows lack is kept in 32 bits, rounded up by less than this, relatively.
inline constexpr double kShortfallRounding = 1e-6;

/// MMP forgets the windows of an edge that the wavefront has passed by this, relative to distances:
/// far above what rounding does to them, far below a step of the wavefront.
inline constexpr double kPassedMargin = 1e-6;

/// A line from a virtual source (virtual_source/) may miss the edge that it crosses by this,
/// relative to the edge's length. Sources are approximate, and lines that pass a vertex would be
/// lost on both sides of it: with less, distances are too long on rough surfaces (by 0.8% at 0.2,
/// by 0.3% at 0.5), with more they are too short on smooth ones.
inline constexpr double kSourceSlack = 0.5;

/// A distance must become shorter by this, relatively, for waves to follow it again: far less than
/// what it is off by.
inline constexpr double kSourceGain = 1e-6;

/// As kSourceSlack where the line leads to a vertex that is nearer than one end of the edge: what
/// was derived from it comes back, and errors would feed themselves.
inline constexpr double kSourceSlackBetween = 0.1;

/// What a product with the reciprocal of a bucket's width may be off by, relatively.
inline constexpr double kKeyRounding = 1e-15;

/// A traced path runs through a vertex that its line misses by less than this, relative to the
/// length of the straight piece: what rounding does to the piece's root on the way here.
inline constexpr double kPathThrough = 1e-14;

/// The same relative to the edge that the piece leaves its first face by, which may be far longer
/// than the piece: a few units in the last place of a position on it.
inline constexpr double kPathRounding = 4e-15;

/// Two paths are equally short when their lengths differ by less than this, relatively: a path that
/// is traced may take either.
inline constexpr double kPathTie = 1e-13;

/// A line that misses its root, or the faces on its way, by less than this, relative to its length,
/// is straight. A piece that is found anew may be longer than the remembered one by as much.
inline constexpr double kPathStray = 5e-13;

/// A traced path whose length differs from its end's distance by more than this, of the distance
/// and a mean edge, is wrong. Well above what is left of rounding.
inline constexpr double kPathWrong = 1e-9;

/// A path is searched for among points whose distances allow it up to this, relative to its length
/// and the mean edge: what distances are exact to. Among needles thousands of times as many do up
/// to kPathWrong.
inline constexpr double kPathSearch = 1e-12;

/// A source that its own solver gives a distance above this, in edge lengths, was put elsewhere.
inline constexpr double kElsewhere = 1e-12;

/// A path of flipped edges is straight at an angle of pi less this. The rest would make it shorter
/// by its square, by less than rounding; and lines of flipped edges stay clear of vertices by as
/// much.
inline constexpr double kFlipStraight = 1e-8;

/// A line of such an edge that is traced ends in its vertex when it misses it by less than this,
/// relative to its length: far more than rounding, far less than the distance of two vertices on
/// one line.
inline constexpr double kFlipEndReach = 1e-6;

}  // namespace geodesic
