// The heat method of libigl.
#include <igl/avg_edge_length.h>
#include <igl/heat_geodesics.h>

#include <stdexcept>

#include "heat.h"

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
    data_.use_intrinsic_delaunay = peer::is_intrinsic_delaunay(description);
    const double edge = igl::avg_edge_length(points, faces);
    if (!igl::heat_geodesics_precompute(points, faces, description.real("time") * edge * edge,
                                        data_))
      throw std::runtime_error("libigl-heat: heat_geodesics_precompute failed");
  }

 private:
  void run(const Start& start, std::span<double> distances) override {
    Eigen::VectorXi sources(start.vertices.size());
    for (int i = 0; i < sources.size(); ++i)
      sources(i) = static_cast<int>(start.vertices[i].vertex);
    Eigen::VectorXd found;
    igl::heat_geodesics_solve(data_, sources, found);
    std::copy(found.begin(), found.end(), distances.begin());
  }

  igl::HeatGeodesicsData<double> data_;
};

const RegisterSolver<LibiglHeat> registered{
    peer::heat_method("libigl-heat", "the heat method in libigl, factorised by Eigen",
                      {peer::laplacian(peer::kCotangent), peer::heat_time()})};

}  // namespace
}  // namespace geodesic
