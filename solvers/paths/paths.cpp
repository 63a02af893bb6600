#include "solvers/paths/paths.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

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

}  // namespace

Paths::Paths(const Mesh& mesh, const Query& query, std::vector<double> distances,
             Recording recording)
    : field_(mesh, query, std::move(distances), recording.shortest_paths,
             farthest_of(query, recording)),
      last_segments_(std::move(recording.last_segments)),
      targets_(std::move(recording.targets)) {
  const std::size_t vertices = mesh.vertex_count();
  if (recording.kind != RecordingKind::paths || last_segments_.size() != vertices ||
      this->distances().size() != vertices || targets_.size() != query.targets.size()) {
    throw std::invalid_argument("paths need a recording of paths, of this mesh and query");
  }
}

Index Paths::internal_vertex(Index given) const {
  const std::string defect = defect_of(field_.mesh(), SurfacePoint(given));
  if (!defect.empty()) throw std::invalid_argument(defect);
  return field_.mesh().numbers().internal_vertex(given);
}

double Paths::distance_at(const SurfacePoint& point) const {
  const std::string defect = defect_of(field_.mesh(), point);
  if (!defect.empty()) throw std::invalid_argument(defect);
  if (point.is_vertex()) return distances()[point.vertex];
  return PathSearch::from_face(field_, in_internal_numbers(field_.mesh(), point)).distance;
}

std::optional<Path> Paths::find_to_point(const SurfacePoint& point) const {
  const std::string defect = defect_of(field_.mesh(), point);
  if (!defect.empty()) throw std::invalid_argument(defect);
  const InternalPoint own = in_internal_numbers(field_.mesh(), point);
  if (point.is_vertex()) {
    const double distance = distances()[point.vertex];
    if (distance == kInfinity) return std::nullopt;
    return trace_path(field_, last_segments_, own, distance, last_segments_[own.vertex]);
  }
  const PathSearch::Piece last = PathSearch::from_face(field_, own);
  if (last.distance == kInfinity) return std::nullopt;
  return trace_path(field_, last_segments_, own, last.distance, {}, &last);
}

Path Paths::to_point(const SurfacePoint& point) const {
  std::optional<Path> found = find_to_point(point);  // which checks the point
  return required(std::move(found), field_.mesh(), in_internal_numbers(field_.mesh(), point));
}

std::optional<Path> Paths::find_to_target(std::size_t i) const {
  const AtTarget& target = targets_.at(i);
  if (target.distance == kInfinity) return std::nullopt;
  return trace_path(field_, last_segments_, field_.query().targets[i], target.distance,
                    target.last_segment);
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

Index Paths::nearest_source(Index v) const {
  Index at = internal_vertex(v);
  if (distances()[v] == kInfinity) return kNone;
  for (Index bends = 0; bends <= field_.mesh().vertex_count(); ++bends) {
    if (const auto source = source_here(at)) return *source;
    at = last_segments_[at].root;
  }
  throw std::runtime_error(kRoundabout);
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

Paths solve_paths(Solver& solver, const Mesh& mesh, const Query& query) {
  std::vector<double> distances(mesh.vertex_count());
  Recording recording;
  recording.kind = RecordingKind::paths;
  solver.solve(query, distances, &recording);
  return {mesh, query, std::move(distances), std::move(recording)};
}

}  // namespace geodesic
