#include "geodesic/geodesic.h"

#include <algorithm>
#include <cstddef>
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

MeshFile file_of(TriangleSoup soup) {
  MeshFile file;
  file.soup = std::move(soup);
  return file;
}

/// With the option's name in C++, for messages.
LoadOptions named(LoadOptions options) {
  options.repair_option = "{.repair = true}";
  return options;
}

}  // namespace

SurfaceMesh::SurfaceMesh(TriangleSoup soup, const LoadOptions& options)
    : SurfaceMesh(std::shared_ptr<const Mesh>(
          build_mesh(file_of(std::move(soup)), "the triangles", named(options)).mesh)) {}

SurfaceMesh::SurfaceMesh(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                         const LoadOptions& options)
    : SurfaceMesh(
          TriangleSoup{{positions.begin(), positions.end()}, {triangles.begin(), triangles.end()}},
          options) {}

SurfaceMesh read_mesh(const std::filesystem::path& path, const LoadOptions& options) {
  return SurfaceMesh(std::shared_ptr<const Mesh>(build_mesh(path, named(options)).mesh));
}

std::span<const double> Field::distances() const& {
  return paths_ ? paths_->distances() : *distances_;
}

std::vector<double> Field::at(std::span<const SurfacePoint> points,
                              const BeforeSome& before_some) const {
  if (paths_) return paths_->distances_at(points, before_some);
  std::vector<double> found;
  for (const SurfacePoint& point : points) {
    const std::string defect = defect_of(*mesh_, point);
    if (!defect.empty()) throw std::invalid_argument(defect);
    found.push_back(point.is_vertex() ? (*distances_)[point.vertex] : kInfinity);
  }
  if (std::ranges::all_of(points, &SurfacePoint::is_vertex)) return found;
  if (before_some) before_some();
  Query query = query_;
  query.targets.assign(points.begin(), points.end());
  std::vector<double> all(distances_->size()), at_targets(points.size());
  solve_points(solver_, *mesh_, query, all, at_targets);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].is_vertex()) found[i] = at_targets[i];
  }
  return found;
}

Path Field::path_to(const SurfacePoint& point) const { return paths().to_point(point); }

std::optional<Path> Field::find_path_to(const SurfacePoint& point) const {
  return paths().find_to_point(point);
}

std::vector<Index> Field::nearest_sources() const { return paths().nearest_sources(); }

std::vector<Index> Field::nearest_sources(std::span<const SurfacePoint> points,
                                          const BeforeSome& before_some) const {
  return paths().nearest_sources_at(points, before_some);
}

std::vector<Vec3> Field::gradients(std::span<const SurfacePoint> points,
                                   const BeforeSome& before_some) const {
  return paths().gradients_at(points, before_some);
}

const Paths& Field::paths() const {
  if (!paths_) {
    throw std::invalid_argument(
        solver_ + " does not remember paths: take another solver, such as edge-based");
  }
  return *paths_;
}

DistanceSolver::DistanceSolver(const SurfaceMesh& mesh, std::string_view solver)
    : mesh_(mesh.shared()), solver_(solver, *mesh_) {}

// The pointer shares nothing: it does not own the mesh.
DistanceSolver::DistanceSolver(const Mesh& mesh, std::string_view solver)
    : DistanceSolver(SurfaceMesh(std::shared_ptr<const Mesh>(std::shared_ptr<void>(), &mesh)),
                     solver) {}

Field solve_field(PointSolver& solver, std::shared_ptr<const Mesh> shared, Query query,
                  bool anywhere) {
  const Mesh& mesh = *shared;
  const Description& description = solver.solver().description();
  Field field(description.name, std::move(shared));
  if (description.abilities.paths) {
    field.paths_ =
        std::make_shared<const Paths>(solve_paths(solver.solver(), mesh, query, anywhere));
    return field;
  }
  std::vector<double> distances(mesh.vertex_count());
  if (std::ranges::all_of(query.sources, [](const Source& s) { return s.at.is_vertex(); })) {
    solver.solve(query, distances, {});
  } else {
    solve_points(description.name, mesh, query, distances, {});
  }
  field.query_ = std::move(query);
  field.distances_ = std::make_shared<const std::vector<double>>(std::move(distances));
  return field;
}

}  // namespace geodesic
