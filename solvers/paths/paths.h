// Shortest paths of one solve, traced over the faces from Recording::last_segments.
//
// A path is a chain of straight pieces that bend at vertices (Mitchell, Mount, Papadimitriou 1987,
// section 3). The recording stores the last piece of the path to each vertex: its root, unfolded
// into the face in which the piece ends. The line to the root is followed from face to face, and
// the last piece of the root's own path continues it. Vertices and faces have external numbers.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solvers/core/face_windows.h"
#include "solvers/core/solver.h"
#include "solvers/paths/distance_field.h"

namespace geodesic {

/// Called between the answers for many points; may throw to end the call.
using BeforeSome = std::function<void()>;

/// The paths of one solve, in 32 bytes per vertex including the distances, and the windows if the
/// recording kept them (core/face_windows.h). The object is constant: any number of threads may use
/// it.
class Paths {
 public:
  /// @param mesh must outlive this object
  /// @param query the query that was solved
  /// @param distances the distances of the solve, one per vertex
  /// @param recording the recording of the solve, with RecordingKind::paths
  /// @throws std::invalid_argument if the recording has no paths or is of another query or mesh
  Paths(const Mesh& mesh, const Query& query, std::vector<double> distances, Recording recording);

  const Mesh& mesh() const { return field_.mesh(); }
  /// Distances of all vertices, as from Solver::solve.
  const std::vector<double>& distances() const& { return field_.by_external_number(); }
  const std::vector<double>& distances() const&& = delete;
  /// Distance of the query's target i, as exact as those of the vertices; infinite if unreachable.
  /// @throws std::invalid_argument if the query has no such target
  double distance_to_target(std::size_t i) const { return target(i).distance; }
  /// Distance of any point, without another solve; infinite if no path within the query's limit
  /// exists. It is as exact as the distances of the vertices. With kept windows it takes a
  /// microsecond. Without them the path is searched from its end, over the faces around it, and
  /// upper bounds give that of a path that goes straight on from some vertex (search.h).
  /// @throws std::invalid_argument if the point is not on this mesh
  double distance_at(const SurfacePoint& point) const;
  /// As distance_at, of many points; with kept windows the points of a face follow each other, so
  /// that its windows are read once.
  /// @param before_some called before each search, or before every 1,000 points or so
  std::vector<double> distances_at(std::span<const SurfacePoint> points,
                                   const BeforeSome& before_some = {}) const;
  /// The gradient of the distance at a point, in space: the direction of length 1 in which the
  /// shortest path arrives, in the plane of the face in which it ends. It is not a number where no
  /// path leads and at a source.
  /// @throws std::invalid_argument if the point is not on this mesh, or if it is not a vertex and
  ///         no windows were kept
  Vec3 gradient_at(const SurfacePoint& point) const;
  /// As gradient_at, of many points, as distances_at.
  std::vector<Vec3> gradients_at(std::span<const SurfacePoint> points,
                                 const BeforeSome& before_some = {}) const;

  /// Returns the path to a vertex, in time linear in the number of faces that it crosses. It is as
  /// long as the distance of the vertex; if the solver is not exact, it may be shorter.
  /// @throws std::invalid_argument if there is no such vertex, or no path to it within the query's
  ///         limit
  /// @throws std::runtime_error if the recording does not describe a path of this mesh
  Path to_vertex(Index v) const { return to_point(SurfacePoint(v)); }
  /// Returns the path to target i of the query, as to_vertex.
  /// @throws std::invalid_argument if the query has no such target, or no path leads there
  Path to_target(std::size_t i) const;
  /// Returns the path to any point, which is searched as in `distance_at`.
  Path to_point(const SurfacePoint& point) const;
  /// As to_target and to_point; nullopt where no path leads.
  std::optional<Path> find_to_target(std::size_t i) const;
  std::optional<Path> find_to_point(const SurfacePoint& point) const;

  /// The index in the query of the source of the path to a point; kNone if it is unreachable.
  /// @throws std::invalid_argument if the point is not on this mesh
  Index nearest_source(const SurfacePoint& point) const;
  /// As nearest_source, of many points, as distances_at.
  std::vector<Index> nearest_sources_at(std::span<const SurfacePoint> points,
                                        const BeforeSome& before_some = {}) const;
  /// The nearest source of every vertex, in linear time: the exact Voronoi cells of the sources.
  std::vector<Index> nearest_sources() const;

 private:
  // Vertices and half-edges have the mesh's internal numbers.
  InternalPoint checked(const SurfacePoint& point) const;
  const AtTarget& target(std::size_t i) const;
  /// `answer(point)` for each point, as distances_at.
  template <typename Answer>
  auto for_each(std::span<const SurfacePoint> points, const BeforeSome& before_some,
                Answer answer) const;
  /// Of a point of a face, whose windows were kept.
  AtTarget at(const InternalPoint& point) const;
  /// Source of the path to v; nullopt if the root of its last segment must be followed.
  std::optional<Index> source_here(Index v) const;

  DistanceField field_;
  std::vector<LastSegment> last_segments_;
  std::vector<AtTarget> targets_;
  std::shared_ptr<const FaceWindows> windows_;  // null if none were kept
};

/// Solves a query for its distances and paths.
/// @param solver a solver on this mesh that supports paths (Abilities::paths)
/// @param keeps_windows for points of faces, if the solver propagates windows
/// @throws std::invalid_argument for the reasons of Solver::solve
Paths solve_paths(Solver& solver, const Mesh& mesh, const Query& query, bool keeps_windows = false);

}  // namespace geodesic
