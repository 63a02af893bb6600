#include "tests/differential/points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/verify/path_check.h"
#include "harness/verify/references.h"
#include "meshes/point_solver.h"
#include "meshes/random.h"

namespace geodesic::differential {
namespace {

// In a face, on an edge or at a vertex, at times next to a corner.
SurfacePoint random_point(const Mesh& mesh, Random& random) {
  const Index face = random.below(mesh.face_count());
  std::array<double, 3> weights;
  for (double& w : weights) w = random.between(0, 1);
  if (random.below(8) == 0) weights[random.below(3)] *= 1e-9;
  if (random.below(3) == 0) weights[random.below(3)] = 0;
  if (random.below(8) == 0) weights = {0, 1, 0};
  return point_in_face(mesh, face, weights);
}

}  // namespace

PointTask random_points(std::uint64_t seed, std::uint64_t number, const harness::Case& given,
                        const Mesh& mesh, const Description& judge, Index most_faces) {
  constexpr std::size_t kTargets = 6;
  Random random(split_mix(split_mix(split_mix(seed) ^ number)));
  PointTask task{given.queries.front(), {}, given.tolerance};
  task.query.limit = kInfinity;
  std::vector<SurfacePoint> points;
  for (Source& source : task.query.sources) {
    source.at = random_point(mesh, random);
    points.push_back(source.at);
  }
  while (task.query.targets.size() < kTargets) {
    task.query.targets.push_back(random_point(mesh, random));
    points.push_back(task.query.targets.back());
  }
  const InsertedPoints finer(mesh, points);
  // Points move by up to place(), at both ends.
  task.tolerance.least =
      std::max(task.tolerance.least, 2 * finer.place() / task.tolerance.relative);
  Query at_vertices{.sources = task.query.sources};
  for (Source& source : at_vertices.sources) source.at = finer.vertex(source.at);
  const std::vector<double> distances =
      finer.mesh().face_count() <= most_faces
          ? BruteForce(finer.mesh()).distances(at_vertices.sources)
          : harness::solve_once(judge.name, finer.mesh(), at_vertices);
  for (const SurfacePoint& target : task.query.targets) {
    task.expected.push_back(distances[finer.vertex(target)]);
  }
  return task;
}

harness::Finding check_targets(const Description& solver, const PointTask& task,
                               const std::vector<double>& got, PathFigures& figures) {
  for (std::size_t i = 0; i < got.size(); ++i) {
    const double error = harness::relative_error(got[i], task.expected[i], task.tolerance.least);
    figures.largest = std::max(figures.largest, std::abs(error));
  }
  return harness::in("targets", harness::check_promise(harness::Promise::of(solver), task.query,
                                                       got, task.expected, task.tolerance));
}

harness::Finding check_points(const Description& solver, const Mesh& mesh, Kind kind,
                              const PointTask& task, PathFigures& figures) {
  const auto object = make_solver(solver.name, mesh);
  const Paths paths = solve_paths(*object, mesh, task.query);
  const auto check = [&](const SurfacePoint& end, double distance, const Path& path) {
    ++figures.paths;
    figures.pieces += path.points.size() - 1;
    harness::Finding finding =
        harness::check_path(mesh, task.query, end, distance, path, task.tolerance);
    const bool has_angles = kind != Kind::thin && !mesh.has_degenerate_faces();
    if (!finding && has_angles) finding = harness::check_straight(mesh, path, task.tolerance);
    return finding;
  };
  std::vector<double> got;
  for (std::size_t i = 0; i < task.query.targets.size(); ++i) {
    got.push_back(paths.distance_to_target(i));
    if (got.back() == kInfinity) continue;
    auto finding = check(task.query.targets[i], got.back(), paths.to_target(i));
    if (finding) return harness::in("target " + std::to_string(i), std::move(finding));
  }
  for (Index v = 0; v < mesh.vertex_count(); v += 1 + mesh.vertex_count() / 8) {
    if (paths.distances()[v] == kInfinity) continue;
    auto finding = check(SurfacePoint(v), paths.distances()[v], paths.to_vertex(v));
    if (finding) return harness::in("vertex " + std::to_string(v), std::move(finding));
  }
  return check_targets(solver, task, got, figures);
}

}  // namespace geodesic::differential
