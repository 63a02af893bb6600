#include "solvers/paths/search.h"

#include <algorithm>
#include <cmath>

#include "solvers/core/tolerance.h"

namespace geodesic {
namespace {

double distance_between(const Point2& a, const Point2& b) {
  return norm(Point2{a.x - b.x, a.y - b.y});
}

/// A line of sight.
class Ray {
 public:
  /// @param otherwise direction, of length 1, if `through` is at the eye
  /// @param slack rounding error of the eye
  Ray(const Point2& eye, const Point2& through, const Point2& otherwise, double slack)
      : eye_(eye), to_{through.x - eye.x, through.y - eye.y} {
    const double length = norm(to_);
    to_ = length > slack ? Point2{to_.x / length, to_.y / length} : otherwise;
    spread_ = length > slack ? slack / length : 0;
  }
  /// Distance of a point to the left of the ray.
  double across(const Point2& p) const { return to_.x * (p.y - eye_.y) - to_.y * (p.x - eye_.x); }
  /// Rounding error of the ray at a point: rounding rotates a line through a point next to the eye.
  double spread(const Point2& p) const { return spread_ * distance_between(p, eye_); }
  /// Distance from a corner to the point where the ray crosses a side of the face.
  /// @param side direction from the corner, of length 1
  /// @param along the result if the ray is parallel to the side
  /// @param outwards 1 or -1: the direction in which the rounding error is added
  double meeting(const Point2& corner, const Point2& side, double length, double along,
                 double outwards) const {
    const double turn = to_.x * side.y - to_.y * side.x;
    if (turn == 0) return along;
    const double at = std::clamp(-across(corner) / turn, 0.0, length);
    const double moved = spread({corner.x + at * side.x, corner.y + at * side.y}) / std::abs(turn);
    return std::clamp(at + outwards * moved, 0.0, length);
  }

 private:
  Point2 eye_, to_;
  double spread_;  // an angle
};

/// The first and the last ray from the eye to the visible part of an edge.
Ray to_begin(const auto& view, double slack) { return {view.eye, {view.begin, 0}, {-1, 0}, slack}; }
Ray to_end(const auto& view, double slack) { return {view.eye, {view.end, 0}, {1, 0}, slack}; }

/// Rounding error of lines from the eye through a half-edge.
double rounding(const Point2& eye, double length) { return kPathThrough * (norm(eye) + length); }

}  // namespace

PathSearch::PathSearch(const DistanceField& field, const InternalPoint& end, double distance,
                       std::span<const Index> passed)
    : field_(field),
      mesh_(field.mesh()),
      end_(end),
      distance_(distance),
      tie_(kPathThrough * distance),
      passed_(passed) {}

// A search takes longer with a looser bound. If a search finds a distance within its bound, that is
// the distance. It lies between bounds from the distances of the corners.
PathSearch::Piece PathSearch::from_face(const DistanceField& field, const InternalPoint& end) {
  double most = field.farthest(), least = 0;
  const auto reach = [&](Index h, const Point2&, double length, bool) {
    const double corner = field[field.mesh().apex(h)];
    most = std::min(most, corner + length);
    if (corner < kInfinity) least = std::max(least, corner - length);
  };
  spread_from(field.mesh(), end, reach, [](Index, const Point2&) {});
  if (most == kInfinity) return {};
  Piece found;
  for (const double accuracy : accuracies(field)) {
    for (double share = 1.0 / 16; share <= 1; share *= 2) {
      const double bound = share == 1 ? most : least + share * (most - least);
      PathSearch search(field, end, bound, {});
      search.look_around(accuracy);
      found = search.piece_from(search.best_);
      if (found.distance <= bound) return found;
    }
  }
  // The way over a corner has another length here by rounding.
  found.distance = most < field.farthest() ? most : kInfinity;
  return found;
}

PathSearch::Piece PathSearch::run() {
  for (const double accuracy : accuracies(field_)) {
    look_around(accuracy);
    if (best_.distance <= distance_ + slack_) break;
  }
  return piece_from(best_);
}

std::array<double, 2> PathSearch::accuracies(const DistanceField& field) {
  return {field.are_shortest() ? kPathSearch : kPathSearchOfBounds, kPathWrong};
}

PathSearch::Piece PathSearch::run_towards(Index root, double length) {
  const Index vertices = mesh_.vertex_count();
  aim_ = root;
  aim_position_ = position_of(
      mesh_, root < vertices ? InternalPoint(root) : field_.images(root - vertices).front());
  to_aim_ = length;
  passed_ = {};
  return run();
}

/// Considers all roots that are visible from the end.
void PathSearch::look_around(double accuracy) {
  slack_ = accuracy * (distance_ + mesh_.mean_edge_length());
  ends_.clear();
  faces_.clear();
  views_.clear();
  views_of_.clear();
  best_ = {};
  if (end_.is_vertex()) {
    ends_.push_back({end_.vertex, kNone, kNone});
    for (Index i = 0; i < ends_.size(); ++i) start_at_vertex(i);
  } else {
    const std::vector<InternalPoint> images = in_every_face(mesh_, end_);
    for (const InternalPoint& end : images) faces_.push_back(end.face);
    for (const InternalPoint& end : images) start_in_face(end);
  }
  // The loop also visits the views that it adds.
  for (Index view = 0; view < views_.size(); ++view) look_beyond(view);
}

/// Starts at the end or at a vertex at the same position; such vertices are appended to `ends_`.
void PathSearch::start_at_vertex(Index i) {
  for (const Index outgoing : mesh_.outgoing(ends_[i].vertex)) {
    const Index h = Mesh::next(outgoing), back = Mesh::next(h);
    if (mesh_.half_edge(outgoing).length == 0) add_end(mesh_.head(outgoing), h / 3, i);
    if (mesh_.half_edge(back).length == 0) add_end(mesh_.origin(back), h / 3, i);
    const HalfEdge& e = mesh_.half_edge(h);
    const Point2 eye{e.apex_x, e.apex_y};
    const Root root{.half_edge = h, .end = i};
    consider_vertex(mesh_.origin(h), {0, 0}, eye, root);
    consider_vertex(mesh_.head(h), {e.length, 0}, eye, root);
    consider_sources(eye, root);
    see_from(h, eye, i);
  }
}

void PathSearch::add_end(Index vertex, Index face, Index previous) {
  if (!is_end(vertex)) ends_.push_back({vertex, face, previous});
}

bool PathSearch::is_end(Index vertex) const {
  return std::ranges::find(ends_, vertex, &End::vertex) != ends_.end();
}

/// @param end the end in one of its faces
void PathSearch::start_in_face(const InternalPoint& end) {
  // In the frame at the nearest corner: near it, coordinates have all digits of the weights.
  const auto nearest = std::ranges::max_element(end.weights) - end.weights.begin();
  const Index h = 3 * end.face + static_cast<Index>(nearest);
  const HalfEdge& e = mesh_.half_edge(h);
  const Point2 eye = in_frame(mesh_, end, h);
  const Root root{.half_edge = h};
  consider_vertex(mesh_.origin(h), {0, 0}, eye, root);
  consider_vertex(mesh_.head(h), {e.length, 0}, eye, root);
  consider_vertex(mesh_.apex(h), {e.apex_x, e.apex_y}, eye, root);
  consider_sources(eye, root);
  const Index under = edge_under(end);  // the face beyond has its own image of the end
  for (Index side = 3 * end.face; side < 3 * end.face + 3; ++side) {
    if (side != under) see_from(side, in_frame(mesh_, end, side), kNone);
  }
}

/// Looks through a side of a face of the end.
/// @param eye the end in the frame of the side
void PathSearch::see_from(Index side, const Point2& eye, Index end) {
  const double length = mesh_.half_edge(side).length;
  see(side, {length - eye.x, -eye.y}, 0, length, kNone, end);
}

void PathSearch::look_beyond(Index view) {
  const View seen = views_[view];
  const FaceFrame f = face_frame(mesh_, seen.in);
  const Point2 apex{f.apex_x, f.apex_y};
  const double slack = rounding(seen.eye, f.length);
  const Root root{.half_edge = seen.in, .view = view, .end = seen.first};
  consider_sources(seen.eye, root);
  const Ray first = to_begin(seen, slack), last = to_end(seen, slack);
  // Each is true if the side of that name is visible; the apex is visible if both are.
  const bool left = first.across(apex) <= slack + first.spread(apex);
  const bool right = last.across(apex) >= -slack - last.spread(apex);
  if (left && right) consider_vertex(mesh_.apex(seen.in), apex, seen.eye, root);
  if (left) {
    const Point2 origin{0, 0}, side{f.left_x, f.left_y};
    const double begin = first.meeting(origin, side, f.left, 0, -1);
    const double end = right ? f.left : last.meeting(origin, side, f.left, f.left, 1);
    see(Mesh::previous(seen.in), f.to_left(seen.eye.x, seen.eye.y), begin, end, view, seen.first);
  }
  if (right) {
    const Point2 head{f.length, 0}, side{-f.right_x, -f.right_y};
    const double begin = left ? 0 : f.right - first.meeting(head, side, f.right, f.right, 1);
    const double end = f.right - last.meeting(head, side, f.right, 0, -1);
    see(Mesh::next(seen.in), f.to_right(seen.eye.x, seen.eye.y), begin, end, view, seen.first);
  }
}

void PathSearch::see(Index side, const Point2& eye, double begin, double end, Index parent,
                     Index first) {
  mesh_.for_each_sheet(side, [&](Index sheet) {
    const View view{mesh_.twin(sheet),
                    {eye.x, std::min(eye.y, 0.0)},
                    std::min(begin, end),
                    end,
                    side,
                    parent,
                    first};
    if (!may_lead(view) || is_seen(view)) return;
    views_of_[view.in].push_back(static_cast<Index>(views_.size()));
    views_.push_back(view);
  });
}

/// Whether the path may run through a view, judged by the distances of the edge's ends.
bool PathSearch::may_lead(const View& view) const {
  const double length = mesh_.half_edge(view.in).length;
  // An edge without length has no frame; its ends are handled as vertices.
  if (length == 0) return false;
  // A vertex at the eye is an end with its own start, except the middle of a flat cap's side.
  const double here = rounding(view.eye, length);
  if (norm(view.eye) <= here && is_end(mesh_.origin(view.in))) return false;
  if (distance_between(view.eye, {length, 0}) <= here && is_end(mesh_.head(view.in))) return false;
  const double beside = std::max({view.begin - view.eye.x, view.eye.x - view.end, 0.0});
  const double nearest = norm(Point2{beside, view.eye.y});
  if (nearest > distance_ + slack_) return false;
  if (aim_ != kNone) return may_lead_to_aim(view, nearest);
  for (const bool head : {false, true}) {
    const Index v = head ? mesh_.head(view.in) : mesh_.origin(view.in);
    const double known = std::min(field_[v], field_.farthest());  // a lower bound
    if (known == kInfinity) continue;
    // The distance from the eye minus that from the vertex is least at the far end.
    const double far = head ? view.begin : view.end, from_vertex = head ? length - far : far;
    const double from_eye = distance_between(view.eye, {far, 0});
    if (known - from_vertex > distance_ - from_eye + slack_) return false;
  }
  return true;
}

/// Whether a line of the known length may lead through a view, judged by the way in space beyond.
/// @param nearest length from the eye to the view
bool PathSearch::may_lead_to_aim(const View& view, double nearest) const {
  const double length = mesh_.half_edge(view.in).length;
  const Vec3 &origin = mesh_.position(mesh_.origin(view.in)),
             &head = mesh_.position(mesh_.head(view.in));
  const Vec3 side = subtract(head, origin), to_aim = subtract(aim_position_, origin);
  const double along = dot(side, to_aim) / length;
  const double at = std::clamp(along, view.begin, view.end) / length;
  return nearest + norm(subtract(to_aim, scale(at, side))) <= to_aim_ + slack_;
}

/// Whether another view covers this one, or a line enters a face for the second time: around the
/// tip of needles, or among faces without area, lines continue without end, which no shortest path
/// does.
bool PathSearch::is_seen(const View& view) const {
  for (Index i = view.parent; i != kNone; i = views_[i].parent) {
    if (views_[i].in / 3 == view.in / 3) return true;
  }
  const auto others = views_of_.find(view.in);
  if (others == views_of_.end()) return false;
  const double slack = rounding(view.eye, mesh_.half_edge(view.in).length);
  return std::ranges::any_of(others->second, [&](Index i) {
    const View& other = views_[i];
    return distance_between(view.eye, other.eye) <= slack && view.begin >= other.begin - slack &&
           view.end <= other.end + slack;
  });
}

/// @param place, eye in the frame of the root's half-edge
void PathSearch::consider_vertex(Index v, const Point2& place, const Point2& eye, Root root) {
  const double distance = field_[v];
  if (distance > distance_ || !field_.may_bend(v)) return;
  // Vertices at the position of the end are skipped, except sources.
  if (is_end(v) && (end_.vertex == v || field_.source_at(v) == kNone)) return;
  if (std::ranges::find(passed_, v) != passed_.end()) return;
  root.root = v;
  root.at = InternalPoint(v);
  consider(root, distance, place, eye);
}

void PathSearch::consider_sources(const Point2& eye, Root root) {
  for (Index i = 0; i < field_.query().sources.size(); ++i) {
    for (const InternalPoint& source : field_.images(i)) {
      if (source.face != root.half_edge / 3) continue;
      const Point2 place = in_frame(mesh_, source, root.half_edge);
      if (root.view != kNone && (is_beside(i) || !shows(views_[root.view], place))) continue;
      root.root = mesh_.vertex_count() + i;
      root.at = field_.images(i).front();
      consider(root, field_.query().sources[i].distance, place, eye);
    }
  }
}

bool PathSearch::is_beside(Index source) const {
  return std::ranges::any_of(field_.images(source), [this](const InternalPoint& image) {
    return std::ranges::find(faces_, image.face) != faces_.end();
  });
}

bool PathSearch::shows(const View& view, const Point2& place) const {
  const double slack = rounding(view.eye, mesh_.half_edge(view.in).length);
  return to_begin(view, slack).across(place) <= slack &&
         to_end(view, slack).across(place) >= -slack;
}

void PathSearch::consider(Root root, double distance, const Point2& place, const Point2& eye) {
  if (aim_ != kNone && root.root != aim_) return;
  root.place = place;
  root.root_distance = distance;
  root.distance = distance + distance_between(place, eye);
  if (root.distance > best_.distance + tie_) return;
  const bool wins =
      root.distance < best_.distance - tie_ || root.root_distance < best_.root_distance;
  if (wins && is_straight(root)) best_ = root;
}

/// Whether the path through the edge points is as long as the straight line of the unfolded strip.
/// Rounding lets the line pass where the strip does not contain it: a view along a side shows all
/// of that side, and among faces without area a strip may turn back.
bool PathSearch::is_straight(const Root& root) const {
  const Piece piece = piece_from(root);
  double length = piece.root_distance + piece.rest;
  for (const EdgePoint& crossing : piece.edge_points) length += crossing.step;
  const double wrong = kPathWrong * (distance_ + mesh_.mean_edge_length());
  return length <= root.distance + std::min(slack_, wrong);
}

PathSearch::Piece PathSearch::piece_from(const Root& root) const {
  Piece piece{.root = root.root,
              .at = root.at,
              .half_edge = root.half_edge,
              .distance = root.distance,
              .root_distance = root.root_distance};
  if (root.root == kNone) return piece;
  for (Index i = root.end; i != kNone && ends_[i].previous != kNone; i = ends_[i].previous) {
    piece.ends.push_back(ends_[i]);
  }
  std::ranges::reverse(piece.ends);
  // From the root on, the line is aimed at the end again in every face.
  std::vector<Crossing> line;
  for (Index i = root.view; i != kNone; i = views_[i].parent) {
    line.push_back({&views_[i], views_[i].eye});
  }
  for (std::size_t i = 0, straight_from = 0; i < line.size(); ++i) {
    if (cross(line, i, root.place)) continue;
    // By rounding of the end's position, the line passes beside the edge. It leads straight to the
    // vertex there, whose position is exact, and from there on.
    line[i].aim = {line[i].x, 0};
    aim_at_last(std::span(line).subspan(straight_from, i + 1 - straight_from));
    for (std::size_t k = straight_from; k <= i; ++k) cross(line, k, root.place);
    straight_from = i + 1;
  }
  if (line.empty()) {
    piece.rest = root.distance - root.root_distance;
    return piece;
  }
  piece.rest = line.front().step;
  piece.edge_points.resize(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double step = i + 1 < line.size() ? line[i + 1].step
                                            : distance_between({line[i].x, 0}, line[i].view->eye);
    piece.edge_points[line.size() - 1 - i] = {line[i].view->side, line[i].x, step};
  }
  return piece;
}

bool PathSearch::cross(std::span<Crossing> line, std::size_t i, const Point2& start) const {
  Crossing& here = line[i];
  const Index in = here.view->in;
  const Point2 ahead = i == 0 ? start : position_beyond(line[i - 1], in);
  const double up = ahead.y - here.aim.y;
  const double x = up > 0 ? ahead.x - (ahead.x - here.aim.x) * (ahead.y / up) : ahead.x;
  here.x = std::clamp(x, 0.0, mesh_.half_edge(in).length);
  here.step = distance_between({here.x, 0}, ahead);
  return here.x == x;
}

Point2 PathSearch::position_beyond(const Crossing& crossing, Index in) const {
  const FaceFrame f = face_frame(mesh_, in);
  if (crossing.view->side == Mesh::previous(in)) {
    return {crossing.x * f.left_x, crossing.x * f.left_y};
  }
  const double u = f.right - crossing.x;
  return {f.length - u * f.right_x, -u * f.right_y};
}

void PathSearch::aim_at_last(std::span<Crossing> line) const {
  for (std::size_t i = line.size(); i-- > 1;) {
    const Point2& aim = line[i].aim;
    const Index in = line[i].view->in;
    const FaceFrame f = face_frame(mesh_, in);
    line[i - 1].aim = line[i - 1].view->side == Mesh::previous(in) ? f.to_left(aim.x, aim.y)
                                                                   : f.to_right(aim.x, aim.y);
  }
}

}  // namespace geodesic
