// Every tolerance of the solvers, with what it is relative to. None depends on the unit of length.
#pragma once

namespace geodesic {

/// A total vertex angle counts as above 2 pi from this excess on, in radians. Rounding in the sum
/// of the angles of a flat vertex stays near 1e-15; a saddle of a smaller excess bends a path by
/// less than this angle, which changes a length by its square.
inline constexpr double kSaddleAngleExcess = 1e-12;

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

/// A face lower than this times one of its sides has no reliable angles: whether a path may bend at
/// its corners is not known, and every one of them sends out windows.
inline constexpr double kFlatFace = 1e-9;

/// A window narrower than this times the length of its edge is dropped.
inline constexpr double kWindowWidth = 1e-14;

/// A path must be shorter than its rival by this, relative to its length, before the rival's window
/// is discarded: equal paths (symmetric meshes, a window's own generating vertex) keep both.
inline constexpr double kPathMargin = 1e-14;

/// MMP forgets the windows of an edge that the wavefront has passed by this, relative to distances:
/// far above what rounding does to them, far below a step of the wavefront.
inline constexpr double kPassedMargin = 1e-6;

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

}  // namespace geodesic
