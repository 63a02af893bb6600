#include "solvers/paths/paths.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "solvers/core/prefetch.h"
#include "solvers/paths/trace.h"

namespace geodesic {
namespace {

constexpr const char* kRoundabout =
    "the paths that the solver remembers come from no source; please report this mesh and query";

Path required(std::optional<Path> found, const Mesh& mesh, const InternalPoint& target) {
  if (!found) throw std::invalid_argument("no path leads to " + name_of(mesh, target));
  return *std::move(found);
}

/// Distance beyond which vertices have none.
double farthest_of(const Query& query, const Recording& recording) {
  if (!query.stop_at_targets || recording.targets.empty()) return query.limit;
  return std::min(query.limit,
                  std::ranges::max(recording.targets, {}, &AtTarget::distance).distance);
}

/// The vector, in space, of the part of a path's last piece that lies in the face of its end.
/// @param end the last piece's; if it is no vertex, in some face
Vec3 direction_of(const Mesh& mesh, const LastSegment& last, const InternalPoint& end) {
  const HalfEdge& e = mesh.half_edge(last.half_edge);
  Point2 at = {e.apex_x, e.apex_y};
  if (!end.is_vertex()) {
    for (const InternalPoint& image : in_every_face(mesh, end)) {
      if (image.face == last.half_edge / 3) at = in_frame(mesh, image, last.half_edge);
    }
  }
  const Vec3& origin = mesh.position(e.origin);
  const Vec3 along =
      scale(1 / e.length, subtract(mesh.position(mesh.head(last.half_edge)), origin));
  const Vec3 to_apex = subtract(mesh.position(mesh.apex(last.half_edge)), origin);
  // In a face without area, paths lead along the edge.
  const Vec3 up =
      e.apex_y > 0 ? scale(1 / e.apex_y, subtract(to_apex, scale(e.apex_x, along))) : Vec3{};
  return add(scale(at.x - last.from.x, along), scale(at.y - last.from.y, up));
}

}  // namespace

Paths::Paths(const Mesh& mesh, const Query& query, std::vector<double> distances,
             Recording recording)
    : field_(mesh, query, std::move(distances), recording.shortest_paths,
             farthest_of(query, recording)),
      last_segments_(std::move(recording.last_segments)),
      targets_(std::move(recording.targets)),
      windows_(std::move(recording.face_windows)) {
  const std::size_t vertices = mesh.vertex_count();
  if (recording.kind != RecordingKind::paths || last_segments_.size() != vertices ||
      this->distances().size() != vertices || targets_.size() != query.targets.size()) {
    throw std::invalid_argument("paths need a recording of paths, of this mesh and query");
  }
}

InternalPoint Paths::checked(const SurfacePoint& point) const {
  const std::string defect = defect_of(field_.mesh(), point);
  if (!defect.empty()) throw std::invalid_argument(defect);
  return in_internal_numbers(field_.mesh(), point);
}

AtTarget Paths::at(const InternalPoint& point) const {
  const AtTarget found = windows_->nearest(point);
  return found.distance <= field_.farthest() ? found : AtTarget{};
}

double Paths::distance_at(const SurfacePoint& point) const {
  const InternalPoint own = checked(point);
  if (point.is_vertex()) return distances()[point.vertex];
  return windows_ ? at(own).distance : PathSearch::from_face(field_, own).distance;
}

template <typename Answer>
auto Paths::for_each(std::span<const SurfacePoint> points, const BeforeSome& before_some,
                     Answer answer) const {
  constexpr std::size_t kSome = 1024, kAhead = 16;
  std::vector<std::pair<Index, std::size_t>> order;  // by face
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) order.emplace_back(points[i].face, i);
  if (windows_) std::ranges::sort(order);
  std::vector<decltype(answer(points[0]))> found(points.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    if (before_some && (!windows_ || n % kSome == 0)) before_some();
    if (n + kAhead < order.size()) prefetch(&points[order[n + kAhead].second]);
    const std::size_t i = order[n].second;
    found[i] = answer(points[i]);
  }
  return found;
}

std::vector<double> Paths::distances_at(std::span<const SurfacePoint> points,
                                        const BeforeSome& before_some) const {
  return for_each(points, before_some, [&](const SurfacePoint& p) { return distance_at(p); });
}

Vec3 Paths::gradient_at(const SurfacePoint& point) const {
  const Mesh& mesh = field_.mesh();
  InternalPoint end = checked(point);
  if (!end.is_vertex() && !windows_) {
    throw std::invalid_argument(
        "the gradient at a point that is no vertex needs a solve with anywhere=True (in C++ "
        "FieldOptions::anywhere) by a solver that propagates windows, such as edge-based");
  }
  LastSegment last = end.is_vertex() ? last_segments_[end.vertex] : at(end).last_segment;
  Vec3 direction{};
  for (Index pieces = 0; last.half_edge != kNone && pieces <= mesh.vertex_count(); ++pieces) {
    direction = direction_of(mesh, last, end);
    if (norm(direction) > 0 || last.root >= mesh.vertex_count()) break;
    // The root of this piece, at the place of the end, continues the path.
    end = InternalPoint(last.root);
    last = last_segments_[last.root];
  }
  return scale(1 / norm(direction), direction);  // not a number for 0
}

std::vector<Vec3> Paths::gradients_at(std::span<const SurfacePoint> points,
                                      const BeforeSome& before_some) const {
  return for_each(points, before_some, [&](const SurfacePoint& p) { return gradient_at(p); });
}

std::optional<Path> Paths::find_to_point(const SurfacePoint& point) const {
  const InternalPoint own = checked(point);
  if (point.is_vertex() || windows_) {
    const AtTarget end = point.is_vertex()
                             ? AtTarget{distances()[point.vertex], last_segments_[own.vertex]}
                             : at(own);
    if (end.distance == kInfinity) return std::nullopt;
    return trace_path(field_, last_segments_, own, end.distance, end.last_segment);
  }
  const PathSearch::Piece last = PathSearch::from_face(field_, own);
  if (last.distance == kInfinity) return std::nullopt;
  return trace_path(field_, last_segments_, own, last.distance, {}, &last);
}

Path Paths::to_point(const SurfacePoint& point) const {
  std::optional<Path> found = find_to_point(point);  // which checks the point
  return required(std::move(found), field_.mesh(), in_internal_numbers(field_.mesh(), point));
}

const AtTarget& Paths::target(std::size_t i) const {
  if (i < targets_.size()) return targets_[i];
  throw std::invalid_argument("target " + std::to_string(i) + " is not in the query of " +
                              std::to_string(targets_.size()) + " targets");
}

std::optional<Path> Paths::find_to_target(std::size_t i) const {
  const AtTarget& wanted = target(i);
  if (wanted.distance == kInfinity) return std::nullopt;
  return trace_path(field_, last_segments_, field_.query().targets[i], wanted.distance,
                    wanted.last_segment);
}

Path Paths::to_target(std::size_t i) const {
  return required(find_to_target(i), field_.mesh(), field_.query().targets[i]);
}

std::optional<Index> Paths::source_here(Index v) const {
  const Index root = last_segments_[v].root, vertices = field_.mesh().vertex_count();
  if (root == kNone) return kNone;
  if (root >= vertices) return root - vertices;
  if (root != v) return std::nullopt;
  return field_.source_at(v);
}

Index Paths::nearest_source(const SurfacePoint& point) const {
  const InternalPoint end = checked(point);
  const Index vertices = field_.mesh().vertex_count();
  Index root = end.vertex;
  if (windows_ && !end.is_vertex()) {
    root = at(end).last_segment.root;
  } else if (!end.is_vertex()) {
    const PathSearch::Piece last = PathSearch::from_face(field_, end);
    root = last.distance < kInfinity ? last.root : kNone;
  }
  for (Index bends = 0; bends <= vertices; ++bends) {
    if (root == kNone || (root < vertices && field_[root] == kInfinity)) return kNone;
    if (root >= vertices) return root - vertices;
    if (const auto source = source_here(root)) return *source;
    root = last_segments_[root].root;
  }
  throw std::runtime_error(kRoundabout);
}

std::vector<Index> Paths::nearest_sources_at(std::span<const SurfacePoint> points,
                                             const BeforeSome& before_some) const {
  return for_each(points, before_some, [&](const SurfacePoint& p) { return nearest_source(p); });
}

std::vector<Index> Paths::nearest_sources() const {
  const Index vertices = field_.mesh().vertex_count();
  std::vector<std::optional<Index>> nearest(vertices);
  std::vector<Index> given(vertices, kNone), chain;
  for (Index v = 0; v < vertices; ++v) {
    if (distances()[v] == kInfinity) continue;
    const Index own = field_.mesh().numbers().internal_vertex(v);
    Index at = own;
    while (!nearest[at] && !(nearest[at] = source_here(at))) {
      if (chain.size() > vertices) throw std::runtime_error(kRoundabout);
      chain.push_back(at);
      at = last_segments_[at].root;
    }
    for (const Index each : chain) nearest[each] = nearest[at];
    chain.clear();
    given[v] = *nearest[own];
  }
  return given;
}

Paths solve_paths(Solver& solver, const Mesh& mesh, const Query& query, bool keeps_windows) {
  std::vector<double> distances(mesh.vertex_count());
  Recording recording;
  recording.kind = RecordingKind::paths;
  recording.keeps_windows = keeps_windows;
  solver.solve(query, distances, &recording);
  return {mesh, query, std::move(distances), std::move(recording)};
}

}  // namespace geodesic
