// Distances and shortest paths over a mesh, for programs that need only these:
//
//   const SurfaceMesh mesh = read_mesh("scan.ply");
//   DistanceSolver solver(mesh);
//   const Field field = solver.from({0, point_in_face(mesh, 7, {.2, .3, .5})});
//   const double distance = field[12];
//   const Path path = field.path_to(point_on_edge(mesh, 3, 7, .25));
//   const Path loop = solver.path_through({0, 12, 40}, {.closed = true, .straighten = true});
//   const std::vector<double> of_pairs = pair_distances(mesh, pairs);   // a vector of PointPair
//
// All vertex and face numbers are those of the file. Distances have its unit of length.
#pragma once

#include <concepts>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <ranges>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meshes/connectivity.h"
#include "meshes/field_file.h"
#include "meshes/isolines.h"
#include "meshes/load.h"
#include "meshes/pair_distances.h"
#include "meshes/point_solver.h"
#include "solvers/paths/paths.h"
#include "solvers/paths/straightest.h"
#include "solvers/paths/through.h"

namespace geodesic {

/// A mesh with the vertex and face numbers of its file. It converts to Mesh, the type that solvers
/// take. Mesh's functions use internal numbers: the order in memory with which solvers are fast.
/// The mesh is constant: copies share it, also with solvers and fields.
class SurfaceMesh {
 public:
  /// Checks the triangles as `read_mesh` does those of a file: a mesh on which distances would be
  /// meaningless is refused, or repaired. Without warnings, which `build_mesh` returns.
  /// @throws MeshError for the reasons of load_mesh
  explicit SurfaceMesh(TriangleSoup soup, const LoadOptions& options = {});
  SurfaceMesh(std::span<const Vec3> positions, std::span<const Triangle> triangles,
              const LoadOptions& options = {});
  /// Without a check.
  explicit SurfaceMesh(Mesh mesh) : SurfaceMesh(std::make_shared<const Mesh>(std::move(mesh))) {}
  /// @param mesh not null
  explicit SurfaceMesh(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {}

  Index vertex_count() const { return mesh_->vertex_count(); }
  Index face_count() const { return mesh_->external_face_count(); }
  /// Position of a vertex, whose number is not checked.
  Vec3 position(Index vertex) const {
    return mesh_->position(mesh_->numbers().internal_vertex(vertex));
  }
  /// Copies of the positions and triangles.
  TriangleSoup soup() const { return soup_of(*mesh_); }

  const std::shared_ptr<const Mesh>& shared() const { return mesh_; }
  operator const Mesh&() const& { return *mesh_; }  // NOLINT: it is one
  operator const Mesh&() const&& = delete;

 private:
  std::shared_ptr<const Mesh> mesh_;
};

/// Reads the mesh of a file. `build_mesh` returns the warnings as well.
/// @throws MeshError when the file cannot be read, or when it has errors and is not to be repaired
SurfaceMesh read_mesh(const std::filesystem::path& path, const LoadOptions& options = {});

struct FieldOptions {
  double limit = kInfinity;  ///< points farther away count as unreachable
  /// Keeps the windows of the solve, in about 2 kB a vertex: the distance of any point then takes a
  /// microsecond, as do its gradient and the beginning of its path. Of solvers that propagate
  /// windows; ignored by others.
  bool anywhere = false;
};

/// The distances from the nearest of some sources, and the paths from it. Immutable: any number of
/// threads may use it. Copies share their memory. A field keeps its mesh.
class Field {
 public:
  /// One distance for each vertex; infinite where no path within the limit exists. They belong to
  /// the field, which must have a name: `for (double d : solver.from({0}).distances())` would read
  /// them after their end.
  std::span<const double> distances() const&;
  std::span<const double> distances() const&& = delete;
  /// Distance of a vertex, whose number is not checked.
  double operator[](Index vertex) const { return distances()[vertex]; }

  /// Distance of any point, as exact as the solver. For a vertex it is looked up. For other points
  /// it takes a microsecond with FieldOptions::anywhere; otherwise the data of the solve are
  /// searched, for milliseconds. A solver that does not remember paths solves again.
  /// @throws std::invalid_argument when the point is not of this mesh
  double at(const SurfacePoint& point) const { return at(std::span(&point, 1)).front(); }
  /// Distances of several points, as above; a solver that does not remember paths solves once.
  /// @param before_some called before each search or solve, or before every 1,000 points or so
  std::vector<double> at(std::span<const SurfacePoint> points,
                         const BeforeSome& before_some = {}) const;
  /// The gradient of the distance: a vector of length 1 in the plane of a face, in which the
  /// shortest path arrives at the point. It is not a number at a source and where no path leads.
  /// @throws std::invalid_argument when the point is not of this mesh, the solver does not remember
  ///         paths, or the point is no vertex and FieldOptions::anywhere was not set
  Vec3 gradient(const SurfacePoint& point) const { return paths().gradient_at(point); }
  /// Those of several points, in the order that is fastest, as `at`.
  std::vector<Vec3> gradients(std::span<const SurfacePoint> points,
                              const BeforeSome& before_some = {}) const;

  /// A shortest path from the nearest source to a vertex or a point, without another solve.
  /// @throws std::invalid_argument when the point is not of this mesh, no path leads there within
  ///         the limit, or the solver does not remember paths
  Path path_to(const SurfacePoint& point) const;
  /// As path_to; nullopt where no path leads.
  std::optional<Path> find_path_to(const SurfacePoint& point) const;

  /// The source of the path to a vertex or a point, as an index into the sources; kNone where no
  /// path leads.
  /// @throws std::invalid_argument for the other reasons of `path_to`
  Index nearest_source(const SurfacePoint& point) const { return paths().nearest_source(point); }
  /// Those of several points, in the order that is fastest, as `at`.
  std::vector<Index> nearest_sources(std::span<const SurfacePoint> points,
                                     const BeforeSome& before_some = {}) const;
  /// Those of all vertices, in linear time.
  std::vector<Index> nearest_sources() const;

  /// The lines of equal distance, interpolated linearly along the edges: meshes/isolines.h. Ten
  /// levels: `field.isolines(field.levels(10))`.
  /// @throws std::invalid_argument for a level that is no finite distance above 0
  std::vector<Isoline> isolines(const std::vector<double>& levels) const {
    return geodesic::isolines(*mesh_, distances(), levels);
  }
  /// The bytes of a file with the mesh and the distances, for programs that show them:
  /// meshes/field_file.h. @throws MeshError for another extension than .ply and .vtk
  std::string file_bytes(const std::filesystem::path& file) const {
    return field_bytes(soup_of(*mesh_), distances(), {}, file);
  }

  /// Polar coordinates of every vertex around its nearest source: solvers/paths/straightest.h.
  /// @throws std::invalid_argument when the solver does not remember paths, and as log_map
  std::vector<PolarCoordinates> log_map() const { return geodesic::log_map(paths()); }
  /// `count` levels between 0 and the largest finite distance: `equal_levels`.
  std::vector<double> levels(Index count) const { return equal_levels(distances(), count); }

 private:
  friend Field solve_field(PointSolver& solver, std::shared_ptr<const Mesh> mesh, Query query,
                           bool anywhere);
  Field(std::string solver, std::shared_ptr<const Mesh> mesh)
      : solver_(std::move(solver)), mesh_(std::move(mesh)) {}
  /// @throws std::invalid_argument when the solver does not remember paths
  const Paths& paths() const;

  std::string solver_;
  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const Paths> paths_;  // null when the solver does not remember paths
  // Used only when the solver does not remember paths:
  Query query_;
  std::shared_ptr<const std::vector<double>> distances_;
};

/// Solves a query without targets with a solver that the caller keeps, as DistanceSolver does.
/// @param solver a solver on this mesh, without inserted points
/// @param anywhere as FieldOptions::anywhere
/// @throws std::invalid_argument for the reasons of DistanceSolver::from
Field solve_field(PointSolver& solver, std::shared_ptr<const Mesh> mesh, Query query,
                  bool anywhere);

/// Computes distances on one mesh. It keeps its memory from one call to the next and must be used
/// by one thread at a time. Any number of solvers may share a mesh. It may be moved.
class DistanceSolver {
 public:
  /// Shares the mesh with its fields: none of them need outlive another.
  /// @param solver a name with parameters, as in make_solver
  /// @throws std::invalid_argument for an unknown name (the message lists the known ones), and when
  ///         the mesh needs an ability that the solver lacks
  explicit DistanceSolver(const SurfaceMesh& mesh, std::string_view solver = "edge-based");
  /// As above, for a mesh of the program's own.
  /// @param mesh must outlive this object and its fields, and stay where it is
  explicit DistanceSolver(const Mesh& mesh, std::string_view solver = "edge-based");
  explicit DistanceSolver(const Mesh&& mesh, std::string_view solver = "edge-based") = delete;

  /// Distances from vertices and points, at least one. The same solve records the data for paths.
  /// @throws std::invalid_argument when there is no source, one is not of this mesh, or the limit
  ///         is negative
  Field from(std::initializer_list<SurfacePoint> sources, const FieldOptions& options = {}) {
    return from(std::span(sources.begin(), sources.size()), options);
  }
  /// Distances from one vertex or point.
  Field from(const SurfacePoint& source, const FieldOptions& options = {}) {
    return from(std::span(&source, 1), options);
  }
  /// Distances from sources with initial distances: `from({{.at = 0, .distance = 0.5}, {.at =
  /// 7}})`. A template, so that a list of vertices or points prefers the function above.
  /// @throws as above, and for an initial distance that is negative or not finite
  template <std::same_as<Source> S = Source>
  Field from(std::initializer_list<S> sources, const FieldOptions& options = {}) {
    return from(std::span(sources.begin(), sources.size()), options);
  }
  /// @param sources a range of vertices (of any type of integers), of SurfacePoint, or of Source
  /// @throws as above
  template <std::ranges::input_range Sources>
  Field from(Sources&& sources, const FieldOptions& options = {}) {
    Query query{.sources = {}, .limit = options.limit};
    for (const auto& source : sources) query.sources.push_back(source_at(source));
    return solve_field(solver_, mesh_, std::move(query), options.anywhere);
  }

  /// The shortest paths between successive points, joined, or the locally shortest curve in their
  /// class: solvers/paths/through.h.
  /// @throws std::invalid_argument for the reasons named there, and when the solver does not
  /// remember
  ///         paths
  Path path_through(std::initializer_list<SurfacePoint> points,
                    const ThroughOptions& options = {}) {
    return path_through(std::span(points.begin(), points.size()), options);
  }
  /// @param points a range of vertices (of any type of integers) or of SurfacePoint
  /// @throws as above
  template <std::ranges::input_range Points>
  Path path_through(Points&& points, const ThroughOptions& options = {}) {
    std::vector<SurfacePoint> all;
    for (const auto& point : points) all.push_back(point_at(point, ""));
    return geodesic::path_through(solver_.solver(), *mesh_, all, options);
  }

 private:
  static Source source_at(const Source& source) { return source; }
  Source source_at(const auto& point) const { return {.at = point_at(point, "source ")}; }

  /// @param kind begins the message
  static SurfacePoint point_at(const SurfacePoint& point, const char* /*kind*/) { return point; }
  SurfacePoint point_at(std::integral auto vertex, const char* kind) const {
    if (!std::in_range<Index>(vertex)) {
      throw std::invalid_argument(kind + ("vertex " + std::to_string(vertex)) +
                                  " is not in the mesh of " +
                                  std::to_string(mesh_->vertex_count()) + " vertices");
    }
    return static_cast<Index>(vertex);
  }

  std::shared_ptr<const Mesh> mesh_;
  PointSolver solver_;
};

}  // namespace geodesic
