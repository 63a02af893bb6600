#include "solvers/chen_han/shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solvers/core/tolerance.h"

namespace geodesic::chen_han {
namespace {

/// `faces` equal triangles around vertex 0 whose angles add up to `angle`. They form a zigzag cone,
/// which bends up and down at every second spoke so that the angle may exceed 2 pi.
Mesh fan(Index faces, double angle, bool closed) {
  const double corner = angle / faces;
  const double turn = std::min(corner, 2 * std::numbers::pi / faces);
  // Spokes of length 1 at heights +z, -z: their angle is `corner` when
  // cos(corner) = (1 - z^2) cos(turn) - z^2.
  const double z2 = (std::cos(turn) - std::cos(corner)) / (1 + std::cos(turn));
  TriangleSoup soup;
  soup.positions.push_back({0, 0, 0});
  for (Index i = 0; i < faces + (closed ? 0 : 1); ++i) {
    const double r = std::sqrt(1 - z2), z = (i % 2 == 0 ? 1 : -1) * std::sqrt(z2);
    soup.positions.push_back({r * std::cos(i * turn), r * std::sin(i * turn), z});
  }
  const Index rim = static_cast<Index>(soup.positions.size()) - 1;
  for (Index i = 0; i < faces; ++i) soup.triangles.push_back({0, 1 + i, 1 + (i + 1) % rim});
  return Mesh(soup);
}

/// Sum of the angles at vertex 0 under which the shadowed parts are seen.
double shadow_angle(const Mesh& mesh, const Incoming& incoming) {
  std::vector<ShadowedEdge> edges;
  find_shadow(mesh, 0, incoming, edges);
  double sum = 0;
  for (const ShadowedEdge& edge : edges) {
    const HalfEdge& e = mesh.half_edge(edge.across);
    const double x = e.length - e.apex_x, y = e.apex_y;
    sum += std::atan2(edge.end - x, y) - std::atan2(edge.begin - x, y);
  }
  return sum;
}

Incoming towards(const Mesh& mesh, Index corner, double part) {
  const HalfEdge& e = mesh.half_edge(corner);
  const double angle = part * std::atan2(e.apex_y, e.apex_x);
  return {corner, 3 * std::cos(angle), 3 * std::sin(angle)};
}

TEST(ChenHanShadow, OfASaddleIsAsWideAsItsExcessAngleFromEveryDirection) {
  for (const double excess : {1e-6, 0.1, 1.0, 2.5}) {
    const Mesh mesh = fan(8, 2 * std::numbers::pi + excess, true);
    for (const Index corner : mesh.outgoing(0)) {
      for (const double part : {0.0, 0.3, 0.9, 1.0}) {
        EXPECT_NEAR(shadow_angle(mesh, towards(mesh, corner, part)), excess + 2 * kShadowMargin,
                    1e-9)
            << "corner " << corner << " part " << part;
      }
    }
  }
}

TEST(ChenHanShadow, OfASourceIsEverything) {
  const Mesh mesh = fan(8, 7.0, true);
  EXPECT_NEAR(shadow_angle(mesh, {}), 7.0, 1e-12);
}

TEST(ChenHanShadow, AtABoundaryLiesBeyondAStraightLine) {
  // Six faces of 60 degrees with a slit between the last and the first spoke. For a line that
  // arrives at angle a from the slit, 180 degrees + a of the other side are lit.
  const Mesh mesh = fan(6, 2 * std::numbers::pi, false);
  for (const double part : {0.1, 0.5, 0.9}) {
    const double from_slit = part * std::numbers::pi / 3;
    EXPECT_NEAR(shadow_angle(mesh, towards(mesh, 0, part)),
                std::numbers::pi - from_slit + kShadowMargin, 1e-9)
        << part;
  }
}

TEST(ChenHanShadow, AConvexBoundaryVertexHasNone) {
  const Mesh mesh = fan(3, 2.5, false);
  EXPECT_EQ(shadow_angle(mesh, towards(mesh, 0, 0.5)), 0.0);
}

}  // namespace
}  // namespace geodesic::chen_han
