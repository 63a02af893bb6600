#include "solvers/core/rescaled.h"

#include <cmath>

#include "solvers/core/unit.h"

namespace geodesic {
namespace {

/// In the mesh's own numbering, which is that of the result.
Mesh in_unit(const Mesh& mesh, int exponent) {
  std::vector<Triangle> triangles(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) triangles[f] = mesh.triangle(f);
  return Mesh(scaled(mesh.positions(), -exponent), triangles);
}

class Rescaled final : public Solver {
 public:
  Rescaled(const Mesh& mesh, const Description& description, const SolverFactory& factory,
           int exponent)
      : Solver(mesh, description),
        exponent_(exponent),
        in_unit_(in_unit(mesh, exponent)),
        solver_(factory(in_unit_, description)) {}

  InstructionSet instruction_set() const override { return solver_->instruction_set(); }

 private:
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    Query asked = query;
    asked.limit = std::ldexp(query.limit, -exponent_);
    for (Source& source : asked.sources) source.distance = std::ldexp(source.distance, -exponent_);
    if (recording == nullptr) {
      solver_->solve(asked, distances);
    } else {
      record(asked, distances, *recording);
    }
    for (double& d : distances) back(d);
  }

  void record(const Query& asked, std::span<double> distances, Recording& recording) {
    const ReadWindows* const wished = recording.read_windows;
    const ReadWindows read = [&](const FinalWindows& windows_on) {
      (*wished)([&](Index half_edge, std::vector<Window>& windows) {
        windows_on(half_edge, windows);
        for (Window& w : windows) {
          for (double* length : {&w.begin, &w.end, &w.x, &w.y, &w.sigma}) back(*length);
        }
      });
    };
    if (wished != nullptr) recording.read_windows = &read;
    solver_->solve(asked, distances, &recording);
    recording.read_windows = wished;
    if (recording.wavefront_sd) back(*recording.wavefront_sd);
    for (WavefrontSample& sample : recording.curve) {
      for (double* length : {&sample.least, &sample.mean, &sample.sd}) back(*length);
    }
    for (WavefrontSnapshot& snapshot : recording.snapshots) {
      for (WavefrontWindow& w : snapshot.windows) {
        for (double* length : {&w.begin, &w.end, &w.distance}) back(*length);
      }
    }
  }

  /// Into the mesh's unit.
  void back(double& length) const { length = std::ldexp(length, exponent_); }

  int exponent_;
  const Mesh in_unit_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace

std::unique_ptr<Solver> make_rescaled(const Mesh& mesh, const Description& description,
                                      const SolverFactory& factory, int exponent) {
  return std::make_unique<Rescaled>(mesh, description, factory, exponent);
}

}  // namespace geodesic
