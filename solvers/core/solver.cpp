#include "solvers/core/solver.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace geodesic {
namespace {

[[noreturn]] void refuse(const Description& solver, const std::string& why) {
  throw std::invalid_argument(solver.name + ": " + why);
}

void check_recording(const Recording& recording, const Description& solver) {
  if (recording.what != Record::windows) return;
  if (!solver.final_windows) refuse(solver, "does not keep the windows of all edges");
  if (recording.read_windows == nullptr) refuse(solver, "Recording::read_windows is not set");
}

void check_query(const Query& query, const Mesh& mesh, const Description& solver) {
  if (query.sources.empty()) refuse(solver, "a query needs at least one source");
  if (query.sources.size() > 1 && !solver.abilities.multiple_sources) {
    refuse(solver, "supports a single source only");
  }
  if (!(query.limit >= 0)) refuse(solver, "the distance limit must not be negative");
  if (query.limit < kInfinity && !solver.abilities.distance_limit) {
    refuse(solver, "supports no distance limit");
  }
  for (const Source& source : query.sources) {
    if (source.vertex >= mesh.vertex_count()) {
      refuse(solver, "source vertex " + std::to_string(source.vertex) + " is not in the mesh of " +
                         std::to_string(mesh.vertex_count()) + " vertices");
    }
    if (!(source.distance >= 0) || !std::isfinite(source.distance)) {
      refuse(solver, "an initial distance must be finite and not negative");
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
  if (mesh.has_degenerate_faces() && !description.abilities.degenerate_faces) {
    refuse(description, "supports no faces with a zero-length edge or without area");
  }
}

void Solver::solve(const Query& query, std::span<double> distances, Recording* recording) {
  check_query(query, mesh_, description_);
  if (recording != nullptr) check_recording(*recording, description_);
  if (distances.size() != mesh_.vertex_count()) {
    refuse(description_, "needs room for one distance a vertex");
  }
  renew();
  used_ = true;
  if (!mesh_.numbers().are_given()) {
    solve_renumbered(query, distances, recording);
  } else {
    std::fill(distances.begin(), distances.end(), kInfinity);
    run(query, distances, recording);
  }
  for (double& d : distances) {
    if (d > query.limit) d = kInfinity;
  }
}

void Solver::renew() {
  if (used_ && description_.needs_renewal) renew_state();
  used_ = false;
}

void Solver::solve_renumbered(Query query, std::span<double> distances, Recording* recording) {
  for (Source& source : query.sources) source.vertex = mesh_.numbers().own_vertex(source.vertex);
  in_mesh_order_.assign(distances.size(), kInfinity);
  run(query, in_mesh_order_, recording);
  for (Index v = 0; v < distances.size(); ++v)
    distances[mesh_.numbers().given_vertex(v)] = in_mesh_order_[v];
}

}  // namespace geodesic
