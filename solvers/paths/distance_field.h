// The distances of one solve, and where its paths begin and may bend.
#pragma once

#include <unordered_map>
#include <vector>

#include "solvers/core/query.h"
#include "solvers/core/solver.h"

namespace geodesic {

/// Vertices and half-edges have the mesh's internal numbers.
class DistanceField {
 public:
  /// @param mesh must outlive this object
  /// @param query the query that was solved
  /// @param distances one per vertex, by external number
  /// @param are_shortest as Recording::shortest_paths
  /// @param farthest vertices farther than this have no distance
  DistanceField(const Mesh& mesh, const Query& query, std::vector<double> distances,
                bool are_shortest, double farthest);

  const Mesh& mesh() const { return mesh_; }
  const InternalQuery& query() const { return query_; }
  const std::vector<double>& by_external_number() const { return distances_; }
  double operator[](Index v) const { return distances_[mesh_.numbers().external_vertex(v)]; }

  /// Whether distances are those of shortest paths; otherwise they are upper bounds.
  bool are_shortest() const { return are_shortest_; }
  double farthest() const { return farthest_; }
  /// Whether a straight piece of a path may end at v: at pseudo-sources and at sources of the
  /// query, or anywhere if paths are not shortest ones.
  bool may_bend(Index v) const {
    return !are_shortest_ || mesh_.is_pseudo_source(v) || source_at_.contains(v);
  }

  /// The source of least distance at a vertex; kNone if there is none.
  Index source_at(Index v) const {
    const auto source = source_at_.find(v);
    return source == source_at_.end() ? kNone : source->second;
  }
  /// A source in the faces that contain it; empty for one at a vertex.
  const std::vector<InternalPoint>& images(Index source) const { return source_images_[source]; }

 private:
  const Mesh& mesh_;
  InternalQuery query_;
  std::vector<double> distances_;  // by external number
  bool are_shortest_;
  double farthest_;
  std::unordered_map<Index, Index> source_at_;
  std::vector<std::vector<InternalPoint>> source_images_;  // by source
};

}  // namespace geodesic
