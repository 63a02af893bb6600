// The authors' exact parallel VTP (PVTP) and sequential approximate VTP (AVTP).
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <optional>

#include "peer.h"

// The authors' code expects these without a namespace, as in windows.h.
using std::max;
using std::min;

#define geodesic pvtp_authors  // their namespace has the same name
#include "geodesic_algorithm_approximate.h"
#include "geodesic_algorithm_parallel_fwp_exact.h"
#undef geodesic

namespace geodesic {
namespace {

// Returns a face's perimeter times its longest edge, divided by its area; 1 if all edges are equal.
double anisotropy(const Mesh& mesh, Index face) {
  const auto [a, b, c] = mesh.triangle(face);
  const Vec3 ab = subtract(mesh.position(b), mesh.position(a));
  const Vec3 ac = subtract(mesh.position(c), mesh.position(a));
  const std::array edges{norm(ab), norm(ac), norm(subtract(ac, ab))};
  const double perimeter = edges[0] + edges[1] + edges[2];
  const double area = norm(cross(ab, ac)) / 2;
  return perimeter * std::ranges::max(edges) / (4 * std::sqrt(3.0) * area);
}

// Sets the values of the authors' main program, which is only in djie-0329/PVTP.
void set_queue(pvtp_authors::GeodesicAlgorithmParallelFWPExact& algorithm, const Mesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) sum += anisotropy(mesh, f);
  const double mean = sum / mesh.face_count();
  algorithm.binWidth = mesh.mean_edge_length() / std::clamp(std::floor(mean), 1.0, 1e9);
  algorithm.Kmin = 6;
  algorithm.Kmax = 1000000000;
  algorithm.step = 1;
}

// Records the counters of the last solve, which the authors' code keeps in global variables.
void count(Recording& recording) {
  if (!peer::counts(recording)) return;
  recording.window_propagations = pvtp_authors::m_windows_propagation.load();
  recording.window_bytes = sizeof(pvtp_authors::Interval);
}

// The authors' mesh. Their algorithms clear its distances, so this class does not.
class AuthorsMesh {
 public:
  explicit AuthorsMesh(const Mesh& mesh) {
    std::vector<double> points = peer::coordinates(mesh);
    std::vector<unsigned> faces = peer::corners<unsigned>(mesh);
    mesh_.initialize_mesh_data(points, faces);
  }

  pvtp_authors::Mesh* get() { return &mesh_; }

  void answer(std::span<double> distances) {
    peer::answer(distances, pvtp_authors::GEODESIC_INF,
                 [&](Index v) { return mesh_.vertices()[v].geodesic_distance(); });
  }

 private:
  pvtp_authors::Mesh mesh_;
};

class Pvtp final : public Solver {
 public:
  Pvtp(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        threads_(description.integer("threads")),
        mesh_(mesh),
        algorithm_(mesh_.get(), threads_, threads_ * description.integer("lists")) {
    set_queue(algorithm_, mesh);
  }

 private:
  void run(const Start& start, std::span<double> distances) override {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, threads_);
    algorithm_.propagate(start.vertices.front().vertex);
    mesh_.answer(distances);
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    run(start, distances);
    count(recording);
  }

  Index threads_;
  AuthorsMesh mesh_;
  pvtp_authors::GeodesicAlgorithmParallelFWPExact algorithm_;  // on mesh_
};

class Avtp final : public Solver {
 public:
  Avtp(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), lambda_(description.real("lambda")) {
    renew_state();
  }

 private:
  // A solve marks vertices of the authors' mesh as saddles, and their code never clears the marks.
  void renew_state() override {
    algorithm_.reset();
    authors_.emplace(mesh());
    algorithm_.emplace(authors_->get(), lambda_);
  }

  void run(const Start& start, std::span<double> distances) override {
    algorithm_->propagate(start.vertices.front().vertex);
    authors_->answer(distances);
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    run(start, distances);
    count(recording);
  }

  double lambda_;
  std::optional<AuthorsMesh> authors_;
  std::optional<pvtp_authors::GeodesicAlgorithmApproximate> algorithm_;  // on authors_
};

constexpr Abilities kAbilities = {
    .multiple_sources = false, .initial_distances = false, .concurrent_objects = false};
constexpr const char* kPaper =
    "Du, He, Fang, Meng, Xin 2021, On the vertex-oriented triangle propagation (VTP) algorithm: "
    "parallelization and approximation";

const RegisterSolver<Avtp> avtp{{
    .name = "avtp",
    .family = "VTP",
    .paper = kPaper,
    .exactness = Exactness::unbounded,
    .needs_renewal = true,
    .abilities = kAbilities,
    .remarks = peer::remarks("the authors' code, of one thread, as the repository of DGG-VTP has "
                             "it; it keeps marks in its mesh, which is built again for every "
                             "source, and counts in global variables"),
    .parameters = {real_parameter("lambda", 8, 0.01, 1e6,
                                  "radius of exact propagation, in mean edge lengths")},
}};

const RegisterSolver<Pvtp> pvtp{{
    .name = "pvtp",
    .family = "VTP",
    .paper = kPaper,
    .deterministic = false,
    .abilities = kAbilities,
    .remarks = peer::remarks("the authors' code as the repository of DGG-VTP has it; it counts in "
                             "global variables"),
    .parameters = {integer_parameter("threads", 1, 1, 1024, "that propagate window lists"),
                   integer_parameter("lists", 100, 1, 1000000,
                                     "window lists to propagate at the same time, a thread")},
}};

}  // namespace
}  // namespace geodesic
