#include "solvers/core/rescaled.h"

namespace geodesic {
namespace {

/// In the mesh's own numbering, which is that of the result.
Mesh converted(const Mesh& mesh, const Unit& unit) {
  std::vector<Triangle> triangles(mesh.given_face_count());
  for (Index f = 0; f < mesh.given_face_count(); ++f) triangles[f] = mesh.triangle(f);
  return Mesh(
      unit.in_unit(mesh.positions()), triangles, Numbering::as_given,
      mesh.crosses_non_manifold_edges() ? NonManifoldEdges::crossed : NonManifoldEdges::cut);
}

class Rescaled final : public Solver {
 public:
  Rescaled(const Mesh& mesh, const Description& description, const SolverFactory& factory,
           const Unit& unit)
      : Solver(mesh, description),
        unit_(unit),
        converted_(converted(mesh, unit)),
        solver_(factory(converted_, description)) {}

  InstructionSet instruction_set() const override { return solver_->instruction_set(); }

 private:
  void renew_state() override { solver_->renew(); }

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    Query in_unit = query;
    in_unit.limit = unit_.in_unit(query.limit);
    for (Source& source : in_unit.sources) source.distance = unit_.in_unit(source.distance);
    if (recording == nullptr) {
      solver_->solve(in_unit, distances);
    } else {
      record(in_unit, distances, *recording);
    }
    for (double& d : distances) convert_back(d);
  }

  void record(const Query& query, std::span<double> distances, Recording& recording) {
    const ReadWindows* const given = recording.read_windows;
    const ReadWindows read = [&](const FinalWindows& windows_on) {
      (*given)([&](Index half_edge, std::vector<Window>& windows) {
        windows_on(half_edge, windows);
        for (Window& w : windows) {
          for (double* length : {&w.begin, &w.end, &w.x, &w.y, &w.sigma}) convert_back(*length);
        }
      });
    };
    if (given != nullptr) recording.read_windows = &read;
    solver_->solve(query, distances, &recording);
    recording.read_windows = given;
    for (Arrival& arrival : recording.arrivals) convert_back(arrival.from);
    for (AtTarget& target : recording.targets) {
      convert_back(target.distance);
      convert_back(target.arrival.from);
    }
    if (recording.wavefront_sd) convert_back(*recording.wavefront_sd);
    for (WavefrontSample& sample : recording.curve) {
      for (double* length : {&sample.least, &sample.mean, &sample.sd}) convert_back(*length);
    }
    for (WavefrontSnapshot& snapshot : recording.snapshots) {
      for (WavefrontWindow& w : snapshot.windows) {
        for (double* length : {&w.begin, &w.end, &w.distance}) convert_back(*length);
      }
    }
  }

  void convert_back(Point2& point) const {
    convert_back(point.x);
    convert_back(point.y);
  }
  void convert_back(double& length) const { length = unit_.in_mesh(length); }

  Unit unit_;
  const Mesh converted_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace

std::unique_ptr<Solver> make_rescaled(const Mesh& mesh, const Description& description,
                                      const SolverFactory& factory, const Unit& unit) {
  return std::make_unique<Rescaled>(mesh, description, factory, unit);
}

}  // namespace geodesic
