// The last straight piece of a shortest path, found from its end.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "solvers/paths/paths.h"

namespace geodesic {

/// Finds by distances alone what an LastSegment remembers: windows are propagated from the end of a
/// path over the faces around, as Chen and Han 1990 do from a source, but only where the path can
/// run. At a point x of it, d(end) - |end - x| is the distance of x, which differs from that of a
/// vertex by no more than the straight line between them; windows where it does are dropped. What
/// is left surrounds the path by about an edge. A bound of d(end) does as well: it leaves more
/// windows.
///
/// For points of which nothing is remembered, and for the few paths whose remembered piece is not
/// what a straight line follows: it was seen past a vertex by rounding, or it runs along faces
/// without area.
class Paths::Search {
 public:
  /// Where the piece leaves a face: at the distance x from the head of the half-edge `side`.
  struct Crossing {
    Index side;
    double x;
    double step;  ///< from the crossing before, or from the end
  };

  /// A vertex in the same place as the end.
  struct End {
    Index vertex;
    Index face;    ///< shared with the one before; kNone at the end itself
    Index before;  ///< by its place among the ends
  };

  /// A piece from its root to the end.
  struct Piece {
    Index root = kNone;                    ///< as in LastSegment; kNone: there is none
    InternalPoint at = {};                 ///< the root
    Index half_edge = kNone;               ///< of the face that has the root and the last crossing
    double distance = kInfinity;           ///< of the end, by this piece
    double before = kInfinity;             ///< of the root
    double rest = 0;                       ///< from the last crossing to the root
    std::vector<End> ends = {};            ///< after the end, when the piece leads to the last one
    std::vector<Crossing> crossings = {};  ///< from there
  };

  /// @param distance at the end, or above it; finite
  /// @param passed vertices that the piece must not begin in
  Search(const Paths& of, const InternalPoint& end, double distance, std::span<const Index> passed);

  /// The piece by which the end is nearest. Of equally short ones, that with the farthest root.
  Piece run();

 private:
  /// The part of an edge that is seen from the end through faces, in the frame of the half-edge
  /// into the face beyond.
  struct View {
    Index in;
    Point2 eye;  ///< the end; y <= 0
    double begin, end;
    Index side;    ///< the half-edge it is left by, in the face before
    Index before;  ///< the view through which this one is seen, by its place in `views_`; or kNone
    Index first;   ///< the vertex of `ends_` that the eye is at; kNone in a face
  };

  /// What a piece begins in: a vertex or a source.
  struct Root {
    Index root = kNone;
    InternalPoint at = {};
    Point2 place = {0, 0};  ///< in the frame of `half_edge`
    Index half_edge = kNone;
    Index view = kNone;  ///< the last on the way; kNone: in a face of the end
    Index end = kNone;   ///< as View::first
    double distance = kInfinity;
    double before = kInfinity;  ///< of the root itself
  };

  void look_around();
  void start_at_vertex(Index i);
  void add_end(Index vertex, Index face, Index before);
  bool is_end(Index vertex) const;
  void start(Index h, const Point2& eye, Index under, Index end);
  void look_beyond(Index view);
  /// Adds what is seen of a side.
  void see(Index side, const Point2& eye, double begin, double end, Index before, Index first);
  bool may_lead(const View& view) const;
  bool is_seen(const View& view) const;
  /// Whether a point of the face beyond is seen through a view.
  bool shows(const View& view, const Point2& place) const;
  void consider_vertex(Index v, const Point2& place, const Point2& eye, Root root);
  void consider_sources(const Point2& eye, Root root);
  void consider(Root root, double before, const Point2& place, const Point2& eye);
  bool is_straight(const Root& root) const;
  Piece piece_from(const Root& root) const;

  const Paths& of_;
  const Mesh& mesh_;
  InternalPoint end_;
  double distance_;
  double tie_;        ///< paths that differ by less are equally short
  double slack_ = 0;  ///< by which distances may rule a view out wrongly
  std::span<const Index> passed_;
  std::vector<End> ends_;
  std::vector<View> views_;
  std::unordered_map<Index, std::vector<Index>> views_of_;  // of a half-edge, by their places
  Root best_;
};

}  // namespace geodesic
