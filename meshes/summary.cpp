#include "meshes/summary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/defects.h"
#include "meshes/topology.h"
#include "solvers/core/tolerance.h"

namespace geodesic {
namespace {

// Angle at the corner from which the half-edge starts, in radians. By the tangent: the cosine
// loses half the digits of small angles.
double corner_angle(const Surface& surface, OpenMesh::HalfedgeHandle h) {
  const OpenMesh::HalfedgeHandle before = surface.prev_halfedge_handle(h);
  const auto& corner = surface.point(surface.from_vertex_handle(h));
  const auto along = surface.point(surface.to_vertex_handle(h)) - corner;
  const auto back = surface.point(surface.from_vertex_handle(before)) - corner;
  return std::atan2(along.cross(back).norm(), along.dot(back));
}

double edge_length(const Surface& surface, OpenMesh::EdgeHandle edge) {
  const OpenMesh::HalfedgeHandle h = surface.halfedge_handle(edge, 0);
  return (surface.point(surface.to_vertex_handle(h)) - surface.point(surface.from_vertex_handle(h)))
      .norm();
}

void measure_edges(const Surface& surface, MeshSummary& summary) {
  if (surface.n_edges() == 0) return;
  EdgeLengths lengths{.least = kInfinity};
  double sum = 0;
  for (const OpenMesh::EdgeHandle edge : surface.edges()) {
    const double length = edge_length(surface, edge);
    sum += length;
    lengths.least = std::min(lengths.least, length);
    lengths.greatest = std::max(lengths.greatest, length);
    if (surface.is_boundary(edge)) ++summary.boundary_edges;
  }
  lengths.mean = sum / static_cast<double>(surface.n_edges());
  summary.edge_lengths = lengths;
}

void measure_angles(const TriangleSoup& soup, const Topology& topology, MeshSummary& summary) {
  const Surface& surface = topology.surface;
  std::vector<double> totals(surface.n_vertices(), 0.0);
  double smallest = kInfinity;
  for (const OpenMesh::FaceHandle face : surface.faces()) {
    const Triangle& triangle = soup.triangles[surface.property(topology.file_face, face)];
    const bool flat = has_zero_area(soup.positions, triangle);
    for (const OpenMesh::HalfedgeHandle h : surface.fh_range(face)) {
      const double angle = corner_angle(surface, h);
      totals[static_cast<std::size_t>(surface.from_vertex_handle(h).idx())] += angle;
      if (!flat) smallest = std::min(smallest, angle);
    }
  }
  if (smallest < kInfinity) summary.smallest_angle = smallest * 180 / std::numbers::pi;
  for (const OpenMesh::VertexHandle v : surface.vertices()) {
    const bool saddle =
        totals[static_cast<std::size_t>(v.idx())] > 2 * std::numbers::pi + kSaddleAngleExcess;
    if (saddle && !surface.is_boundary(v)) ++summary.saddle_vertices;
  }
}

void measure_topology(const Topology& topology, MeshSummary& summary) {
  const Surface& surface = topology.surface;
  summary.left_out_faces = topology.left_out_faces;
  summary.edges = surface.n_edges();
  summary.components = count_components(topology);
  summary.boundary_loops = count_boundary_loops(surface);
  for (const OpenMesh::VertexHandle v : surface.vertices()) {
    if (surface.is_isolated(v)) ++summary.isolated_vertices;
  }
  summary.orientable = topology.orientable();
  if (!summary.orientable) return;
  // Euler: vertices - edges + faces = sum over parts of (2 - 2 genus - loops).
  const std::size_t vertices = surface.n_vertices() - summary.isolated_vertices;
  summary.genus = (2 * count_pieces(surface) + surface.n_edges() - summary.boundary_loops -
                   vertices - surface.n_faces()) /
                  2;
}

}  // namespace

MeshSummary summarize(const TriangleSoup& soup) {
  const Topology topology = build_topology(soup);
  MeshSummary summary;
  summary.vertices = soup.positions.size();
  summary.faces = soup.triangles.size();
  measure_topology(topology, summary);
  measure_edges(topology.surface, summary);
  measure_angles(soup, topology, summary);
  return summary;
}

}  // namespace geodesic
