#include "solvers/paths/paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "solvers/core/tolerance.h"
#include "solvers/paths/search.h"

namespace geodesic {
namespace {

Point2 minus(const Point2& a, const Point2& b) { return {a.x - b.x, a.y - b.y}; }

/// A vector of length 1: products with lengths of any unit stay within range.
struct Direction {
  explicit Direction(const Point2& a) : Direction(a, norm(a)) {}
  Direction(const Point2& a, double length) : x(a.x / length), y(a.y / length) {}

  double along(const Point2& a) const { return x * a.x + y * a.y; }
  /// Component across the direction, positive to the left.
  double across(const Point2& a) const { return x * a.y - y * a.x; }

  double x, y;
};

constexpr const char* kRoundabout =
    "the paths that the solver remembers come from no source; please report this mesh and query";

std::string name_of(const Mesh& mesh, const InternalPoint& own) {
  const MeshNumbers& numbers = mesh.numbers();
  if (own.is_vertex()) return "vertex " + std::to_string(numbers.external_vertex(own.vertex));
  return "the point in face " + std::to_string(numbers.external_face(own.face));
}

[[noreturn]] void refuse_path(const Mesh& mesh, const InternalPoint& own) {
  throw std::invalid_argument("no path leads to " + name_of(mesh, own));
}

}  // namespace

/// One path, from its end back to its source.
///
/// A straight piece is followed with its root unfolded: where the line enters a face, the direction
/// to the root selects the side by which it leaves, and the root is unfolded into the next face.
/// Errors do not accumulate, since every face aims at the root again. A face that contains the root
/// ends the piece, since nothing is shorter than a straight line in space.
///
/// A line within rounding (kPathThrough) of a vertex runs through it. If paths may bend at that
/// vertex, the faces on its two sides lead to different places: the piece ends there, and the path
/// of the vertex, which is as short (kPathTie), continues it.
///
/// A recorded piece was found with the tolerance kApexReach, and a straight line need not follow it
/// within rounding. If it does not, the piece is searched (search.h).
class Paths::Trace {
 public:
  /// @param last the last piece of a path without a LastSegment
  explicit Trace(const Paths& of, const Search::Piece* last = nullptr)
      : of_(of), mesh_(of.mesh_), last_piece_(last) {}

  /// Returns a path only if its length equals the distance of its end, or is below it if paths are
  /// not shortest ones. If lines failed, over needles and faces without area, the path is searched
  /// by distances.
  Path run(const InternalPoint& end, double distance, const LastSegment& last_segment) {
    const auto off = [&](const Path& path) {
      const double length = path.length() + of_.query_.sources[path.source].distance;
      return of_.are_shortest_ ? std::abs(length - distance) : std::max(length - distance, 0.0);
    };
    const double edge = mesh_.mean_edge_length();
    Path path = trace(end, distance, last_segment);
    if (off(path) <= kPathStray * distance + kPathRounding * edge) return path;
    trusts_lines_ = false;
    try {
      Path found = trace(end, distance, last_segment);
      if (off(found) < off(path)) path = std::move(found);
    } catch (const std::runtime_error&) {
      // Distances as exact as these give no path: the first one stays, or is rejected below.
    }
    if (off(path) > kPathWrong * (distance + edge)) lost(piece_to(end, distance, last_segment));
    return path;
  }

 private:
  Path trace(const InternalPoint& end, double distance, const LastSegment& last_segment) {
    points_.clear();
    passed_.clear();
    add(end, kNone, 0);
    Piece piece = piece_to(end, distance, last_segment);
    for (Index bends = 0; !begins_at_end(piece); ++bends) {
      if (bends > mesh_.vertex_count()) lost(piece);
      const Index root = follow(piece);
      if (root >= mesh_.vertex_count()) return from_source(root - mesh_.vertex_count());
      piece = piece_to(InternalPoint(root), of_.distance(root), of_.last_segments_[root]);
    }
    const auto source = of_.source_at_.find(piece.root);
    if (source == of_.source_at_.end()) lost(piece);
    return from_source(source->second);
  }

  /// A straight piece. Points are in the frame of a half-edge of the face that it ends in.
  struct Piece {
    InternalPoint end;
    double distance;  ///< distance of the end
    Index half_edge;
    Index root;  ///< as in LastSegment
    Point2 from;
    Point2 at = {0, 0};                          ///< position of the end
    std::span<const InternalPoint> source = {};  ///< images of the root if it is not a vertex
    double length = 0;
    double side = 0;  ///< length of the half-edge

    /// A part of the length, plus the rounding error of points of the half-edge.
    double part(double relative) const { return relative * length + kPathRounding * side; }
  };

  /// The point where the line of a piece leaves a face, in the frame of the twin of a half-edge.
  /// The twin may be missing.
  struct Line {
    Index side;   ///< the half-edge by which it leaves
    double x;     ///< the point is (x, 0): the distance from the head of `side`
    Point2 root;  ///< the root of the piece
    double step;  ///< its length in the face
  };

  /// The continuation of a line beyond a face.
  struct Way {
    Line line;
    Index through;     ///< the half-edge whose twin it enters: line.side, or of another sheet
    double travelled;  ///< length from the end of the piece
  };

  /// An alternative way, and the state of the trace at its beginning.
  struct Fork {
    Way way;
    std::size_t points;
    InternalPoint last;
    double strayed;
  };

  struct Step {
    enum Kind : std::uint8_t { went_on, ended, failed } kind;
    Index root = kNone;  ///< root of the piece, if it has ended
  };

  /// A side of a face, relative to one of its half-edges: itself, the previous one, the next one.
  enum class Side : std::uint8_t { own, left, right };

  Piece piece_to(const InternalPoint& end, double distance, const LastSegment& last_segment) const {
    Piece piece{end, distance, last_segment.half_edge, last_segment.root, last_segment.from};
    if (begins_at_end(piece) || is_unknown(piece)) return piece;
    const Index vertices = mesh_.vertex_count();
    if (piece.half_edge >= mesh_.half_edge_count() ||
        piece.root >= vertices + of_.query_.sources.size()) {
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
    if (piece.root >= vertices) {
      piece.source = of_.source_images_[piece.root - vertices];
      if (piece.source.empty()) lost(piece);
    }
    piece.side = mesh_.half_edge(piece.half_edge).length;
    piece.length = norm(minus(piece.from, piece.at));
    return piece;
  }

  static bool begins_at_end(const Piece& piece) {
    return piece.end.is_vertex() && piece.end.vertex == piece.root;
  }

  /// Whether the end is a point of a face without a LastSegment.
  static bool is_unknown(const Piece& piece) {
    return !piece.end.is_vertex() && piece.half_edge == kNone;
  }

  /// Adds the points of a piece after its end.
  /// @return the root of the piece, as in LastSegment
  Index follow(const Piece& piece) {
    if (!trusts_lines_ || is_unknown(piece)) return search(piece);
    const auto before = points_.size();
    const InternalPoint last = last_;
    const Index root = walk(piece);
    // The path of a target may pass a corner of its face, as straight as the window beside it.
    const bool begins = root >= mesh_.vertex_count() || of_.may_bend(root);
    if (root != kNone && begins && std::ranges::find(passed_, root) == passed_.end()) return root;
    points_.resize(before);
    last_ = last;
    return search(piece);
  }

  /// As follow, if the line of the piece does not lead to its root.
  Index search(const Piece& piece) {
    const bool is_last = is_unknown(piece) && last_piece_ != nullptr;
    const Search::Piece found = is_last ? *last_piece_ : search_for(piece);
    const double slack = kPathWrong * (piece.distance + mesh_.mean_edge_length());
    if (found.root == kNone || !(found.distance <= piece.distance + slack)) lost(piece);
    for (const Search::End& end : found.ends) add(InternalPoint(end.vertex), end.face, 0);
    for (const Search::Crossing& c : found.crossings) add_crossing(c.side, c.x, c.step);
    add(found.at, found.half_edge / 3, found.rest);
    // Vertices at one position have the same distance: the path must not return.
    const bool gains = found.root >= mesh_.vertex_count() || found.before < piece.distance;
    if (gains) passed_.clear();
    if (!gains && piece.end.is_vertex()) passed_.push_back(piece.end.vertex);
    return found.root;
  }

  Search::Piece search_for(const Piece& piece) const {
    Search search(of_, piece.end, piece.distance, passed_);
    const bool aims = !of_.are_shortest_ && !is_unknown(piece);
    return aims ? search.run_towards(piece.root, piece.length) : search.run();
  }

  /// Adds the points of a piece after its end.
  /// @return the root of the piece; kNone if its line does not lead to the root
  Index walk(const Piece& piece) {
    strayed_ = 0;
    const Index h = piece.half_edge;
    if (const auto root = root_on_face(piece, h)) {
      return arrive(piece, h, piece.at, piece.from, *root);
    }
    const double slack = piece.part(kPathThrough);
    const Direction to_root(minus(piece.from, piece.at), piece.length);
    Line line = leave(h, piece.at, piece.from, to_root, Side::own);
    double nearest = kInfinity;  // length to the end of h that the line runs through
    for (const bool head : {false, true}) {
      const Index v = head ? mesh_.head(h) : mesh_.origin(h);
      const Point2 to = minus({head ? mesh_.half_edge(h).length : 0, 0}, piece.at);
      const double along = to_root.along(to), across = to_root.across(to);
      if (is_through(along, across, piece.length, slack)) {
        const double rest = to_end(piece, head);
        if (turns(piece, v, rest)) return add(InternalPoint(v), h / 3, rest);
        if (rest < nearest) line = leave_through_end(piece, head, slack);
        nearest = std::min(nearest, rest);
      }
    }
    if (nearest < kInfinity || !leaves_at_end(piece, line)) {
      add_crossing(line.side, line.x, line.step);
    }
    return go_on(piece, {line, line.side, line.step}, slack);
  }

  /// Follows a line beyond its first face. If several faces lie beyond an edge, the recording does
  /// not tell which one is right: they are tried in order, until distances exclude them.
  /// @return as walk()
  Index go_on(const Piece& piece, Way way, double slack) {
    forks_.clear();
    for (Index faces = 0; faces < mesh_.face_count(); ++faces) {
      if (mesh_.crosses_non_manifold_edges()) remember_other_sheet(way);
      const Step step = cross(piece, way, slack);
      if (step.kind == Step::ended && strayed_ <= piece.part(kPathStray)) return step.root;
      if (step.kind != Step::went_on && !take_other_sheet(way)) return kNone;
    }
    return kNone;
  }

  /// Crosses the next face on the way of a line.
  Step cross(const Piece& piece, Way& way, double slack) {
    const Line& line = way.line;
    const Index in = mesh_.twin(way.through);
    if (in == kNone) return {Step::failed};
    const Point2 here = {line.x, 0};
    if (const auto root = root_on_face(piece, in)) {
      const Index arrived = arrive(piece, in, here, line.root, *root);
      return {arrived == kNone ? Step::failed : Step::ended, arrived};
    }
    if (!(line.root.y > 0)) return {Step::failed};
    const HalfEdge& e = mesh_.half_edge(in);
    const Index apex = mesh_.apex(in);
    const Point2 to_apex = minus({e.apex_x, e.apex_y}, here), ahead = minus(line.root, here);
    if (mesh_.crosses_non_manifold_edges()) {
      const double off = std::abs(of_.distance(apex) - (piece.distance - way.travelled));
      if (off > norm(to_apex) + piece.part(kPathWrong)) return {Step::failed};
    }
    const double left_to_go = norm(ahead);
    const Direction direction(ahead, left_to_go);
    const double along = direction.along(to_apex), across = direction.across(to_apex);
    if (is_through(along, across, left_to_go, slack)) {
      const double rest = norm(to_apex);
      if (turns(piece, apex, way.travelled + rest)) {
        return {Step::ended, add(InternalPoint(apex), in / 3, rest)};
      }
      way.line = leave_through_apex(in, line, across > 0, slack);
    } else {
      way.line = leave(in, here, line.root, direction, across > 0 ? Side::right : Side::left);
    }
    way.through = line.side;
    way.travelled += line.step;
    add_crossing(line.side, line.x, line.step);
    return {Step::went_on};
  }

  /// Stores the way through the next face beyond an edge, in case the present one is wrong.
  void remember_other_sheet(const Way& way) {
    if (mesh_.twin(way.through) == kNone) return;
    const Index next = mesh_.next_sheet(way.through);
    if (mesh_.twin(next) == mesh_.mirrored(way.line.side)) return;
    forks_.push_back({{way.line, next, way.travelled}, points_.size(), last_, strayed_});
  }

  /// Returns to the last fork.
  /// @return false if there is none
  bool take_other_sheet(Way& way) {
    if (forks_.empty()) return false;
    const Fork& fork = forks_.back();
    way = fork.way;
    points_.resize(fork.points);
    last_ = fork.last;
    strayed_ = fork.strayed;
    forks_.pop_back();
    return true;
  }

  /// Whether a line leaves its first face at the end of the piece; if so, makes it exact to the
  /// last bit.
  bool leaves_at_end(const Piece& piece, Line& line) const {
    const Index side = line.side;
    if (piece.end.is_vertex()) {
      if (side == piece.half_edge) return false;
      line.x = side == Mesh::next(piece.half_edge) ? 0 : mesh_.half_edge(side).length;
    } else {
      if (side != edge_under(piece.end)) return false;
      line.x = mesh_.half_edge(side).length * piece.end.weights[side % 3];
    }
    line.step = 0;
    return true;
  }

  /// Whether a line runs through a vertex, up to rounding.
  /// @param along, across position of the vertex relative to the line
  /// @param length distance to the root
  static bool is_through(double along, double across, double length, double slack) {
    return std::abs(across) <= slack && along > -slack && along < length + slack;
  }

  /// Distance from a corner to the point where a line crosses a side of a face.
  /// @param at a point of the line, relative to the corner
  /// @param side direction from the corner, of length 1
  double crossing(const Direction& line, const Point2& at, const Point2& side, double length) {
    const double corner = line.across(at), along = line.across(side);
    const double from_corner = corner / along;
    if (from_corner >= 0 && from_corner <= length) return from_corner;
    const bool beyond = from_corner > length;
    const double missed = std::abs(beyond ? corner - along * length : corner);
    strayed_ = std::max(strayed_, missed);
    return beyond ? length : 0;
  }

  /// Returns the point where a line leaves the face of h by one of its sides.
  /// @param at, root a point of the line and the root, in the frame of h
  Line leave(Index h, const Point2& at, const Point2& root, const Direction& line, Side side) {
    const FaceFrame f = face_frame(mesh_, h);
    if (side == Side::own) {
      const double t = crossing(line, at, {1, 0}, f.length);
      return {h, f.length - t, {f.length - root.x, -root.y}, norm(minus({t, 0}, at))};
    }
    if (side == Side::left) {
      const double x = crossing(line, at, {f.left_x, f.left_y}, f.left);
      const Point2 out = {x * f.left_x, x * f.left_y};
      return {Mesh::previous(h), x, f.to_left(root.x, root.y), norm(minus(out, at))};
    }
    const double u = crossing(line, minus(at, {f.length, 0}), {-f.right_x, -f.right_y}, f.right);
    const Point2 out = {f.length - u * f.right_x, -u * f.right_y};
    return {Mesh::next(h), f.right - u, f.to_right(root.x, root.y), norm(minus(out, at))};
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

  /// Distance from the end of a piece to an end of its half-edge; exact along a side.
  double to_end(const Piece& piece, bool head) const {
    const Index h = piece.half_edge;
    if (piece.end.is_vertex()) {
      return mesh_.half_edge(head ? Mesh::next(h) : Mesh::previous(h)).length;
    }
    return norm(minus({head ? mesh_.half_edge(h).length : 0, 0}, piece.at));
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
    for (const InternalPoint& source : piece.source) {
      if (source.face == h / 3) return in_frame(mesh_, source, h);
    }
    return std::nullopt;
  }

  /// Ends a piece at its root, which is on the face of h.
  /// @param here a point of the line, in the frame of h
  /// @param aim, at position of the root according to the line, and its actual position
  Index arrive(const Piece& piece, Index h, const Point2& here, const Point2& aim,
               const Point2& at) {
    const double off = norm(minus(aim, at));
    if (!(off <= piece.part(kPathStray))) return kNone;
    double rest = norm(minus(at, here));
    InternalPoint root(piece.root);
    if (piece.root >= mesh_.vertex_count()) {
      root = piece.source.front();
    } else {
      const Index first = piece.half_edge;
      if (h == first && piece.root != mesh_.apex(h)) {
        rest = to_end(piece, piece.root != mesh_.origin(first));
      }
    }
    add(root, h / 3, rest);
    return piece.root;
  }

  /// Whether the path through v as a bend is as short as the piece, which runs through v.
  /// @param rest length from v to the end of the piece
  bool turns(const Piece& piece, Index v, double rest) const {
    const double through = of_.distance(v);
    const bool nearer = through < piece.distance || !piece.end.is_vertex();
    return of_.may_bend(v) && nearer && through + rest <= piece.distance * (1 + kPathTie);
  }

  /// Adds the point where a line leaves a face.
  /// @param x distance from the head of h, by which the line leaves
  void add_crossing(Index h, double x, double step) {
    const double length = mesh_.half_edge(h).length;
    const double at_origin = length > 0 ? x / length : 0, at_head = 1 - at_origin;
    InternalPoint point;
    if (std::min(at_origin, at_head) <= kWeightSum) {  // equal to a vertex up to rounding
      point.vertex = at_head > at_origin ? mesh_.head(h) : mesh_.origin(h);
    } else {
      point.face = h / 3;
      point.weights[h % 3] = at_origin;
      point.weights[Mesh::next(h) % 3] = at_head;
    }
    add(point, h / 3, step);
  }

  /// Adds the next point towards the source, unless it equals the last point.
  /// @param face shared with the previous point
  /// @return the vertex at the point, or kNone
  Index add(const InternalPoint& image, Index face, double step) {
    const InternalPoint own = in_given_face(mesh_, image);
    if (!points_.empty() && own == last_) return own.vertex;
    last_ = own;
    PathPoint point;
    point.at = in_external_numbers(mesh_, own);
    point.position = position_of(mesh_, own);
    point.travelled = step;
    if (face != kNone) point.face = mesh_.numbers().external_face(face % mesh_.given_face_count());
    points_.push_back(point);
    return own.vertex;
  }

  /// Returns the whole path, from its source.
  Path from_source(Index source) {
    std::ranges::reverse(points_);
    double travelled = 0;
    for (PathPoint& point : points_) {
      travelled += std::exchange(point.travelled, travelled);
    }
    return {source, std::move(points_)};
  }

  [[noreturn]] void lost(const Piece& piece) const {
    const bool vertex = piece.root < mesh_.vertex_count();
    const std::string root = vertex                ? name_of(mesh_, InternalPoint(piece.root))
                             : piece.root == kNone ? "nothing"
                                                   : "a source in a face";
    throw std::runtime_error("the solver remembers a path to " + name_of(mesh_, piece.end) +
                             " from " + root +
                             " that does not exist; please report this mesh and query");
  }

  const Paths& of_;
  const Mesh& mesh_;
  const Search::Piece* last_piece_;
  std::vector<PathPoint> points_;  // from the end; `travelled` is the length from the previous one
  InternalPoint last_;
  std::vector<Index> passed_;  // vertices at the position of the last one
  std::vector<Fork> forks_;    // of the present line
  bool trusts_lines_ = true;   // false: pieces are searched by distances alone
  double strayed_ = 0;         // largest distance of the last line from its faces
};

Paths::Paths(const Mesh& mesh, const Query& query, std::vector<double> distances,
             Recording recording)
    : mesh_(mesh),
      query_(in_internal_numbers(mesh, query)),
      are_shortest_(recording.shortest_paths),
      distances_(std::move(distances)),
      last_segments_(std::move(recording.last_segments)),
      targets_(std::move(recording.targets)) {
  const std::size_t vertices = mesh.vertex_count();
  if (recording.kind != RecordingKind::paths || last_segments_.size() != vertices ||
      distances_.size() != vertices || targets_.size() != query_.targets.size()) {
    throw std::invalid_argument("paths need a recording of paths, of this mesh and query");
  }
  if (query_.stop_at_targets) {
    farthest_ = std::ranges::max(targets_, {}, &AtTarget::distance).distance;
  }
  farthest_ = std::min(farthest_, query_.limit);
  source_images_.resize(query_.sources.size());
  for (Index i = 0; i < query_.sources.size(); ++i) {
    const InternalSource& source = query_.sources[i];
    if (!source.at.is_vertex()) {
      source_images_[i] = in_every_face(mesh, source.at);
      continue;
    }
    const auto [at, first] = source_at_.try_emplace(source.at.vertex, i);
    if (!first && source.distance < query_.sources[at->second].distance) at->second = i;
  }
}

bool Paths::may_bend(Index v) const {
  return !are_shortest_ || mesh_.is_pseudo_source(v) || source_at_.contains(v);
}

Index Paths::internal_vertex(Index given) const {
  const std::string defect = defect_of(mesh_, SurfacePoint(given));
  if (!defect.empty()) throw std::invalid_argument(defect);
  return mesh_.numbers().internal_vertex(given);
}

double Paths::distance_at(const SurfacePoint& point) const {
  const std::string defect = defect_of(mesh_, point);
  if (!defect.empty()) throw std::invalid_argument(defect);
  if (point.is_vertex()) return distances_[point.vertex];
  return Search::from_face(*this, in_internal_numbers(mesh_, point)).distance;
}

Path Paths::to_point(const SurfacePoint& point) const {
  if (point.is_vertex()) return to_vertex(point.vertex);
  const std::string defect = defect_of(mesh_, point);
  if (!defect.empty()) throw std::invalid_argument(defect);
  const InternalPoint own = in_internal_numbers(mesh_, point);
  const Search::Piece last = Search::from_face(*this, own);
  if (last.distance == kInfinity) refuse_path(mesh_, own);
  return Trace(*this, &last).run(own, last.distance, {});
}

Path Paths::to_vertex(Index v) const {
  const InternalPoint own(internal_vertex(v));
  if (distances_[v] == kInfinity) refuse_path(mesh_, own);
  return Trace(*this).run(own, distances_[v], last_segments_[own.vertex]);
}

Path Paths::to_target(std::size_t i) const {
  const AtTarget& target = targets_.at(i);
  const InternalPoint& own = query_.targets[i];
  if (target.distance == kInfinity) refuse_path(mesh_, own);
  return Trace(*this).run(own, target.distance, target.last_segment);
}

std::optional<Index> Paths::source_here(Index v) const {
  const Index root = last_segments_[v].root, vertices = mesh_.vertex_count();
  if (root == kNone) return kNone;
  if (root >= vertices) return root - vertices;
  if (root != v) return std::nullopt;
  const auto source = source_at_.find(v);
  return source == source_at_.end() ? kNone : source->second;
}

Index Paths::nearest_source(Index v) const {
  Index at = internal_vertex(v);
  if (distances_[v] == kInfinity) return kNone;
  for (Index bends = 0; bends <= mesh_.vertex_count(); ++bends) {
    if (const auto source = source_here(at)) return *source;
    at = last_segments_[at].root;
  }
  throw std::runtime_error(kRoundabout);
}

std::vector<Index> Paths::nearest_sources() const {
  const Index vertices = mesh_.vertex_count();
  std::vector<std::optional<Index>> nearest(vertices);
  std::vector<Index> given(vertices, kNone), chain;
  for (Index v = 0; v < vertices; ++v) {
    if (distance(v) == kInfinity) continue;
    Index at = v;
    while (!nearest[at] && !(nearest[at] = source_here(at))) {
      if (chain.size() > vertices) throw std::runtime_error(kRoundabout);
      chain.push_back(at);
      at = last_segments_[at].root;
    }
    for (const Index each : chain) nearest[each] = nearest[at];
    chain.clear();
    given[mesh_.numbers().external_vertex(v)] = *nearest[v];
  }
  return given;
}

Paths solve_paths(Solver& solver, const Mesh& mesh, const Query& query) {
  std::vector<double> distances(mesh.vertex_count());
  Recording recording;
  recording.kind = RecordingKind::paths;
  solver.solve(query, distances, &recording);
  return {mesh, query, std::move(distances), std::move(recording)};
}

}  // namespace geodesic
