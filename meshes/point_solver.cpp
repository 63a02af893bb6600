#include "meshes/point_solver.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace geodesic {
namespace {

std::vector<SurfacePoint> joined(std::span<const SurfacePoint> a, std::span<const SurfacePoint> b) {
  std::vector<SurfacePoint> both(a.begin(), a.end());
  both.insert(both.end(), b.begin(), b.end());
  return both;
}

// A point in a face. A point has one for each face that it lies in, also at a vertex.
struct InFace {
  Index face;
  std::array<double, 3> weights;
};

std::vector<InFace> faces_of(const Mesh& mesh, const InternalPoint& point) {
  std::vector<InFace> faces;
  if (!point.is_vertex()) {
    for (const InternalPoint& image : in_every_face(mesh, point)) {
      faces.push_back({image.face, image.weights});
    }
    return faces;
  }
  for (const Index h : mesh.outgoing(point.vertex)) {
    faces.push_back({h / 3, {}});
    faces.back().weights[h % 3] = 1;
  }
  return faces;
}

// Returns the length of the line within a face that contains both points, kInfinity if there is
// none. It is computed from weights, which keep the digits of short lines.
double straight_length(const Mesh& mesh, const std::vector<InFace>& from,
                       const std::vector<InFace>& to) {
  double least = kInfinity;
  for (const InFace& a : from) {
    for (const InFace& b : to) {
      if (a.face != b.face) continue;
      const auto k = static_cast<Index>(std::ranges::max_element(a.weights) - a.weights.begin());
      const HalfEdge& e = mesh.half_edge(3 * a.face + k);
      const Index head = (k + 1) % 3, apex = (k + 2) % 3;
      const double x = b.weights[head] - a.weights[head], y = b.weights[apex] - a.weights[apex];
      least = std::min(least, norm(Point2{x * e.length + y * e.apex_x, y * e.apex_y}));
    }
  }
  return least;
}

bool takes(const Description& solver, std::span<const SurfacePoint> sources,
           std::span<const SurfacePoint> targets) {
  const auto are_vertices = [](std::span<const SurfacePoint> points) {
    return std::ranges::all_of(points, &SurfacePoint::is_vertex);
  };
  return (are_vertices(sources) || solver.abilities.surface_sources) &&
         (are_vertices(targets) || solver.abilities.paths);
}

}  // namespace

std::shared_ptr<const InsertedPoints> insert_for(const Description& solver, const Mesh& mesh,
                                                 std::span<const SurfacePoint> sources,
                                                 std::span<const SurfacePoint> targets) {
  const std::vector<SurfacePoint> points = joined(sources, targets);
  for (const SurfacePoint& point : points) {
    const std::string defect = defect_of(mesh, point);
    if (!defect.empty()) throw std::invalid_argument(defect);
  }
  if (takes(solver, sources, targets)) return nullptr;
  return std::make_shared<const InsertedPoints>(mesh, points);
}

PointSolver::PointSolver(std::string_view solver, const Mesh& mesh,
                         std::shared_ptr<const InsertedPoints> inserted)
    : mesh_(&mesh),
      inserted_(std::move(inserted)),
      solver_(make_solver(solver, inserted_ == nullptr ? mesh : inserted_->mesh())) {}

void PointSolver::solve(const Query& query, std::span<double> distances,
                        std::span<double> at_targets) {
  if (at_targets.size() != query.targets.size()) {
    throw std::invalid_argument(name() + ": needs room for one distance a target");
  }
  if (inserted_ != nullptr) return solve_inserted(query, distances, at_targets);
  if (std::ranges::all_of(query.targets, &SurfacePoint::is_vertex)) {
    solver_->solve(query, distances);
    for (std::size_t i = 0; i < at_targets.size(); ++i) {
      at_targets[i] = distances[query.targets[i].vertex];
    }
    return;
  }
  Recording recording;
  recording.kind = RecordingKind::paths;
  solver_->solve(query, distances, &recording);
  std::ranges::transform(recording.targets, at_targets.begin(), &AtTarget::distance);
}

void PointSolver::solve_inserted(const Query& query, std::span<double> distances,
                                 std::span<double> at_targets) {
  const Query finer = inserted_->translated(query);
  finer_.resize(inserted_->mesh().vertex_count());
  if (distances.size() != mesh_->vertex_count()) {
    throw std::invalid_argument(name() + ": needs room for one distance a vertex");
  }
  solver_->solve(finer, finer_);
  std::copy_n(finer_.begin(), distances.size(), distances.begin());
  for (std::size_t i = 0; i < at_targets.size(); ++i) {
    at_targets[i] = finer_[finer.targets[i].vertex];
  }
  correct_near_sources(query, distances, at_targets);
}

// Near a source the position of a point in space has few correct digits. The length of the line
// within the face has all of them.
void PointSolver::correct_near_sources(const Query& query, std::span<double> distances,
                                       std::span<double> at_targets) const {
  const auto correct = [&](double& distance, double straight) {
    if (std::abs(distance - straight) <= 4 * inserted_->place()) distance = straight;
  };
  std::vector<std::vector<InFace>> targets;
  for (const SurfacePoint& target : query.targets) {
    targets.push_back(faces_of(*mesh_, in_internal_numbers(*mesh_, target)));
  }
  for (const Source& source : query.sources) {
    const std::vector<InFace> at = faces_of(*mesh_, in_internal_numbers(*mesh_, source.at));
    const auto line = [&](const std::vector<InFace>& to) {
      return source.distance + straight_length(*mesh_, at, to);
    };
    for (std::size_t i = 0; i < targets.size(); ++i) correct(at_targets[i], line(targets[i]));
    if (source.at.is_vertex()) continue;
    for (const InFace& face : at) {
      for (const Index corner : mesh_->triangle(face.face)) {
        correct(distances[mesh_->numbers().external_vertex(corner)],
                line(faces_of(*mesh_, InternalPoint(corner))));
      }
    }
  }
}

}  // namespace geodesic
