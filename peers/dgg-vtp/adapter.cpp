// The authors' DGG-VTP, single-threaded: VTP over a discrete geodesic graph.
#include <cmath>
#include <cstring>
#include <optional>

#include "peer.h"

#define geodesic dgg_authors  // their namespace has the same name
#include "geodesic_algorithm_exact.h"
#include "geodesic_mesh.h"
#undef geodesic

namespace geodesic {
namespace {

// The value that the authors' main program computes from its option -eps.
double inner_epsilon(double eps) { return 1.7 * eps * std::pow(1.42, std::log10(eps / 1e-4)); }
constexpr int kSideFan = 3;

class DggVtp final : public Solver {
 public:
  DggVtp(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    std::vector<double> points = peer::coordinates(mesh);
    std::vector<unsigned> faces = peer::corners<unsigned>(mesh);
    mesh_.initialize_mesh_data(points, faces);
    const double eps = description.real("eps");
    algorithm_.emplace(&mesh_, inner_epsilon(eps), eps, kSideFan);
  }

 private:
  // The authors' code clears its mesh, so this class does not.
  void run(const Start& start, std::span<double> distances) override {
    algorithm_->propagate(start.vertices.front().vertex);
    peer::answer(distances, dgg_authors::GEODESIC_INF,
                 [&](Index v) { return mesh_.vertices()[v].geodesic_distance(); });
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    run(start, distances);
    if (peer::counts(recording)) {
      recording.window_propagations = dgg_authors::m_windows_propagation;
      recording.peak_wavefront = dgg_authors::m_windows_peak;
      recording.window_bytes = sizeof(dgg_authors::Interval);
    }
  }

  dgg_authors::Mesh mesh_;
  std::optional<dgg_authors::GeodesicAlgorithmExact> algorithm_;  // set after the mesh is built
};

const RegisterSolver<DggVtp> registered{{
    .name = "dgg-vtp",
    .family = "VTP",
    .paper = "Adikusuma, Fang, He 2020, Fast construction of discrete geodesic graphs; DGG-VTP as "
             "its repository has it",
    .exactness = Exactness::unbounded,
    .abilities = {.multiple_sources = false,
                  .initial_distances = false,
                  .concurrent_objects = false},
    .remarks = peer::remarks("the authors' code, which aims at a relative error of eps and states "
                             "no bound; it counts in global variables"),
    .parameters = {real_parameter("eps", 1e-4, 1e-9, 1, "the relative error to aim at")},
}};

}  // namespace
}  // namespace geodesic
