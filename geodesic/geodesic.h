// Distances and shortest paths over a mesh, for programs that want nothing else:
//
//   const SurfaceMesh mesh = read_mesh("scan.ply");
//   DistanceSolver solver(mesh);
//   const Field field = solver.from({0, point_in_face(mesh, 7, {.2, .3, .5})});
//   const double distance = field[12];
//   const Path path = field.path_to(point_on_edge(mesh, 3, 7, .25));
//
// Vertices and faces go by the numbers of the file everywhere. Distances are in its unit of length.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <memory>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meshes/connectivity.h"
#include "meshes/load.h"
#include "meshes/point_solver.h"
#include "solvers/paths/paths.h"

namespace geodesic {

/// A mesh whose vertices and faces go by the numbers of its file. Solvers take it as a Mesh. The
/// functions of Mesh go by internal numbers: the order in memory with which solvers are fast.
class SurfaceMesh {
 public:
  /// @throws std::invalid_argument as Mesh
  SurfaceMesh(std::span<const Vec3> positions, std::span<const Triangle> triangles)
      : mesh_(positions, triangles, Numbering::along_surface) {}
  explicit SurfaceMesh(Mesh mesh) : mesh_(std::move(mesh)) {}

  Index vertex_count() const { return mesh_.vertex_count(); }
  Index face_count() const { return mesh_.given_face_count(); }
  /// Of a vertex, which is not checked.
  const Vec3& position(Index vertex) const {
    return mesh_.position(mesh_.numbers().internal_vertex(vertex));
  }
  /// Positions and triangles, copied.
  TriangleSoup soup() const { return soup_of(mesh_); }

  operator const Mesh&() const& { return mesh_; }  // NOLINT: it is one
  operator const Mesh&() && = delete;

 private:
  Mesh mesh_;
};

/// The mesh of a file. `build_mesh` returns the warnings as well.
/// @throws MeshError when the file cannot be read, or has errors and is not to be repaired
SurfaceMesh read_mesh(const std::filesystem::path& path, const LoadOptions& options = {});

struct FieldOptions {
  double limit = kInfinity;  ///< what is farther counts as unreachable
};

/// The distances from the nearest of some sources, and the paths that lead there. Constant: any
/// number of threads may ask. Copies share their memory.
class Field {
 public:
  /// One entry a vertex; infinite where no path leads within the limit.
  std::span<const double> distances() const;
  /// Of a vertex, which is not checked.
  double operator[](Index vertex) const { return distances()[vertex]; }

  /// Of any point, as exact as the solver. A vertex is looked up. Another point is searched from
  /// what the solve remembers, without another solve; by a solver without paths, a solve.
  /// @throws std::invalid_argument when the point is not of this mesh
  double at(const SurfacePoint& point) const;

  /// A shortest path from the nearest source to a vertex or a point, without another solve.
  /// @throws std::invalid_argument when the point is not of this mesh, no path leads there within
  ///         the limit, or the solver does not remember paths
  Path path_to(const SurfacePoint& point) const;

  /// The source that the path to a vertex comes from, by its place among the sources; kNone where
  /// no path leads. @throws std::invalid_argument as `path_to` otherwise
  Index nearest_source(Index vertex) const;

 private:
  friend class DistanceSolver;
  Field(std::string solver, const Mesh& mesh) : solver_(std::move(solver)), mesh_(&mesh) {}
  /// @throws std::invalid_argument when there are none
  const Paths& paths() const;

  std::string solver_;
  const Mesh* mesh_;
  std::shared_ptr<const Paths> paths_;  // null when the solver does not remember paths
  // Without paths:
  Query query_;
  std::shared_ptr<const std::vector<double>> distances_;
};

/// Solves for distances over one mesh. It keeps its memory from one call to the next, and belongs
/// to one thread at a time; any number of them share a mesh.
class DistanceSolver {
 public:
  /// @param mesh outlives this object and its fields
  /// @param solver a name with parameters, as of make_solver
  /// @throws std::invalid_argument for an unknown name, listing the known ones, and when the mesh
  ///         needs an ability that the solver lacks
  explicit DistanceSolver(const Mesh& mesh, std::string_view solver = "edge-based");

  /// From vertices and points, at least one. What paths need is recorded in the same solve.
  /// @throws std::invalid_argument when there is no source, one is not of this mesh, or the limit
  ///         is negative
  Field from(std::initializer_list<SurfacePoint> sources, const FieldOptions& options = {}) {
    return from(std::span(sources.begin(), sources.size()), options);
  }
  /// @param sources a range of vertices (Index), of SurfacePoint, or of Source, which has an
  /// initial
  ///        distance
  /// @throws as above, and for an initial distance that is negative or not finite
  template <std::ranges::input_range Sources>
  Field from(const Sources& sources, const FieldOptions& options = {}) {
    Query query{.sources = {}, .limit = options.limit};
    for (const auto& source : sources) query.sources.push_back(source_at(source));
    return solve(std::move(query));
  }

 private:
  static Source source_at(const SurfacePoint& point) { return {.at = point}; }
  static Source source_at(const Source& source) { return source; }
  Field solve(Query query);

  const Mesh& mesh_;
  const Description& description_;
  PointSolver solver_;
};

}  // namespace geodesic
