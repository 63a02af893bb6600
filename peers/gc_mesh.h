// The mesh in the data structures of geometry-central.
#pragma once

#include <geometrycentral/surface/manifold_surface_mesh.h>
#include <geometrycentral/surface/vertex_position_geometry.h>

#include <memory>

#include "peer.h"

namespace geodesic::peer {

/// A mesh with the same order of vertices and faces. Vertices without faces are left out, as in
/// geometry-central's file readers. The constructor throws if geometry-central refuses the mesh.
class GcMesh {
 public:
  /// @param manifold builds a ManifoldSurfaceMesh, as most of geometry-central's examples do
  GcMesh(const Mesh& own, bool manifold)
      : numbers_(numbered(own)), mesh_(made(polygons(own, numbers_), manifold)), geometry(*mesh_) {
    for (Index v = 0; v < numbers_.size(); ++v) {
      if (numbers_[v] == kNone) continue;
      const Vec3& p = own.position(v);
      geometry.vertexPositions[numbers_[v]] = {p[0], p[1], p[2]};
    }
  }

  geometrycentral::surface::SurfaceMesh& mesh() const { return *mesh_; }

  geometrycentral::surface::Vertex vertex(Index own) const { return mesh_->vertex(numbers_[own]); }

  /// Converts a path of geometry-central that begins at its source.
  std::vector<InternalPoint> points(
      const Mesh& own, const std::vector<geometrycentral::surface::SurfacePoint>& path) const {
    using geometrycentral::surface::SurfacePointType;
    std::vector<Index> by_number;
    for (Index v = 0; v < numbers_.size(); ++v)
      if (numbers_[v] != kNone) by_number.push_back(v);
    const auto number = [&](geometrycentral::surface::Vertex v) { return by_number[v.getIndex()]; };
    std::vector<InternalPoint> all;
    for (const geometrycentral::surface::SurfacePoint& point : path) {
      if (point.type == SurfacePointType::Vertex) {
        all.emplace_back(number(point.vertex));
      } else if (point.type == SurfacePointType::Edge) {
        all.push_back(on_edge(own, number(point.edge.firstVertex()),
                              number(point.edge.secondVertex()), point.tEdge));
      } else {
        throw std::invalid_argument("a path has a point inside a face");
      }
    }
    return all;
  }

  /// Returns the sources that have faces.
  std::vector<geometrycentral::surface::Vertex> sources(const Start& start) const {
    std::vector<geometrycentral::surface::Vertex> all;
    for (const StartVertex& each : start.vertices)
      if (numbers_[each.vertex] != kNone) all.push_back(mesh_->vertex(numbers_[each.vertex]));
    return all;
  }

  /// Returns the targets at which a query stops; empty unless all of them are vertices.
  std::vector<geometrycentral::surface::Vertex> stops(const InternalQuery& query) const {
    std::vector<geometrycentral::surface::Vertex> all;
    for (const InternalPoint& target : query.targets)
      if (query.stop_at_targets && target.is_vertex()) all.push_back(vertex(target.vertex));
    return all.size() == query.targets.size() ? all : decltype(all){};
  }

  /// Writes the distances that geometry-central found. Distances of 1e100 or more are unreachable.
  void answer(const Start& start, const geometrycentral::surface::VertexData<double>& found,
              std::span<double> distances) const {
    peer::answer(distances, 1e100,
                 [&](Index v) { return numbers_[v] == kNone ? kInfinity : found[numbers_[v]]; });
    for (const StartVertex& each : start.vertices)
      if (numbers_[each.vertex] == kNone) distances[each.vertex] = 0;
  }

 private:
  using Polygons = std::vector<std::vector<std::size_t>>;

  static std::vector<Index> numbered(const Mesh& own) {
    std::vector<Index> numbers;
    Index next = 0;
    for (Index v = 0; v < own.vertex_count(); ++v)
      numbers.push_back(own.outgoing(v).empty() ? kNone : next++);
    return numbers;
  }

  static Polygons polygons(const Mesh& own, const std::vector<Index>& numbers) {
    Polygons all;
    for (Index f = 0; f < own.face_count(); ++f) {
      const auto [a, b, c] = own.triangle(f);
      all.push_back({numbers[a], numbers[b], numbers[c]});
    }
    return all;
  }

  static std::unique_ptr<geometrycentral::surface::SurfaceMesh> made(const Polygons& polygons,
                                                                     bool manifold) {
    using namespace geometrycentral::surface;
    if (manifold) return std::make_unique<ManifoldSurfaceMesh>(polygons);
    return std::make_unique<SurfaceMesh>(polygons);
  }

  std::vector<Index> numbers_;  // by vertex; kNone for a vertex without faces
  std::unique_ptr<geometrycentral::surface::SurfaceMesh> mesh_;

 public:
  geometrycentral::surface::VertexPositionGeometry geometry;
};

}  // namespace geodesic::peer
