// Common code of the adapters of peers: the mesh as flat arrays, which most codes need as input,
// and the conversion of their distances.
//
// An adapter converts the mesh, calls the authors' code, and converts its answer. It adds no checks
// and no repairs, so that the measurement shows the code itself.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "solvers/core/registry.h"

namespace geodesic::peer {

/// Returns the text of peers/build.py about the compiler flags.
const char* built_with();

/// Returns the remarks of a description: the facts about a peer, and its compiler flags.
inline std::string remarks(const std::string& known) {
  return known + "; compiled with " + built_with();
}

/// Whether a recording takes the counters of the authors' code.
inline bool counts(const Recording& recording) {
  return recording.kind != RecordingKind::phase_times;
}

/// Returns x, y, z of every vertex.
inline std::vector<double> coordinates(const Mesh& mesh) {
  std::vector<double> all;
  all.reserve(3 * std::size_t{mesh.vertex_count()});
  for (const Vec3& p : mesh.positions()) all.insert(all.end(), p.begin(), p.end());
  return all;
}

/// Returns the three vertices of every face.
template <class Number>
std::vector<Number> corners(const Mesh& mesh) {
  std::vector<Number> all;
  all.reserve(mesh.half_edge_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h)
    all.push_back(static_cast<Number>(mesh.origin(h)));
  return all;
}

/// Returns the point at a share of the edge from a to b; an end of the edge if rounding exceeds it.
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

/// Writes the distances that the authors' code has found.
/// @param infinity distances of at least this value mean that a vertex is not reached
/// @param found function that returns the distance of a vertex
template <class Found>
void answer(std::span<double> distances, double infinity, const Found& found) {
  for (Index v = 0; v < distances.size(); ++v) {
    const double d = found(v);
    if (!(d >= infinity)) distances[v] = d;  // NaN is kept
  }
}

}  // namespace geodesic::peer
