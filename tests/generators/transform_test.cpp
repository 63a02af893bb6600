// The generator transform: each parameter has its documented effect and no other.
#include <gtest/gtest.h>

#include "meshes/defects.h"
#include "tests/generators/generator_test.h"

namespace geodesic {
namespace {

class Transform : public InputFiles {
 protected:
  TriangleSoup transformed(const TriangleSoup& soup, const GeneratorParameters& parameters) {
    return made("transform", soup, parameters);
  }
  const TriangleSoup saddle_ = generate("saddle-cone", {{"rings", 2}});
};

TEST_F(Transform, ChangesNothingByDefault) { expect_same(transformed(saddle_, {}), saddle_); }

TEST_F(Transform, ScalesFirstAndShiftsThen) {
  const TriangleSoup soup = transformed(saddle_, {{"scale", 0.5}, {"shift", 1024}});
  EXPECT_EQ(soup.triangles, saddle_.triangles);
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(soup.positions[v][k], 0.5 * saddle_.positions[v][k] + 1024);
    }
  }
}

TEST_F(Transform, WithoutItsFirstFaceASaddleLiesOnTheBoundary) {
  const TriangleSoup soup = transformed(saddle_, {{"without", 1}});
  EXPECT_EQ(soup.triangles.size(), saddle_.triangles.size() - 1);
  EXPECT_EQ(soup.positions, saddle_.positions);
  EXPECT_EQ(summarize(saddle_).boundary_loops, 1u);
  EXPECT_EQ(summarize(soup).boundary_loops, 2u);
}

TEST_F(Transform, FacesWithVerticesOfTheirOwnAreComponents) {
  const TriangleSoup soup = transformed(saddle_, {{"vertices", "own"}});
  EXPECT_EQ(soup.positions.size(), 3 * saddle_.triangles.size());
  EXPECT_EQ(summarize(soup).components, saddle_.triangles.size());
  EXPECT_NEAR(area_of(soup), area_of(saddle_), 1e-15);
}

TEST_F(Transform, APinchedMeshHangsTogetherAtOneVertex) {
  const TriangleSoup soup = transformed(saddle_, {{"pinched", "yes"}});
  const std::size_t vertices = saddle_.positions.size();
  EXPECT_EQ(soup.positions.size(), 2 * vertices - 1);
  EXPECT_EQ(soup.triangles.size(), 2 * saddle_.triangles.size());
  EXPECT_EQ(summarize(soup).components, 1u);
  EXPECT_FALSE(find_defects(soup).has_errors());
  for (std::size_t v = 1; v < vertices; ++v) {
    EXPECT_EQ(soup.positions[vertices - 1 + v], scale(-1, saddle_.positions[v]));
  }
}

TEST_F(Transform, CopiesLieApartAndIsolatedVerticesComeLast) {
  const TriangleSoup soup = transformed(saddle_, {{"copies", 3}, {"isolated", 2}});
  const MeshSummary summary = summarize(soup);
  EXPECT_EQ(summary.components, 3u);
  EXPECT_EQ(summary.isolated_vertices, 2u);
  EXPECT_EQ(soup.positions.size(), 3 * saddle_.positions.size() + 2);
  EXPECT_NEAR(area_of(soup), 3 * area_of(saddle_), 1e-14);
}

}  // namespace
}  // namespace geodesic
