// The heat method as libigl has it.
#include <igl/avg_edge_length.h>
#include <igl/heat_geodesics.h>

#include <stdexcept>

#include "peer.h"

namespace geodesic {
namespace {

class LibiglHeat final : public Solver {
 public:
  LibiglHeat(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    Eigen::MatrixXd points(mesh.vertex_count(), 3);
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      for (int k = 0; k < 3; ++k) points(v, k) = mesh.position(v)[k];
    Eigen::MatrixXi faces(mesh.face_count(), 3);
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (int k = 0; k < 3; ++k) faces(f, k) = static_cast<int>(mesh.triangle(f)[k]);
    data_.use_intrinsic_delaunay = description.text("laplacian") == "intrinsic-delaunay";
    const double edge = igl::avg_edge_length(points, faces);
    if (!igl::heat_geodesics_precompute(points, faces, description.real("time") * edge * edge,
                                        data_))
      throw std::runtime_error("libigl-heat: heat_geodesics_precompute failed");
  }

 private:
  void run(const Query& query, std::span<double> distances, Recording* /*recording*/) override {
    Eigen::VectorXi sources(query.sources.size());
    for (int i = 0; i < sources.size(); ++i)
      sources(i) = static_cast<int>(query.sources[i].at.vertex);
    Eigen::VectorXd found;
    igl::heat_geodesics_solve(data_, sources, found);
    std::copy(found.begin(), found.end(), distances.begin());
  }

  igl::HeatGeodesicsData<double> data_;
};

const RegisterSolver<LibiglHeat> registered{{
    .name = "libigl-heat",
    .family = "heat",
    .paper = "Crane, Weischedel, Wardetzky 2013, Geodesics in heat",
    .data_structure = "sparse factorisation",
    .time_complexity = "O(n^1.5)",
    .space_complexity = "O(n log n)",
    .propagation = "vertex",
    .exactness = Exactness::unbounded,
    .abilities = {.initial_distances = false},
    .remarks = peer::remarks("the heat method in libigl, factorised by Eigen"),
    .parameters = {choice_parameter("laplacian", {"cotangent", "intrinsic-delaunay"},
                                    "of the triangles, or of their intrinsic Delaunay edges"),
                   real_parameter("time", 1, 1e-6, 1e6,
                                  "of the heat flow, by the square of the mean edge length")},
}};

}  // namespace
}  // namespace geodesic
