#include "solvers/paths/trace.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "solvers/core/tolerance.h"
#include "solvers/paths/path_points.h"

namespace geodesic {
namespace {

Point2 minus(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }

/// A vector of length 1: products with lengths of any unit stay within range.
struct Direction {
  Direction(const Point2& a, double length) : x(a.x / length), y(a.y / length) {}

  double along(const Point2& a) const { return x * a.x + y * a.y; }
  /// Component across the direction, positive to the left.
  double across(const Point2& a) const { return x * a.y - y * a.x; }

  double x, y;
};

class Trace {
 public:
  /// @param walks whether lines are followed; otherwise all pieces are searched
  Trace(const DistanceField& field, std::span<const LastSegment> last_segments,
        const PathSearch::Piece* last, bool walks)
      : field_(field),
        mesh_(field.mesh()),
        last_segments_(last_segments),
        last_piece_(last),
        walks_(walks),
        points_(mesh_) {}

  Path run(const InternalPoint& end, double distance, const LastSegment& last_segment) {
    points_.add(end, kNone, 0);
    Piece piece = piece_to(end, distance, last_segment);
    for (Index bends = 0; !begins_at_end(piece); ++bends) {
      if (bends > mesh_.vertex_count()) lost(piece);
      const Index root = follow(piece);
      if (root >= mesh_.vertex_count()) return points_.from_source(root - mesh_.vertex_count());
      piece = piece_to(InternalPoint(root), field_[root], last_segments_[root]);
    }
    const Index source = field_.source_at(piece.root);
    if (source == kNone) lost(piece);
    return points_.from_source(source);
  }

  [[noreturn]] static void lose(const Mesh& mesh, const InternalPoint& end, Index root) {
    const std::string from = root < mesh.vertex_count() ? name_of(mesh, InternalPoint(root))
                             : root == kNone            ? "nothing"
                                                        : "a source in a face";
    throw std::runtime_error("the solver remembers a path to " + name_of(mesh, end) + " from " +
                             from + " that does not exist; please report this mesh and query");
  }

 private:
  /// A straight piece. Points are in the frame of a half-edge of the face that it ends in.
  struct Piece {
    InternalPoint end;
    double distance;  ///< of the end
    Index half_edge;
    Index root;  ///< as in LastSegment
    Point2 from;
    Point2 at = {0, 0};  ///< position of the end
    double length = 0;
    double side = 0;  ///< length of the half-edge

    /// A part of the length, plus the rounding error of points of the half-edge.
    double part(double relative) const { return relative * length + kPathRounding * side; }
  };

  Piece piece_to(const InternalPoint& end, double distance, const LastSegment& last_segment) const {
    Piece piece{end, distance, last_segment.half_edge, last_segment.root, last_segment.from};
    if (begins_at_end(piece) || is_unknown(piece)) return piece;
    const std::size_t roots = mesh_.vertex_count() + field_.query().sources.size();
    if (piece.half_edge >= mesh_.half_edge_count() || piece.root >= roots ||
        (piece.root >= mesh_.vertex_count() && images_of(piece.root).empty())) {
      lost(piece);
    }
    if (end.is_vertex()) {
      const HalfEdge& e = mesh_.half_edge(piece.half_edge);
      piece.at = {e.apex_x, e.apex_y};
    } else {
      const Index face = piece.half_edge / 3;
      if (end.face != face) {
        const std::vector<InternalPoint> images = in_every_face(mesh_, end);
        const auto image = std::ranges::find(images, face, &InternalPoint::face);
        if (image == images.end()) lost(piece);
        piece.end = *image;
      }
      piece.at = in_frame(mesh_, piece.end, piece.half_edge);
    }
    piece.side = mesh_.half_edge(piece.half_edge).length;
    piece.length = norm(minus(piece.from, piece.at));
    return piece;
  }

  [[noreturn]] void lost(const Piece& piece) const { lose(mesh_, piece.end, piece.root); }

  static bool begins_at_end(const Piece& piece) {
    return piece.end.is_vertex() && piece.end.vertex == piece.root;
  }

  /// Whether the end is a point of a face without a LastSegment.
  static bool is_unknown(const Piece& piece) {
    return !piece.end.is_vertex() && piece.half_edge == kNone;
  }

  /// A root that is no vertex, in the faces that contain it.
  const std::vector<InternalPoint>& images_of(Index root) const {
    return field_.images(root - mesh_.vertex_count());
  }

  /// Adds the points of a piece after its end.
  /// @return the root of the piece, as in LastSegment
  Index follow(const Piece& piece) {
    if (!walks_ || is_unknown(piece) || !may_begin_at(piece.root)) return search(piece);
    const PathPoints::Mark before = points_.mark();
    if (walk(piece)) return piece.root;
    points_.shorten(before);
    return search(piece);
  }

  /// False for a vertex where no path bends: the path of a target may pass a corner of its face, as
  /// straight as the window beside it.
  bool may_begin_at(Index root) const {
    return root >= mesh_.vertex_count() ||
           (field_.may_bend(root) && std::ranges::find(passed_, root) == passed_.end());
  }

  /// As follow, by a search.
  Index search(const Piece& piece) {
    const bool is_last = is_unknown(piece) && last_piece_ != nullptr;
    const PathSearch::Piece found = is_last ? *last_piece_ : search_for(piece);
    const double slack = kPathWrong * (piece.distance + mesh_.mean_edge_length());
    if (found.root == kNone || !(found.distance <= piece.distance + slack)) lost(piece);
    for (const PathSearch::End& end : found.ends) {
      points_.add(InternalPoint(end.vertex), end.face, 0);
    }
    for (const PathSearch::EdgePoint& c : found.edge_points) {
      points_.add_edge_point(c.side, c.x, c.step);
    }
    points_.add(found.at, found.half_edge / 3, found.rest);
    // Vertices at one position have the same distance: the path must not return.
    const bool gains = found.root >= mesh_.vertex_count() || found.root_distance < piece.distance;
    if (gains) passed_.clear();
    if (!gains && piece.end.is_vertex()) passed_.push_back(piece.end.vertex);
    return found.root;
  }

  PathSearch::Piece search_for(const Piece& piece) const {
    PathSearch search(field_, piece.end, piece.distance, passed_);
    const bool aims = !field_.are_shortest() && !is_unknown(piece);
    return aims ? search.run_towards(piece.root, piece.length) : search.run();
  }

  /// The point where the line of a piece leaves a face, in the frame of the twin of a half-edge.
  /// The twin may be missing.
  struct Line {
    Index side;   ///< the half-edge by which it leaves
    double x;     ///< the point is (x, 0): the distance from the head of `side`
    Point2 root;  ///< the root of the piece
    double step;  ///< its length in the face
  };

  /// Adds the points of a piece after its end, as long as no choice decides where its line goes.
  /// @return whether the line leads to the root
  bool walk(const Piece& piece) {
    strayed_ = 0;
    const double slack = piece.part(kPathThrough);
    if (const auto root = root_on_face(piece, piece.half_edge)) {
      return arrive(piece, piece.half_edge, piece.at, piece.from, *root);
    }
    std::optional<Line> line = leave_first(piece, slack);
    for (Index faces = 0; line && faces < mesh_.face_count(); ++faces) {
      const Index in = mesh_.twin(line->side);
      if (in == kNone || has_several_sheets(line->side)) return false;
      if (const auto root = root_on_face(piece, in)) {
        return arrive(piece, in, {line->x, 0}, line->root, *root);
      }
      line = cross(*line, in, slack);
    }
    return false;
  }

  /// How the line of a piece leaves its first face: by the half-edge, or through an end of it.
  std::optional<Line> leave_first(const Piece& piece, double slack) {
    const Index h = piece.half_edge;
    const Direction to_root(minus(piece.from, piece.at), piece.length);
    Line line = leave(h, piece.at, piece.from, to_root, Side::own);
    double nearest = kInfinity;  // length to the end that the line runs through
    for (const bool head : {false, true}) {
      const Point2 to_end = minus({head ? piece.side : 0, 0}, piece.at);
      if (!is_through(to_root, to_end, piece.length, slack)) continue;
      if (field_.may_bend(head ? mesh_.head(h) : mesh_.origin(h))) return std::nullopt;
      if (norm(to_end) < nearest) line = leave_through_end(piece, head, slack);
      nearest = std::min(nearest, norm(to_end));
    }
    if (nearest == kInfinity && h == edge_under(piece.end)) {  // the line leaves where it ends
      line.x = piece.side * piece.end.weights[h % 3];
      return line;
    }
    points_.add_edge_point(line.side, line.x, line.step);
    return line;
  }

  /// How a line leaves the face that it has entered by a half-edge.
  std::optional<Line> cross(const Line& line, Index in, double slack) {
    if (!(line.root.y > 0)) return std::nullopt;
    const HalfEdge& e = mesh_.half_edge(in);
    const Point2 here = {line.x, 0};
    const Point2 to_apex = minus({e.apex_x, e.apex_y}, here), ahead = minus(line.root, here);
    const double left_to_go = norm(ahead);
    const Direction direction(ahead, left_to_go);
    const bool by_right = direction.across(to_apex) > 0;
    Line next;
    if (!is_through(direction, to_apex, left_to_go, slack)) {
      next = leave(in, here, line.root, direction, by_right ? Side::right : Side::left);
    } else if (!field_.may_bend(mesh_.apex(in))) {
      next = leave_through_apex(in, line, by_right, slack);
    } else {
      return std::nullopt;
    }
    points_.add_edge_point(next.side, next.x, next.step);
    return next;
  }

  /// A side of a face, relative to one of its half-edges: itself, the previous one, the next one.
  enum class Side : std::uint8_t { own, left, right };

  /// Returns the point where a line leaves the face of h by one of its sides.
  /// @param at, root a point of the line and the root, in the frame of h
  Line leave(Index h, const Point2& at, const Point2& root, const Direction& line, Side side) {
    const FaceFrame f = face_frame(mesh_, h);
    if (side == Side::own) {
      const double t = meeting(line, at, {1, 0}, f.length);
      return {h, f.length - t, {f.length - root.x, -root.y}, norm(minus({t, 0}, at))};
    }
    if (side == Side::left) {
      const double x = meeting(line, at, {f.left_x, f.left_y}, f.left);
      const Point2 out = {x * f.left_x, x * f.left_y};
      return {Mesh::previous(h), x, f.to_left(root.x, root.y), norm(minus(out, at))};
    }
    const double u = meeting(line, minus(at, {f.length, 0}), {-f.right_x, -f.right_y}, f.right);
    const Point2 out = {f.length - u * f.right_x, -u * f.right_y};
    return {Mesh::next(h), f.right - u, f.to_right(root.x, root.y), norm(minus(out, at))};
  }

  /// Returns how a line leaves a face through its apex.
  /// @param right whether the line seems to pass to the right of the apex
  Line leave_through_apex(Index in, const Line& line, bool right, double slack) const {
    const FaceFrame f = face_frame(mesh_, in);
    const Point2 on_left = f.to_left(line.root.x, line.root.y);
    const Point2 on_right = f.to_right(line.root.x, line.root.y);
    const double step = norm(minus({f.apex_x, f.apex_y}, {line.x, 0}));
    const bool by_right = goes_first(
        Mesh::next(in), Mesh::previous(in),
        right ? is_first(on_right.y, on_left.y, slack) : !is_first(on_left.y, on_right.y, slack));
    if (by_right) return {Mesh::next(in), 0, on_right, step};
    return {Mesh::previous(in), f.left, on_left, step};
  }

  /// Returns how the line of a piece leaves its first face through an end of its half-edge.
  Line leave_through_end(const Piece& piece, bool head, double slack) const {
    const Index h = piece.half_edge;
    const FaceFrame f = face_frame(mesh_, h);
    const auto [x, y] = piece.from;
    const double step = to_end(piece, head);
    const Point2 beyond = head ? f.to_right(x, y) : f.to_left(x, y);
    if (goes_first(h, head ? Mesh::next(h) : Mesh::previous(h), is_first(-y, beyond.y, slack))) {
      return {h, head ? 0 : f.length, {f.length - x, -y}, step};
    }
    if (head) return {Mesh::next(h), f.right, beyond, step};
    return {Mesh::previous(h), 0, beyond, step};
  }

  /// Whether a line through the common corner of two sides leaves by the first one: unless it runs
  /// along that side.
  /// @param first, second distance of the root beyond the side
  static bool is_first(double first, double second, double slack) {
    return first > slack || first >= second;
  }

  /// Whether a line leaves by the first of two sides: because it is wanted, or because the second
  /// one is on the boundary and the line runs along it.
  bool goes_first(Index first, Index second, bool wanted) const {
    if (mesh_.twin(first) == kNone) return false;
    return wanted || mesh_.twin(second) == kNone;
  }

  /// Distance from the end of a piece to an end of its half-edge; exact along a side.
  double to_end(const Piece& piece, bool head) const {
    const Index h = piece.half_edge;
    if (piece.end.is_vertex()) {
      return mesh_.half_edge(head ? Mesh::next(h) : Mesh::previous(h)).length;
    }
    return norm(minus({head ? piece.side : 0, 0}, piece.at));
  }

  bool has_several_sheets(Index h) const {
    return mesh_.crosses_non_manifold_edges() &&
           mesh_.twin(mesh_.next_sheet(h)) != mesh_.mirrored(h);
  }

  /// Whether a line runs through a vertex, up to rounding.
  /// @param to_vertex from a point of the line
  /// @param length from that point to the root
  static bool is_through(const Direction& line, const Point2& to_vertex, double length,
                         double slack) {
    const double along = line.along(to_vertex);
    return std::abs(line.across(to_vertex)) <= slack && along > -slack && along < length + slack;
  }

  /// Distance from a corner to the point where a line crosses a side of a face.
  /// @param at a point of the line, relative to the corner
  /// @param side direction from the corner, of length 1
  double meeting(const Direction& line, const Point2& at, const Point2& side, double length) {
    const double corner = line.across(at), along = line.across(side);
    const double from_corner = corner / along;
    if (from_corner >= 0 && from_corner <= length) return from_corner;
    const bool beyond = from_corner > length;
    const double missed = std::abs(beyond ? corner - along * length : corner);
    strayed_ = std::max(strayed_, missed);
    return beyond ? length : 0;
  }

  /// Position of the root of a piece in the frame of h, if the face of h contains it.
  std::optional<Point2> root_on_face(const Piece& piece, Index h) const {
    const HalfEdge& e = mesh_.half_edge(h);
    if (piece.root < mesh_.vertex_count()) {
      if (mesh_.apex(h) == piece.root) return Point2{e.apex_x, e.apex_y};
      if (e.origin == piece.root) return Point2{0, 0};
      if (mesh_.head(h) == piece.root) return Point2{e.length, 0};
      return std::nullopt;
    }
    for (const InternalPoint& source : images_of(piece.root)) {
      if (source.face == h / 3) return in_frame(mesh_, source, h);
    }
    return std::nullopt;
  }

  /// Ends a piece at its root, which is on the face of h.
  /// @param here a point of the line, in the frame of h
  /// @param aim, at position of the root according to the line, and its actual position
  /// @return whether the line has led there
  bool arrive(const Piece& piece, Index h, const Point2& here, const Point2& aim,
              const Point2& at) {
    const double allowed = piece.part(kPathStray);
    if (!(norm(minus(aim, at)) <= allowed && strayed_ <= allowed)) return false;
    if (piece.root >= mesh_.vertex_count()) {
      points_.add(images_of(piece.root).front(), h / 3, norm(minus(at, here)));
      return true;
    }
    const bool is_on_side = h == piece.half_edge && piece.root != mesh_.apex(h);
    const double rest =
        is_on_side ? to_end(piece, piece.root == mesh_.head(h)) : norm(minus(at, here));
    points_.add(InternalPoint(piece.root), h / 3, rest);
    return true;
  }

  const DistanceField& field_;
  const Mesh& mesh_;
  std::span<const LastSegment> last_segments_;
  const PathSearch::Piece* last_piece_;
  bool walks_;
  PathPoints points_;
  std::vector<Index> passed_;  // vertices at the position of the last one
  double strayed_ = 0;         // largest distance of the line from its faces
};

}  // namespace

Path trace_path(const DistanceField& field, std::span<const LastSegment> last_segments,
                const InternalPoint& end, double distance, const LastSegment& last_segment,
                const PathSearch::Piece* last) {
  const auto off = [&](const Path& path) {
    const double length = path.length() + field.query().sources[path.source].distance;
    return field.are_shortest() ? std::abs(length - distance) : std::max(length - distance, 0.0);
  };
  const double edge = field.mesh().mean_edge_length();
  Path path = Trace(field, last_segments, last, true).run(end, distance, last_segment);
  if (off(path) <= kPathStray * distance + kPathRounding * edge) return path;
  try {
    Path found = Trace(field, last_segments, last, false).run(end, distance, last_segment);
    if (off(found) < off(path)) path = std::move(found);
  } catch (const std::runtime_error&) {
    // Distances as exact as these give no path: the first one stays, or is rejected below.
  }
  if (off(path) > kPathWrong * (distance + edge)) {
    Trace::lose(field.mesh(), end, last_segment.root);
  }
  return path;
}

std::string name_of(const Mesh& mesh, const InternalPoint& own) {
  const MeshNumbers& numbers = mesh.numbers();
  if (own.is_vertex()) return "vertex " + std::to_string(numbers.external_vertex(own.vertex));
  return "the point in face " + std::to_string(numbers.external_face(own.face));
}

}  // namespace geodesic
