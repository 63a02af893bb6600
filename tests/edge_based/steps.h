// Results of the kernels for a list of windows.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "meshes/random.h"
#include "solvers/edge_based/split.h"

namespace geodesic::edge_based {

struct Steps {
  std::vector<Window> gathered;
  std::vector<Window> trimmed;
  std::vector<bool> left, right;  ///< sides of the apex that a gathered window passes
  ApexWinner winner;
  std::vector<bool> contested;
  std::vector<Window> to_left, to_right;
  std::vector<Window> odd_to_left, odd_to_right;  ///< unfolded again, without every other window
};

inline std::vector<std::uint64_t> bits_of(const std::vector<Window>& windows) {
  std::vector<std::uint64_t> bits;
  for (const Window& w : windows) {
    for (const double value : {w.begin, w.end, w.x, w.y, w.sigma}) {
      bits.push_back(std::bit_cast<std::uint64_t>(value));
    }
  }
  return bits;
}

inline std::vector<std::uint64_t> bits_of(const Steps& steps) {
  std::vector<std::uint64_t> bits = bits_of(steps.gathered);
  for (const auto* flags : {&steps.left, &steps.right, &steps.contested}) {
    bits.insert(bits.end(), flags->begin(), flags->end());
  }
  bits.push_back(steps.winner.window);
  bits.push_back(std::bit_cast<std::uint64_t>(steps.winner.distance));
  bits.push_back(std::bit_cast<std::uint64_t>(steps.winner.position));
  for (const auto* list :
       {&steps.trimmed, &steps.to_left, &steps.to_right, &steps.odd_to_left, &steps.odd_to_right}) {
    const std::vector<std::uint64_t> more = bits_of(*list);
    bits.insert(bits.end(), more.begin(), more.end());
  }
  return bits;
}

/// An edge of length 1 and an apex above it.
inline FaceFrame face_of(const Point2& apex) {
  FaceFrame f{};
  f.length = 1;
  f.apex_x = apex.x;
  f.apex_y = apex.y;
  f.left = std::hypot(f.apex_x, f.apex_y);
  f.right = std::hypot(1 - f.apex_x, f.apex_y);
  f.left_x = f.apex_x / f.left;
  f.left_y = f.apex_y / f.left;
  f.right_x = (1 - f.apex_x) / f.right;
  f.right_y = -f.apex_y / f.right;
  return f;
}

inline FaceFrame random_face(Random& random) {
  return face_of({random.between(-0.3, 1.3), random.between(0.2, 1.5)});
}

}  // namespace geodesic::edge_based
