// One number for all bits of a mesh.
#pragma once

#include <cstdint>
#include <cstring>

#include "solvers/core/geometry.h"

namespace geodesic::testing {

/// FNV-1a over the bytes of all coordinates and indices.
inline std::uint64_t hash_of(const TriangleSoup& soup) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](const auto& element) {
    unsigned char bytes[sizeof element];
    std::memcpy(bytes, &element, sizeof element);
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
  };
  for (const Vec3& position : soup.positions) add(position);
  for (const Triangle& face : soup.triangles) add(face);
  return hash;
}

}  // namespace geodesic::testing
