// The heat method of CGAL, whose package is under the GPL.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh.h>

#include <limits>
#include <optional>
#include <stdexcept>

#include "heat.h"

namespace geodesic {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Direct =
    CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Surface, CGAL::Heat_method_3::Direct>;
using IntrinsicDelaunay =
    CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Surface,
                                                           CGAL::Heat_method_3::Intrinsic_Delaunay>;

class CgalHeat final : public Solver {
 public:
  CgalHeat(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    for (const Vec3& p : mesh.positions()) surface_.add_vertex({p[0], p[1], p[2]});
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto [a, b, c] = mesh.triangle(f);
      if (surface_.add_face(Vertex(a), Vertex(b), Vertex(c)) == Surface::null_face())
        throw std::invalid_argument("cgal-heat: CGAL's surface mesh refuses face " +
                                    std::to_string(f));
    }
    if (peer::is_intrinsic_delaunay(description)) {
      delaunay_.emplace(surface_);
    } else {
      direct_.emplace(surface_);
    }
  }

 private:
  using Vertex = Surface::Vertex_index;

  void run(const Start& start, std::span<double> distances) override {
    direct_ ? run_by(*direct_, start, distances) : run_by(*delaunay_, start, distances);
  }

  template <class Heat>
  void run_by(Heat& heat, const Start& start, std::span<double> distances) {
    heat.clear_sources();
    for (const StartVertex& each : start.vertices) heat.add_source(Vertex(each.vertex));
    auto found = surface_.add_property_map<Vertex, double>("v:distance", 0).first;
    heat.estimate_geodesic_distances(found);
    // CGAL initializes distances with the largest number, which unreached vertices keep.
    peer::answer(distances, std::numeric_limits<double>::max(),
                 [&](Index v) { return found[Vertex(v)]; });
  }

  Surface surface_;
  std::optional<Direct> direct_;
  std::optional<IntrinsicDelaunay> delaunay_;  // only one of the two is set
};

const RegisterSolver<CgalHeat> registered{
    peer::heat_method("cgal-heat", "CGAL's Heat_method_3, which is GPL, factorised by Eigen",
                      {peer::laplacian(peer::kIntrinsicDelaunay)})};

}  // namespace
}  // namespace geodesic
