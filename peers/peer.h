// What the adapters of peers share: the mesh as the flat arrays that most codes begin with, and the
// distances that they end with.
//
// An adapter converts the mesh, asks the authors' code, and converts its answer. It adds no checks
// and no repairs: what the code does is what is measured.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/core/registry.h"

namespace geodesic::peer {

/// "-O3 -march=native, 12% faster than its authors' -O2": made by peers/build.py.
const char* built_with();

/// The remarks of a description: what is to be known of a peer, and what it was built with.
inline std::string remarks(const std::string& known) {
  return known + "; compiled with " + built_with();
}

/// Whether a solve is to fill in what the authors' code counts.
inline bool counts(const Recording* recording) {
  return recording != nullptr && recording->kind != RecordingKind::phase_times;
}

/// x, y, z of every vertex.
inline std::vector<double> coordinates(const Mesh& mesh) {
  std::vector<double> all;
  all.reserve(3 * std::size_t{mesh.vertex_count()});
  for (const Vec3& p : mesh.positions()) all.insert(all.end(), p.begin(), p.end());
  return all;
}

/// The three vertices of every face.
template <class Number>
std::vector<Number> corners(const Mesh& mesh) {
  std::vector<Number> all;
  all.reserve(mesh.half_edge_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    all.push_back(static_cast<Number>(mesh.origin(h)));
  return all;
}

/// The point of the edge from a to b, so much of the way; an end of it where rounding goes beyond.
inline InternalPoint on_edge(const Mesh& mesh, Index a, Index b, double share) {
  if (!(share > 0)) return InternalPoint(a);
  if (!(share < 1)) return InternalPoint(b);
  for (const Index h : mesh.outgoing(a)) {
    if (mesh.head(h) != b && mesh.apex(h) != b) continue;
    InternalPoint point;
    point.face = h / 3;
    point.weights[h % 3] = 1 - share;
    point.weights[(mesh.head(h) == b ? Mesh::next(h) : Mesh::previous(h)) % 3] = share;
    return point;
  }
  throw std::invalid_argument("no edge has the point of a path");
}

/// Answers with the distances that the authors' code has found.
/// @param infinity what it gives, or less, for vertices that it does not reach
/// @param found the distance by vertex
template <class Found>
void answer(std::span<double> distances, double infinity, const Found& found) {
  for (Index v = 0; v < distances.size(); ++v) {
    const double d = found(v);
    if (!(d >= infinity)) distances[v] = d;  // not a number stays what it is
  }
}

}  // namespace geodesic::peer
