// Paths from brute force, for tests without a solver.
#pragma once

#include <cmath>
#include <utility>

#include "meshes/oracles/brute_force.h"
#include "meshes/oracles/path.h"
#include "solvers/paths/paths.h"

namespace geodesic {

inline LastSegment arrival_of(const Mesh& mesh, const StraightPiece& piece) {
  if (piece.crossings.empty()) {
    for (const Index h : mesh.outgoing(piece.from)) {
      const Index into = Mesh::previous(h);  // opposite to the head of h
      if (mesh.head(h) == piece.to) return {into, piece.from, {mesh.half_edge(into).length, 0}};
      if (mesh.apex(h) == piece.to) return {h, piece.from, {0, 0}};
    }
    return {};
  }
  const EdgeCrossing& last = piece.crossings.back();
  const HalfEdge& e = mesh.half_edge(last.half_edge);
  const double x = last.position - e.apex_x, y = -e.apex_y;
  const double stretch = piece.length / std::hypot(x, y);
  return {last.half_edge, piece.from, {e.apex_x + stretch * x, e.apex_y + stretch * y}};
}

/// What a solver records of a query whose sources are vertices and which has no targets.
inline Recording oracle_recording(const Mesh& mesh, const Query& query,
                                  const std::vector<double>& distances) {
  Recording recording;
  recording.kind = RecordingKind::paths;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto path = shortest_path(mesh, in_internal_numbers(mesh, query).sources, distances, v);
    recording.last_segments.push_back(path.empty() ? LastSegment{kNone, v, {0, 0}}
                                                   : arrival_of(mesh, path.back()));
  }
  return recording;
}

inline Paths oracle_paths(const Mesh& mesh, const Query& query) {
  std::vector<double> distances = BruteForce(mesh).distances(query.sources);
  Recording recording = oracle_recording(mesh, query, distances);
  return {mesh, query, std::move(distances), std::move(recording)};
}

}  // namespace geodesic
