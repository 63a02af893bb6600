// The authors' ICH: Chen and Han's algorithm with a filter of windows and a priority queue.
long long propagated_windows =
    0;  // the authors' code counts here, after the edit in CMakeLists.txt

#include <ICHWithFurtherPriorityQueue.hpp>

#include <optional>

#include "peer.h"

namespace geodesic {
namespace {

class XinWangIch final : public Solver {
 public:
  XinWangIch(const Mesh& mesh, const Description& description) : Solver(mesh, description) {
    std::vector<CPoint3D> points;
    for (const Vec3& p : mesh.positions()) points.emplace_back(p[0], p[1], p[2]);
    std::vector<CFace> faces;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto [a, b, c] = mesh.triangle(f);
      faces.emplace_back(a, b, c);
    }
    model_.LoadModel(points, faces);
    model_.Preprocess();
  }

 private:
  // A separate object keeps the state of a solve and traces paths; the model is constant.
  void run(const Start& start, std::span<double> distances) override {
    std::set<int> sources;
    for (const StartVertex& each : start.vertices) sources.insert(static_cast<int>(each.vertex));
    CICHWithFurtherPriorityQueue& algorithm = algorithm_.emplace(model_, sources);
    propagated_windows = 0;
    algorithm.Execute();
    peer::answer(distances, DBL_MAX,
                 [&](Index v) { return algorithm.m_InfoAtVertices[v].disUptodate; });
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    run(start, distances);
    if (peer::counts(recording)) {
      recording.window_propagations = propagated_windows;
      recording.windows_created = algorithm_->GetWindowNum();
      recording.peak_wavefront = algorithm_->GetMaxLenOfQue();
      recording.window_bytes = sizeof(::Window);
    }
  }

  std::vector<InternalPoint> trace_path(const InternalQuery& /*query*/,
                                        std::span<const double> /*distances*/,
                                        Index vertex) override {
    std::vector<EdgePoint> path;
    algorithm_->FindSourceVertex(static_cast<int>(vertex), path);
    std::vector<InternalPoint> points;
    for (auto point = path.rbegin(); point != path.rend(); ++point) {
      const auto index = static_cast<Index>(point->index);
      if (point->isVertex) {
        points.emplace_back(index);
      } else {
        const auto& edge = model_.Edge(point->index);
        points.push_back(peer::on_edge(mesh(), static_cast<Index>(edge.indexOfLeftVert),
                                       static_cast<Index>(edge.indexOfRightVert),
                                       point->proportion));
      }
    }
    return points;
  }

  CRichModel model_;
  std::optional<CICHWithFurtherPriorityQueue> algorithm_;
};

const RegisterSolver<XinWangIch> registered{{
    .name = "xin-wang-ich",
    .family = "CH",
    .paper = "Xin, Wang 2009, Improving Chen and Han's algorithm on the discrete geodesic problem",
    .exactness = Exactness::unbounded,
    .abilities = {.initial_distances = false, .traces = true},
    .remarks = peer::remarks(
        "the authors' code, as packaged for Python by S. Ramachandran; the algorithm is exact, the "
        "code has tolerances and states no bound"),
}};

}  // namespace
}  // namespace geodesic
