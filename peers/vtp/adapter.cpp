// The authors' VTP: vertex-oriented triangle propagation.
#include <cstring>
#include <optional>

#include "peer.h"

#define geodesic vtp_authors  // their namespace has the same name
#include "geodesic_algorithm_exact.h"
#include "geodesic_mesh.h"
#undef geodesic

namespace geodesic {
namespace {

class Vtp final : public Solver {
 public:
  Vtp(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        coordinates_(peer::coordinates(mesh)),
        corners_(peer::corners<unsigned>(mesh)) {
    renew_state();
  }

 private:
  // The authors' mesh stores distances and states, and their code never clears them.
  void renew_state() override {
    algorithm_.reset();
    mesh_.emplace().initialize_mesh_data(coordinates_, corners_);
    algorithm_.emplace(&*mesh_);
  }

  void run(const Start& start, std::span<double> distances) override {
    algorithm_->propagate(start.vertices.front().vertex);
    peer::answer(distances, vtp_authors::GEODESIC_INF,
                 [&](Index v) { return mesh_->vertices()[v].geodesic_distance(); });
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    run(start, distances);
    if (peer::counts(recording)) {
      recording.window_propagations = vtp_authors::m_windows_propagation;
      recording.peak_wavefront = vtp_authors::m_windows_peak;
      recording.window_bytes = sizeof(vtp_authors::Interval);
    }
  }

  std::vector<double> coordinates_;
  std::vector<unsigned> corners_;
  std::optional<vtp_authors::Mesh> mesh_;
  std::optional<vtp_authors::GeodesicAlgorithmExact> algorithm_;  // on mesh_
};

const RegisterSolver<Vtp> registered{{
    .name = "vtp",
    .family = "VTP",
    .paper = "Qin, Han, Yu, Yu, Zhang 2016, Fast and exact discrete geodesic computation based on "
             "triangle-oriented wavefront propagation",
    .needs_renewal = true,
    .abilities = {.multiple_sources = false,
                  .initial_distances = false,
                  .concurrent_objects = false},
    .remarks = peer::remarks("the authors' code; it keeps its state in its mesh, which is built "
                             "again for every source, and counts in global variables"),
}};

}  // namespace
}  // namespace geodesic
