// Shortest paths of one solve, traced over the faces from how they arrive
// (Recording::last_segments).
//
// A path is a chain of straight pieces that bend at vertices (Mitchell, Mount, Papadimitriou 1987,
// section 3). What a vertex remembers of its own path is the last piece: its root, unfolded into
// the face that the piece arrives in. The line to it is followed from face to face, and the root's
// own piece continues it. Numbers of vertices and faces are those that the mesh was given.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "solvers/core/solver.h"

namespace geodesic {

/// The paths of one solve: 32 bytes a vertex, the distances among them. Constant, so that any
/// number of threads may ask.
class Paths {
 public:
  /// @param mesh must outlive it
  /// @param query that was solved
  /// @param distances of the solve, one a vertex
  /// @param recording of the solve, with RecordingKind::paths
  /// @throws std::invalid_argument when the recording is none of paths, or of another query or mesh
  Paths(const Mesh& mesh, const Query& query, std::vector<double> distances, Recording recording);

  /// Those of all vertices, as of Solver::solve.
  const std::vector<double>& distances() const { return distances_; }
  /// That of the query's target i, exact wherever it lies; infinite where no path leads.
  double distance_to_target(std::size_t i) const { return targets_.at(i).distance; }
  /// That of any point, without another solve: infinite where no path leads within the query's
  /// limit. As exact as the distances of the vertices, from which it is found: the path is searched
  /// from its end, over the faces around it.
  /// @throws std::invalid_argument when the point is not of this mesh
  double distance_at(const SurfacePoint& point) const;

  /// Takes time linear in the faces that the path crosses.
  /// @throws std::invalid_argument when there is no such vertex, or no path leads there within the
  ///         query's limit
  /// @throws std::runtime_error when what the solver remembers is not a path of this mesh
  Path to_vertex(Index v) const;
  /// The same to target i of the query.
  Path to_target(std::size_t i) const;
  /// The same to any point, which is searched as by `distance_at`.
  Path to_point(const SurfacePoint& point) const;

  /// The query's source that the path to a vertex comes from, by its place in the query; kNone
  /// where no path leads. @throws std::invalid_argument when there is no such vertex
  Index nearest_source(Index v) const;
  /// The same of every vertex, in linear time: the exact Voronoi cells of the sources.
  std::vector<Index> nearest_sources() const;

 private:
  class Search;
  class Trace;

  // Below, vertices and half-edges go by the mesh's internal numbers.
  double distance(Index v) const { return distances_[mesh_.numbers().external_vertex(v)]; }
  Index internal_vertex(Index given) const;
  /// @param point not a vertex
  double distance_in_face(const InternalPoint& point) const;
  /// Whether a path may end a straight piece at v: pseudo-sources, and the query's own.
  bool may_bend(Index v) const;
  /// The source of the path to v, when that is straight.
  std::optional<Index> source_here(Index v) const;

  const Mesh& mesh_;
  InternalQuery query_;
  std::vector<double> distances_;  // by external number
  std::vector<LastSegment> last_segments_;
  std::vector<AtTarget> targets_;
  double farthest_ = kInfinity;                 // vertices farther than this have no distance
  std::unordered_map<Index, Index> source_at_;  // of vertices: the earliest
  std::vector<std::vector<InternalPoint>> source_images_;  // by source; none of vertices
};

/// Solves a query for its distances and paths.
/// @param solver that claims paths (Abilities::paths), on this mesh
/// @throws std::invalid_argument as Solver::solve
Paths solve_paths(Solver& solver, const Mesh& mesh, const Query& query);

}  // namespace geodesic
