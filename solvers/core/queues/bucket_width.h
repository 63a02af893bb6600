// How wide the buckets of queues are.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "solvers/core/mesh.h"

namespace geodesic {

/// The width that Xu, Wang, Liu, Liu, He 2015 publish for FWP, in the mesh's unit of length.
inline double published_bucket_width(const Mesh& mesh) {
  return mesh.mean_edge_length() / std::sqrt(static_cast<double>(mesh.vertex_count()));
}

/// For a PriorityQueue. Measured: ICH is fastest at a sixteenth of the published width, within 5%
/// from an eighth to a thirty-second.
inline double priority_bucket_width(const Mesh& mesh) { return published_bucket_width(mesh) / 16; }

/// For a PriorityQueue of that width: from two to four mean edge lengths, since a child's key lies
/// up to about one edge ahead of its parent's. The buckets become narrower as meshes become finer.
inline std::size_t priority_bucket_count(const Mesh& mesh) {
  const double an_edge = 16 * std::sqrt(static_cast<double>(mesh.vertex_count()));
  return std::bit_ceil(static_cast<std::size_t>(std::max(2 * an_edge, 1024.0)));
}

}  // namespace geodesic
