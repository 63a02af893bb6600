#include "solvers/core/solver.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "solvers/core/messages.h"

namespace geodesic {
namespace {

[[noreturn]] void refuse(const Description& solver, const std::string& why) {
  throw std::invalid_argument(solver.name + ": " + why);
}

void check_recording(const Recording& recording, const Description& solver) {
  if (recording.kind == RecordingKind::paths && !solver.abilities.paths) {
    refuse(solver, "does not remember how paths arrive");
  }
  if (recording.kind != RecordingKind::windows) return;
  if (!solver.final_windows) refuse(solver, "does not keep the windows of all edges");
  if (recording.read_windows == nullptr) refuse(solver, "Recording::read_windows is not set");
}

/// Leaves only what the caller sets.
void forget_results(Recording& recording) {
  Recording empty;
  empty.kind = recording.kind;
  empty.snapshots_at = std::move(recording.snapshots_at);
  empty.read_windows = recording.read_windows;
  empty.keeps_windows = recording.keeps_windows;
  recording = std::move(empty);
}

void check_point(const SurfacePoint& point, const char* kind, const Mesh& mesh,
                 const Description& solver) {
  const std::string defect = defect_of(mesh, point);
  if (!defect.empty()) refuse(solver, kind + defect);
}

void check_query(const Query& query, const Mesh& mesh, const Description& solver) {
  if (query.sources.empty()) refuse(solver, "a query needs at least one source");
  if (query.sources.size() > 1 && !solver.abilities.multiple_sources) {
    refuse(solver, "supports a single source only");
  }
  if (!(query.limit >= 0)) {
    refuse(solver, "the distance limit must be 0 or more, not " + significant(query.limit, 6));
  }
  if (query.limit < kInfinity && !solver.abilities.distance_limit) {
    refuse(solver, "supports no distance limit");
  }
  for (const SurfacePoint& target : query.targets) check_point(target, "target ", mesh, solver);
  if (query.stop_at_targets && query.targets.empty()) {
    refuse(solver, "a query without targets cannot stop at them");
  }
  for (const Source& source : query.sources) {
    check_point(source.at, "source ", mesh, solver);
    if (!source.at.is_vertex() && !solver.abilities.surface_sources) {
      refuse(solver, "supports sources at vertices only");
    }
    if (!(source.distance >= 0) || !std::isfinite(source.distance)) {
      refuse(solver, "an initial distance must be finite and not negative, not " +
                         significant(source.distance, 6));
    }
    if (source.distance > 0 && !solver.abilities.initial_distances) {
      refuse(solver, "supports no initial distances");
    }
  }
}

}  // namespace

double Description::real(std::string_view parameter) const {
  return CheckedParameters(name, parameters, values).real(parameter);
}

std::string Description::text(std::string_view parameter) const {
  return CheckedParameters(name, parameters, values).text(parameter);
}

int Description::thread_count() const {
  const auto named = std::ranges::find(parameters, "threads", &ParameterDescription::name);
  return named == parameters.end() ? threads : static_cast<int>(integer("threads"));
}

Solver::Solver(const Mesh& mesh, const Description& description)
    : mesh_(mesh), description_(description) {
  if (mesh.has_non_manifold_vertices() && !description.abilities.non_manifold_vertices) {
    refuse(description, "supports no vertices that several fans of faces share");
  }
  if (mesh.crosses_non_manifold_edges() && !description.abilities.non_manifold_edges) {
    refuse(description, "does not cross edges of more than two faces");
  }
  if (mesh.has_degenerate_faces() && !description.abilities.degenerate_faces) {
    refuse(description, "supports no faces with a zero-length edge or without area");
  }
}

void Solver::solve(const Query& query, std::span<double> distances, Recording* recording) {
  check_query(query, mesh_, description_);
  if (recording != nullptr) {
    check_recording(*recording, description_);
    if (recording->kind == RecordingKind::windows && mesh_.crosses_non_manifold_edges()) {
      refuse(description_, "hands over no windows where paths cross non-manifold edges");
    }
  }
  if (distances.size() != mesh_.vertex_count()) {
    refuse(description_, "needs room for one distance a vertex");
  }
  if (recording != nullptr) forget_results(*recording);
  renew();
  used_ = true;
  const Start start(mesh_, in_internal_numbers(mesh_, query));
  if (mesh_.numbers().is_identity()) return run_to_end(start, distances, recording);
  in_mesh_order_.resize(distances.size());
  run_to_end(start, in_mesh_order_, recording);
  for (Index v = 0; v < distances.size(); ++v) {
    distances[v] = in_mesh_order_[mesh_.numbers().internal_vertex(v)];
  }
}

void Solver::run_to_end(const Start& start, std::span<double> distances, Recording* recording) {
  std::ranges::fill(distances, kInfinity);
  if (recording == nullptr) {
    run(start, distances);
  } else {
    record(start, distances, *recording);
  }
  const InternalQuery& query = start.query;
  double farthest = StopRule(mesh_, query, distances).farthest();
  if (query.stop_at_targets && recording != nullptr && recording->kind == RecordingKind::paths) {
    double last = 0;
    for (const AtTarget& target : recording->targets) last = std::max(last, target.distance);
    farthest = std::min(query.limit, last);
  }
  for (double& d : distances) {
    if (d > farthest) d = kInfinity;
  }
}

Path Solver::trace(const Query& query, std::span<const double> distances, Index vertex) {
  if (!description_.abilities.traces) {
    refuse(description_, "has no means of its own to trace paths");
  }
  check_point(vertex, "target ", mesh_, description_);
  if (distances.size() != mesh_.vertex_count()) refuse(description_, "needs one distance a vertex");
  if (!(distances[vertex] < kInfinity)) {
    refuse(description_, "no path leads to vertex " + std::to_string(vertex));
  }
  const bool renumbered = !mesh_.numbers().is_identity();
  const InternalQuery own = in_internal_numbers(mesh_, query);
  return path_of_points(mesh_, own,
                        trace_path(own, renumbered ? in_mesh_order_ : distances,
                                   mesh_.numbers().internal_vertex(vertex)));
}

std::vector<InternalPoint> Solver::trace_path(const InternalQuery& /*query*/,
                                              std::span<const double> /*distances*/,
                                              Index /*vertex*/) {
  return {};
}

void Solver::renew() {
  if (used_ && description_.needs_renewal) renew_state();
  used_ = false;
}

}  // namespace geodesic
