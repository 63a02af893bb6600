// Searches the last straight piece of a shortest path from its end.
#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "solvers/paths/distance_field.h"

namespace geodesic {

/// Finds the contents of a LastSegment from distances alone. Windows are propagated from the end of
/// a path over the faces around it, as Chen and Han 1990 do from a source, but only where the path
/// can run. A point x of the path has the distance d(end) - |end - x|. It differs from the distance
/// of a vertex by no more than the straight line between them, and windows that violate this are
/// dropped. The other windows are within about an edge of the path. An upper bound of d(end) also
/// works, with more windows.
///
/// If the distances of vertices are only upper bounds (Recording::shortest_paths), so is the
/// result, with a path of that length. The rule then drops windows only beyond kPathSearchOfBounds:
/// it keeps the search to the side from which the path comes, and the best vertex may be missed.
/// A known line to a known root is found without the rule, by straight lines in space.
///
/// Used for points without a LastSegment, and for the few pieces that are not followed straight
/// (trace.h).
class PathSearch {
 public:
  /// Point where the piece leaves a face: at the distance x from the head of the half-edge `side`.
  struct EdgePoint {
    Index side;
    double x;
    double step;  ///< distance from the previous one, or from the end
  };

  /// A vertex at the same position as the end.
  struct End {
    Index vertex;
    Index face;      ///< shared with the previous one; kNone at the end itself
    Index previous;  ///< index of the previous one among the ends
  };

  /// A piece from its root to the end.
  struct Piece {
    Index root = kNone;                       ///< as in LastSegment; kNone: no piece was found
    InternalPoint at = {};                    ///< position of the root
    Index half_edge = kNone;                  ///< in the face of the root and the last edge point
    double distance = kInfinity;              ///< distance of the end by this piece
    double root_distance = kInfinity;         ///< from the sources
    double rest = 0;                          ///< length from the last edge point to the root
    std::vector<End> ends = {};               ///< vertices that follow the end, in order
    std::vector<EdgePoint> edge_points = {};  ///< from the last of them on
  };

  /// @param distance the distance of the end or an upper bound; finite
  /// @param passed vertices that must not be the root of the piece
  PathSearch(const DistanceField& field, const InternalPoint& end, double distance,
             std::span<const Index> passed);

  /// Returns the piece of the shortest path to a point, whose distance is not known.
  /// @param end must not be a vertex
  /// @return its distance is infinite if no path within the query's limit exists
  static Piece from_face(const DistanceField& field, const InternalPoint& end);

  /// Returns the piece of the shortest path; of equally short ones, that with the farthest root.
  Piece run();

  /// Returns the shortest line from a root.
  /// @param root as in LastSegment
  /// @param length of the line that leads from it
  Piece run_towards(Index root, double length);

 private:
  /// The part of an edge that is visible from the end through faces, in the frame of the half-edge
  /// whose face lies beyond.
  struct View {
    Index in;
    Point2 eye;  ///< the end; y <= 0
    double begin, end;
    Index side;    ///< the half-edge in the previous face by which lines leave it
    Index parent;  ///< index in `views_` of the view that this one is seen through; or kNone
    Index first;   ///< index in `ends_` of the vertex at the eye; kNone in a face
  };

  /// The root of a piece: a vertex or a source.
  struct Root {
    Index root = kNone;
    InternalPoint at = {};
    Point2 place = {0, 0};  ///< in the frame of `half_edge`
    Index half_edge = kNone;
    Index view = kNone;  ///< the last view before it; kNone: in a face of the end
    Index end = kNone;   ///< as View::first
    double distance = kInfinity;
    double root_distance = kInfinity;  ///< from the sources
  };

  /// A point where a line from the root crosses the edge of a view, in the frame of its half-edge.
  struct Crossing {
    const View* view;
    Point2 aim;  ///< where the line leads
    double x = 0;
    double step = 0;  ///< distance from the crossing before it, or from the root
  };

  /// Tolerances of distances, relative to a length plus the mean edge; the second one is for what
  /// is not found with the first.
  static std::array<double, 2> accuracies(const DistanceField& field);
  void look_around(double accuracy);
  void start_at_vertex(Index i);
  void add_end(Index vertex, Index face, Index previous);
  bool is_end(Index vertex) const;
  void start_in_face(const InternalPoint& end);
  void see_from(Index side, const Point2& eye, Index end);
  void look_beyond(Index view);
  /// Adds a view of the visible part of a side.
  void see(Index side, const Point2& eye, double begin, double end, Index parent, Index first);
  bool may_lead(const View& view) const;
  bool may_lead_to_aim(const View& view, double nearest) const;
  bool is_seen(const View& view) const;
  /// Whether a point of the face beyond is visible through a view.
  bool shows(const View& view, const Point2& place) const;
  /// Whether a source lies in a face of the end, where no path is shorter than the line to it.
  bool is_beside(Index source) const;
  void consider_vertex(Index v, const Point2& place, const Point2& eye, Root root);
  void consider_sources(const Point2& eye, Root root);
  void consider(Root root, double distance, const Point2& place, const Point2& eye);
  bool is_straight(const Root& root) const;
  Piece piece_from(const Root& root) const;
  /// Lets a line that leads from the root to the end cross the edge of its crossing i.
  /// @param start the root in the frame of the first crossing
  /// @return false if the line passes beside the edge; x is at the vertex there then
  bool cross(std::span<Crossing> line, std::size_t i, const Point2& start) const;
  /// Position of a crossing in the frame of the half-edge that the line crosses after it.
  Point2 position_beyond(const Crossing& crossing, Index in) const;
  /// Aims all crossings of a line at the aim of the last one.
  void aim_at_last(std::span<Crossing> line) const;

  const DistanceField& field_;
  const Mesh& mesh_;
  InternalPoint end_;
  double distance_;
  double tie_;        ///< paths whose lengths differ by less are equally short
  double slack_ = 0;  ///< tolerance of distances: of those that rule views out, and of the result
  std::span<const Index> passed_;
  Index aim_ = kNone;  ///< the only root that is considered; kNone: all are
  Vec3 aim_position_;  ///< of that root
  double to_aim_ = 0;  ///< length of the line from it
  std::vector<End> ends_;
  std::vector<Index> faces_;  // of an end that is no vertex
  std::vector<View> views_;
  std::unordered_map<Index, std::vector<Index>> views_of_;  // indices of views, by half-edge
  Root best_;
};

}  // namespace geodesic
