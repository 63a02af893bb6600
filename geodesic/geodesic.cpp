#include "geodesic/geodesic.h"

#include <algorithm>
#include <stdexcept>

namespace geodesic {
namespace {

/// Solves with a PointSolver, because a solver without paths may not accept points inside faces.
void solve_points(std::string_view solver, const Mesh& mesh, const Query& query,
                  std::span<double> distances, std::span<double> at_targets) {
  std::vector<SurfacePoint> sources;
  for (const Source& source : query.sources) sources.push_back(source.at);
  PointSolver(solver, mesh, sources, query.targets).solve(query, distances, at_targets);
}

}  // namespace

SurfaceMesh read_mesh(const std::filesystem::path& path, const LoadOptions& options) {
  return SurfaceMesh(std::move(*build_mesh(path, options).mesh));
}

std::span<const double> Field::distances() const& {
  return paths_ ? paths_->distances() : *distances_;
}

double Field::at(const SurfacePoint& point) const {
  if (paths_) return paths_->distance_at(point);
  const std::string defect = defect_of(*mesh_, point);
  if (!defect.empty()) throw std::invalid_argument(defect);
  if (point.is_vertex()) return (*distances_)[point.vertex];
  Query query = query_;
  query.targets = {point};
  std::vector<double> all(distances_->size());
  double distance = kInfinity;
  solve_points(solver_, *mesh_, query, all, {&distance, 1});
  return distance;
}

Path Field::path_to(const SurfacePoint& point) const { return paths().to_point(point); }

Index Field::nearest_source(Index vertex) const { return paths().nearest_source(vertex); }

const Paths& Field::paths() const {
  if (!paths_) throw std::invalid_argument(solver_ + " does not remember paths");
  return *paths_;
}

DistanceSolver::DistanceSolver(const Mesh& mesh, std::string_view solver)
    : mesh_(mesh), description_(solver_named(solver)), solver_(solver, mesh) {}

Field DistanceSolver::solve(Query query) {
  Field field(description_.name, mesh_);
  if (description_.abilities.paths) {
    field.paths_ = std::make_shared<const Paths>(solve_paths(solver_.solver(), mesh_, query));
    return field;
  }
  std::vector<double> distances(mesh_.vertex_count());
  if (std::ranges::all_of(query.sources, [](const Source& s) { return s.at.is_vertex(); })) {
    solver_.solve(query, distances, {});
  } else {
    solve_points(description_.name, mesh_, query, distances, {});
  }
  field.query_ = std::move(query);
  field.distances_ = std::make_shared<const std::vector<double>>(std::move(distances));
  return field;
}

}  // namespace geodesic
