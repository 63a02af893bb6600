// Points in faces and on edges of random meshes, and the paths between them.
#pragma once

#include <cstdint>
#include <vector>

#include "harness/verify/distance_check.h"
#include "solvers/paths/paths.h"
#include "tests/differential/random_case.h"

namespace geodesic::differential {

/// A query with sources and targets anywhere on a mesh, and the right distances of its targets.
struct PointTask {
  Query query;
  std::vector<double> expected;
  harness::Tolerance tolerance;
};

/// Right distances are those of the mesh with the points inserted.
/// @param number of the mesh, which gives the same points every time
/// @param judge answers on meshes too large for brute force, too
/// @param most_faces for brute force
/// @throws std::exception as the judge does
PointTask random_points(std::uint64_t seed, std::uint64_t number, const harness::Case& given,
                        const Mesh& mesh, const Description& judge, Index most_faces);

/// What was compared of one solver.
struct PathFigures {
  std::uint64_t paths = 0, pieces = 0;  ///< pieces: lines in one face
  double largest = 0;                   ///< relative error of a target's distance
  std::uint64_t at = 0;                 ///< number of the mesh
};

/// Holds the targets' distances, the paths to them and to some vertices against what a solver of
/// paths promises; straightness where faces have angles.
harness::Finding check_points(const Description& solver, const Mesh& mesh, Kind kind,
                              const PointTask& task, PathFigures& figures);

/// Holds the distances alone against the right ones.
harness::Finding check_targets(const Description& solver, const PointTask& task,
                               const std::vector<double>& got, PathFigures& figures);

}  // namespace geodesic::differential
