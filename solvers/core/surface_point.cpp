#include "solvers/core/surface_point.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "solvers/core/messages.h"
#include "solvers/core/tolerance.h"

namespace geodesic {
namespace {

std::string not_in_mesh(const char* kind, Index number, Index count, const char* kinds) {
  return std::string(kind) + " " + std::to_string(number) + " is not in the mesh of " +
         std::to_string(count) + " " + kinds;
}

// Why a face is left out: the mesh does not know which of two reasons, if vertices were joined.
std::string why_left_out(const Mesh& mesh) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.numbers().external_vertex(mesh.numbers().internal_vertex(v)) == v) continue;
    return " collapsed when vertices were joined, or is avoided; name a vertex of it, or a point "
           "in another face";
  }
  return " is avoided; name a point in another face";
}

}  // namespace

SurfacePoint point_in_face(const Mesh& mesh, Index face, const std::array<double, 3>& weights) {
  SurfacePoint point;
  point.face = face;
  if (face >= mesh.external_face_count() || mesh.numbers().internal_face(face) == kNone) {
    throw std::invalid_argument(defect_of(mesh, point));
  }
  const double largest = std::ranges::max(weights);
  const bool sound = std::ranges::all_of(weights, [](double w) { return w >= 0 && w < kInfinity; });
  if (!sound || !(largest > 0)) {
    throw std::invalid_argument(
        "the weights of a point in a face must be finite, none negative, "
        "and not all 0");
  }
  double sum = 0;  // of numbers up to 1: the sum of the weights themselves may overflow
  for (const double w : weights) sum += w / largest;
  for (std::size_t k = 0; k < 3; ++k) {
    point.weights[k] = weights[k] / largest / sum;
    if (point.weights[k] == 1) {
      return mesh.numbers().external_vertex(mesh.triangle(mesh.numbers().internal_face(face))[k]);
    }
  }
  return point;
}

SurfacePoint point_on_edge(const Mesh& mesh, Index a, Index b, double share) {
  for (const Index v : {a, b}) {
    if (v >= mesh.vertex_count()) throw std::invalid_argument(defect_of(mesh, SurfacePoint(v)));
  }
  if (!(share >= 0 && share <= 1)) {
    throw std::invalid_argument("the share of an edge must lie between 0 and 1");
  }
  const Index own_a = mesh.numbers().internal_vertex(a), own_b = mesh.numbers().internal_vertex(b);
  for (const Index h : mesh.outgoing(own_a)) {
    const Index into = Mesh::previous(h);
    if (mesh.head(h) != own_b && mesh.origin(into) != own_b) continue;
    std::array<double, 3> weights{};
    weights[h % 3] = 1 - share;
    weights[mesh.head(h) == own_b ? (h + 1) % 3 : into % 3] = share;
    return point_in_face(mesh, mesh.numbers().external_face(h / 3), weights);
  }
  throw std::invalid_argument("no edge joins vertices " + std::to_string(a) + " and " +
                              std::to_string(b));
}

Vec3 position_of(const Mesh& mesh, const InternalPoint& point) {
  if (point.is_vertex()) return mesh.position(point.vertex);
  const Triangle corners = mesh.triangle(point.face);
  Vec3 position{};
  for (std::size_t k = 0; k < 3; ++k) {
    position = add(position, scale(point.weights[k], mesh.position(corners[k])));
  }
  return position;
}

Vec3 position_of(const Mesh& mesh, const SurfacePoint& point) {
  const std::string defect = defect_of(mesh, point);
  if (!defect.empty()) throw std::invalid_argument(defect);
  return position_of(mesh, in_internal_numbers(mesh, point));
}

std::string defect_of(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) {
    if (point.face != kNone) {
      return "point is vertex " + std::to_string(point.vertex) + " and in face " +
             std::to_string(point.face) + ": one of the two must be kNone";
    }
    if (point.vertex < mesh.vertex_count()) return {};
    return not_in_mesh("vertex", point.vertex, mesh.vertex_count(), "vertices");
  }
  if (point.face == kNone) return "point is neither a vertex nor in a face";
  if (point.face >= mesh.external_face_count()) {
    return not_in_mesh("face", point.face, mesh.external_face_count(), "faces");
  }
  if (mesh.numbers().internal_face(point.face) == kNone) {
    return "face " + std::to_string(point.face) + why_left_out(mesh);
  }
  const auto& w = point.weights;
  const bool in_range = std::ranges::all_of(w, [](double x) { return x >= 0 && x < 1; });
  if (in_range && std::ranges::count(w, 0.0) <= 1 &&
      std::abs(w[0] + w[1] + w[2] - 1) <= kWeightSum) {
    return {};
  }
  return "point in face " + std::to_string(point.face) + " has the weights " +
         significant(w[0], 6) + ", " + significant(w[1], 6) + ", " + significant(w[2], 6) +
         ": none may be negative, their sum must be 1, and at most one may be 0";
}

InternalPoint in_internal_numbers(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return InternalPoint(mesh.numbers().internal_vertex(point.vertex));
  InternalPoint own;
  own.face = mesh.numbers().internal_face(point.face);
  own.weights = point.weights;
  return own;
}

SurfacePoint in_external_numbers(const Mesh& mesh, const InternalPoint& point) {
  if (point.is_vertex()) return mesh.numbers().external_vertex(point.vertex);
  SurfacePoint given;
  given.face = mesh.numbers().external_face(point.face);
  given.weights = point.weights;
  return given;
}

namespace {

/// The point of edge h with these weights of the edge's ends.
InternalPoint on_half_edge(Index h, double at_origin, double at_head) {
  InternalPoint point;
  point.face = h / 3;
  point.weights[h % 3] = at_origin;
  point.weights[Mesh::next(h) % 3] = at_head;
  return point;
}

/// The same point in the other image of its face.
InternalPoint mirrored(const Mesh& mesh, InternalPoint point) {
  point.face = mesh.mirrored(3 * point.face) / 3;
  std::swap(point.weights[1], point.weights[2]);
  return point;
}

}  // namespace

std::vector<InternalPoint> in_every_face(const Mesh& mesh, const InternalPoint& point) {
  std::vector<InternalPoint> images = {point};
  const Index under = edge_under(point);
  if (under != kNone) {
    const double at_origin = point.weights[under % 3];
    const double at_head = point.weights[Mesh::next(under) % 3];
    mesh.for_each_sheet(
        under, [&](Index g) { images.push_back(on_half_edge(mesh.twin(g), at_head, at_origin)); });
  }
  if (!mesh.crosses_non_manifold_edges()) return images;
  for (std::size_t i = 0, seen = images.size(); i < seen; ++i) {
    images.push_back(mirrored(mesh, images[i]));
  }
  return images;
}

InternalPoint in_given_face(const Mesh& mesh, const InternalPoint& point) {
  const bool is_image = !point.is_vertex() && point.face >= mesh.given_face_count();
  return is_image ? mirrored(mesh, point) : point;
}

}  // namespace geodesic
