// CGAL's exact geodesic distances: an oracle that shares no code with the other solvers.
//
// Chen, Han 1990 with the filters of Xin, Wang 2009, as in CGAL's package Triangulated Surface Mesh
// Shortest Paths. That package is GPL (README.md).
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/core/registry.h"

namespace geodesic {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface>;
using ShortestPaths = CGAL::Surface_mesh_shortest_path<Traits>;

// CGAL's tolerances are absolute. This power of two scales the mean edge length to [1, 2), which
// changes no bit of a mantissa and makes the tolerances relative to the mesh.
double unit_scale(const Mesh& mesh) {
  const double edge = mesh.mean_edge_length();
  return edge > 0 ? std::ldexp(1.0, -std::ilogb(edge)) : 1.0;
}

// Memory per vertex grows with the mesh: 37 KB at 48,485 vertices (horse), up to 60 KB at 134,000.
// This number of vertices takes about 7 GB, a third of a machine of 24 GB, and a minute; twice as
// many take all of its memory.
constexpr Index kMaxVertices = 120'000;

class Cgal final : public Solver {
 public:
  Cgal(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), scale_(unit_scale(mesh)), paths_(build_surface()) {}

 private:
  using Vertex = Surface::Vertex_index;
  using Face = Surface::Face_index;
  using Weights = ShortestPaths::Barycentric_coordinates;

  // CGAL's surface has no isolated vertices; `vertex_` maps the others to CGAL's ids.
  const Surface& build_surface() {
    vertex_.assign(mesh().vertex_count(), Surface::null_vertex());
    for (Index v = 0; v < mesh().vertex_count(); ++v) {
      if (mesh().outgoing(v).empty()) continue;
      const Vec3& p = mesh().position(v);
      vertex_[v] = surface_.add_vertex({p[0] * scale_, p[1] * scale_, p[2] * scale_});
      own_.push_back(v);
    }
    for (Index f = 0; f < mesh().face_count(); ++f) {
      const auto [a, b, c] = mesh().triangle(f);
      if (surface_.add_face(vertex_[a], vertex_[b], vertex_[c]) == Surface::null_face()) {
        throw std::invalid_argument("cgal: CGAL's surface mesh refuses face " + std::to_string(f));
      }
    }
    return surface_;
  }

  /// Converts weights: CGAL counts the corners of a face from the source of its half-edge. Faces
  /// have the same numbers in both.
  Weights weights_of(const InternalPoint& point) const {
    Index h = 3 * point.face;
    while (vertex_[mesh().origin(h)] != surface_.source(surface_.halfedge(Face(point.face)))) ++h;
    Weights weights;
    for (double& weight : weights) {
      weight = point.weights[h % 3];
      h = Mesh::next(h);
    }
    return weights;
  }

  /// CGAL 5.5 swaps the weights of an edge's ends for sources, but not for targets: the source is
  /// then not at distance 0 from itself.
  void add_point(const InternalPoint& source) {
    const Face face(source.face);
    Weights weights = weights_of(source);
    paths_.add_source_point(face, weights);
    if (edge_under(source) == kNone) return;
    if (!(paths_.shortest_distance_to_source_points(face, weights).first > kElsewhere)) return;
    const auto opposite = std::ranges::find(weights, 0.0) - weights.begin();
    std::swap(weights[static_cast<std::size_t>((opposite + 1) % 3)],
              weights[static_cast<std::size_t>((opposite + 2) % 3)]);
    paths_.remove_all_source_points();
    paths_.add_source_point(face, weights);
  }

  // Solves one source after the other: with several at once, CGAL 5.5 can follow a path beyond a
  // boundary edge, which its own assertions forbid.
  void run(const Start& start, std::span<double> distances) override {
    for (const InternalSource& source : start.query.sources) {
      if (source.at.is_vertex()) {
        distances[source.at.vertex] = std::min(distances[source.at.vertex], source.distance);
      }
      if (starts_from(source)) reach_vertices(source, distances);
    }
  }

  /// @return false at a vertex without faces
  bool starts_from(const InternalSource& source) {
    paths_.remove_all_source_points();
    if (!source.at.is_vertex()) {
      add_point(source.at);
    } else if (vertex_[source.at.vertex] != Surface::null_vertex()) {
      paths_.add_source_point(vertex_[source.at.vertex]);
    } else {
      return false;
    }
    return true;
  }

  void reach_vertices(const InternalSource& source, std::span<double> distances) {
    paths_.build_sequence_tree();
    for (Index v = 0; v < mesh().vertex_count(); ++v) {
      distances[v] = std::min(distances[v], distance_from(source, v));
    }
  }

  /// Distance by the tree of this source; infinite if unreachable.
  double distance_from(const InternalSource& source, Index v) {
    if (vertex_[v] == Surface::null_vertex()) return kInfinity;
    const double d = paths_.shortest_distance_to_source_points(vertex_[v]).first;
    return d < 0 ? kInfinity : source.distance + d / scale_;  // CGAL's "unreachable" is -1
  }

  /// Collects the points of one of CGAL's paths, from its end.
  struct Collector {
    const Cgal& cgal;
    std::vector<InternalPoint> points = {};

    void operator()(Surface::Halfedge_index h, Kernel::FT share) {
      const Index from = cgal.own_[cgal.surface_.source(h)];
      const Index to = cgal.own_[cgal.surface_.target(h)];
      points.push_back(in_internal_numbers(
          cgal.mesh(), point_on_edge(cgal.mesh(), cgal.mesh().numbers().external_vertex(from),
                                     cgal.mesh().numbers().external_vertex(to), share)));
    }
    void operator()(Vertex v) { points.emplace_back(cgal.own_[v]); }
    void operator()(Face /*face*/, const Weights& /*weights*/) {
      throw std::runtime_error("cgal: a path has a point inside a face");
    }
  };

  // With several sources, the present tree is that of the last one.
  std::vector<InternalPoint> trace_path(const InternalQuery& query,
                                        std::span<const double> distances, Index vertex) override {
    for (const InternalSource& source : query.sources) {
      if (source.at == InternalPoint(vertex)) return {InternalPoint(vertex)};
      if (query.sources.size() > 1 && starts_from(source)) paths_.build_sequence_tree();
      if (distance_from(source, vertex) > distances[vertex]) continue;
      Collector path{*this};
      paths_.shortest_path_sequence_to_source_points(vertex_[vertex], path);
      std::ranges::reverse(path.points);
      if (!source.at.is_vertex()) path.points.front() = source.at;
      return path.points;
    }
    throw std::runtime_error("cgal: no source has the path");
  }

  double scale_;
  Surface surface_;
  std::vector<Vertex> vertex_;
  std::vector<Index> own_;  // internal numbers of vertices, by CGAL's ids
  ShortestPaths paths_;     // last: refers to surface_
};

const RegisterSolver<Cgal> registered{{
    .name = "cgal",
    .family = "CH",
    .paper = "Xin, Wang 2009, Improving Chen and Han's algorithm on the discrete geodesic problem",
    .independent_oracle = true,
    .by_name_only = true,
    .abilities = {.non_manifold_vertices = false,
                  .degenerate_faces = false,
                  .surface_sources = true,
                  .traces = true,
                  .max_vertices = kMaxVertices},
    .remarks =
        "wraps CGAL's Surface_mesh_shortest_path, which is GPL: a program that contains it "
        "is too; independent oracle, counts nothing; solves several sources one after the other, "
        "and a distance limit saves no work",
}};

}  // namespace
}  // namespace geodesic
