// Isolines against truths that know nothing of windows.
#include "harness/recordings/isolines/isolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "harness/recordings/isolines/crossings.h"
#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/oracles/brute_force.h"
#include "meshes/oracles/random_meshes.h"
#include "meshes/random.h"
#include "tests/isolines/traced.h"

namespace geodesic::harness {
namespace {

constexpr double kExact = 1e-9;  // relative

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

bool on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return distance(p, a) + distance(p, b) <= distance(a, b) * (1 + 1e-12);
}

/// By how much a point misses the plane of a triangle or lies beyond one of its sides, over its
/// size; its barycentric coordinates.
struct Place {
  double miss;
  std::array<double, 3> weights;
};
Place place_in(const TriangleSoup& soup, Index face, const Vec3& p) {
  const auto [a, b, c] = soup.triangles[face];
  const Vec3 &pa = soup.positions[a], &pb = soup.positions[b], &pc = soup.positions[c];
  const auto dot = [](const Vec3& u, const Vec3& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  Vec3 u, v, w;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = pb[k] - pa[k];
    v[k] = pc[k] - pa[k];
    w[k] = p[k] - pa[k];
  }
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const double area = uu * vv - uv * uv;
  const double s = (vv * wu - uv * wv) / area, t = (uu * wv - uv * wu) / area;
  Vec3 rest;
  for (std::size_t k = 0; k < 3; ++k) rest[k] = w[k] - s * u[k] - t * v[k];
  const double beyond = std::max({0.0, -s, -t, s + t - 1});
  return {beyond + std::sqrt(dot(rest, rest) / std::max(uu, vv)), {1 - s - t, s, t}};
}

std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> all = random_meshes();
  all.push_back({"box", generate("box", {{"x-cells", 4}, {"y-cells", 3}, {"z-cells", 2}})});
  all.push_back({"cone", generate("cone", {{"sectors", 5}, {"angle", 200}, {"rings", 4}})});
  all.push_back({"saddle", generate("saddle-cone", {{"sectors", 6}, {"sector-angle", 80}})});
  all.push_back({"square_with_hole", generate("square-with-hole", {{"hole", 3}, {"rim", 2}})});
  all.push_back({"ragged", with_missing_faces(rough_terrain(11, 8, 8, 1), 5, 8)});
  all.push_back({"two_spheres", side_by_side(rough_sphere(12, 1, 0.2), rough_sphere(13, 1, 0.2))});
  return all;
}

class IsolinesOf : public ::testing::TestWithParam<std::string> {};

TEST_P(IsolinesOf, APlaneAreWholeCirclesAboutTheSource) {
  const TriangleSoup soup = generate("grid", {{"columns", 12}, {"rows", 10}});
  const Index source = 5 * 13 + 6;
  const Vec3& centre = soup.positions[source];
  const Mesh mesh(soup);
  const Traced traced = trace(GetParam(), mesh, {{.at = source}});
  std::map<double, double> turned;
  for (std::size_t i = 0; i < traced.isolines.pieces.size(); ++i) {
    const double level = traced.isolines.pieces[i].level;
    const auto points = traced.points(i);
    for (const Vec3& p : points) ASSERT_NEAR(distance(p, centre), level, kExact * level);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const double chord = distance(points[k], points[k + 1]);
      const double error = level - std::sqrt(level * level - 0.25 * chord * chord);
      EXPECT_LE(error, kIsolineError * mesh.mean_edge_length()) << "at level " << level;
      turned[level] += 2 * std::asin(0.5 * chord / level);
    }
  }
  for (const double level : traced.levels) {
    if (level > 5) break;  // beyond the nearest border
    EXPECT_NEAR(turned[level], 2 * std::numbers::pi, kExact) << "level " << level;
  }
}

// Splits faces so that points on them become vertices.
class Inserter {
 public:
  explicit Inserter(const TriangleSoup& soup) : soup_(soup), split_(soup.triangles.size(), false) {}

  /// @return whether no other point lies in the same face
  bool insert(Index face, const Vec3& p) {
    if (split_[face]) return false;
    const auto weights = place_in(soup_, face, p).weights;
    const std::size_t least =
        static_cast<std::size_t>(std::ranges::min_element(weights) - weights.begin());
    if (weights[least] > 1e-9) return split_face(face, p);
    return split_edge(soup_.triangles[face][(least + 1) % 3],
                      soup_.triangles[face][(least + 2) % 3], p);
  }

  const TriangleSoup& soup() const { return soup_; }

 private:
  bool split_face(Index face, const Vec3& p) {
    const auto [a, b, c] = soup_.triangles[face];
    const Index v = add(p);
    replace(face, {a, b, v});
    soup_.triangles.insert(soup_.triangles.end(), {{b, c, v}, {c, a, v}});
    return true;
  }

  bool split_edge(Index a, Index b, const Vec3& p) {
    std::vector<Index> faces;
    for (Index f = 0; f < soup_.triangles.size(); ++f) {
      const Triangle& t = soup_.triangles[f];
      if (std::ranges::count(t, a) + std::ranges::count(t, b) == 2) faces.push_back(f);
    }
    const auto taken = [&](Index f) { return f >= split_.size() || split_[f]; };
    if (std::ranges::any_of(faces, taken)) return false;
    const Index v = add(p);
    for (const Index f : faces) {
      Triangle with_a = soup_.triangles[f], with_b = with_a;
      std::ranges::replace(with_a, b, v);
      std::ranges::replace(with_b, a, v);
      replace(f, with_a);
      soup_.triangles.push_back(with_b);
    }
    return true;
  }

  Index add(const Vec3& p) {
    soup_.positions.push_back(p);
    return static_cast<Index>(soup_.positions.size() - 1);
  }

  void replace(Index face, const Triangle& by) {
    soup_.triangles[face] = by;
    split_[face] = true;
  }

  TriangleSoup soup_;
  std::vector<bool> split_;  // by face as given
};

// Points of isolines become vertices of a finer mesh of the same surface, on which brute force
// gives their distances.
void check_by_brute_force(const std::string& solver, const NamedMesh& named, int most_points) {
  const Mesh mesh(named.soup, Numbering::along_surface);
  const Index source = 4;
  const Traced traced = trace(solver, mesh, {{.at = source}});
  ASSERT_FALSE(traced.isolines.pieces.empty()) << named.name;
  Inserter inserter(named.soup);
  std::vector<double> wanted;
  Random random(1);
  const auto pieces = static_cast<std::uint32_t>(traced.isolines.pieces.size());
  for (int tries = 0; tries < 20 * most_points && std::ssize(wanted) < most_points; ++tries) {
    const std::uint32_t piece = random.below(pieces);
    const auto points = traced.points(piece);
    const Vec3& p = points[random.below(static_cast<std::uint32_t>(points.size()))];
    const auto& [face, level, first] = traced.isolines.pieces[piece];
    if (inserter.insert(face, p)) wanted.push_back(level);
  }
  const auto truth = brute_force_distances(Mesh(inserter.soup()), source);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double got = truth[named.soup.positions.size() + i];
    EXPECT_NEAR(got, wanted[i], kExact * wanted[i]) << named.name << ", point " << i;
  }
}

TEST_P(IsolinesOf, SmallMeshesLieWhereBruteForceSays) {
  for (const NamedMesh& named : meshes()) check_by_brute_force(GetParam(), named, 60);
}

TEST_P(IsolinesOf, AMeshWithAFaceWithoutAreaLieWhereBruteForceSays) {
  TriangleSoup soup = rough_terrain(14, 6, 6, 1);
  const auto [a, b, c] = soup.triangles[30];
  const Index middle = static_cast<Index>(soup.positions.size());
  soup.positions.push_back(soup.positions[a]);
  for (std::size_t k = 0; k < 3; ++k) {
    soup.positions.back()[k] = 0.5 * (soup.positions[a][k] + soup.positions[b][k]);
  }
  soup.triangles[30] = {a, middle, c};
  soup.triangles.insert(soup.triangles.end(), {{middle, b, c}, {a, b, middle}});
  check_by_brute_force(GetParam(), {"flat cap", soup}, 20);
}

// The ends of lines, by level and bits: lines of two faces meet at each, but on the border.
TEST_P(IsolinesOf, SmallMeshesGoOnAcrossEdges) {
  for (const NamedMesh& named : meshes()) {
    const Mesh mesh(named.soup);
    const Traced traced = trace(GetParam(), mesh, {{.at = 4}});
    std::map<std::pair<double, Vec3>, int> ends;
    for (std::size_t i = 0; i < traced.isolines.pieces.size(); ++i) {
      const auto points = traced.points(i);
      ASSERT_GE(points.size(), 2u) << named.name;
      if (points.front() == points.back()) continue;
      ++ends[{traced.isolines.pieces[i].level, points.front()}];
      ++ends[{traced.isolines.pieces[i].level, points.back()}];
    }
    const auto on_border = [&](const Vec3& p) {
      for (Index h = 0; h < mesh.half_edge_count(); ++h) {
        if (mesh.twin(h) == kNone &&
            on_segment(p, mesh.position(mesh.origin(h)), mesh.position(mesh.head(h)))) {
          return true;
        }
      }
      return false;
    };
    for (const auto& [end, lines] : ends) {
      const auto& [level, p] = end;
      EXPECT_TRUE(lines % 2 == 0 || on_border(p))
          << named.name << ": " << lines << " lines of level " << level << " end at (" << p[0]
          << ", " << p[1] << ", " << p[2] << ")";
    }
  }
}

// The distance along an edge at many points: the least over the windows and the ways along the
// edge, which no window stands for when the edge lies on a straight line with an earlier one.
std::vector<double> distances_along(const EdgeDistance& edge) {
  std::vector<double> positions;
  for (int i = 0; i <= 1000; ++i) positions.push_back(edge.length * i / 1000);
  for (const Window& w : edge.windows) {
    positions.insert(positions.end(), {w.begin, nearest_position(w), w.end});
  }
  std::ranges::sort(positions);
  std::vector<double> distances;
  for (const double t : positions) {
    double distance = std::min(edge.at_origin + t, edge.at_head + (edge.length - t));
    for (const Window& w : edge.windows) {
      if (w.begin <= t && t <= w.end) distance = std::min(distance, distance_at(w, t));
    }
    distances.push_back(distance);
  }
  return distances;
}

// How often a sequence passes a level.
std::size_t sign_changes(const std::vector<double>& distances, double level) {
  std::size_t changes = 0;
  for (std::size_t i = 0; i + 1 < distances.size(); ++i) {
    changes += (distances[i] < level) != (distances[i + 1] < level) ? 1u : 0u;
  }
  return changes;
}

TEST_P(IsolinesOf, SmallMeshesCrossEdgesAsOftenAsTheDistancePassesTheLevel) {
  for (const NamedMesh& named : meshes()) {
    const Mesh mesh(named.soup);
    // Levels that no vertex of a regular mesh is on.
    Traced traced = trace(GetParam(), mesh, {{.at = 4}});
    for (double& level : traced.levels) level *= 0.9973;
    traced = trace(GetParam(), mesh, {{.at = 4}}, traced.levels);
    std::map<std::pair<Index, double>, std::set<Vec3>> crossings;  // by edge and level
    for (std::size_t i = 0; i < traced.isolines.pieces.size(); ++i) {
      const auto points = traced.points(i);
      if (points.front() == points.back()) continue;
      const auto& [face, level, first] = traced.isolines.pieces[i];
      for (const Vec3& p : {points.front(), points.back()}) {
        for (Index h = 3 * face; h < 3 * face + 3; ++h) {
          if (on_segment(p, mesh.position(mesh.origin(h)), mesh.position(mesh.head(h)))) {
            crossings[{std::min(h, mesh.twin(h)), level}].insert(p);
          }
        }
      }
    }
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      if (mesh.twin(h) < h) continue;
      const auto along = distances_along({.windows = traced.windows[h],
                                          .length = mesh.half_edge(h).length,
                                          .at_origin = traced.distances[mesh.origin(h)],
                                          .at_head = traced.distances[mesh.head(h)]});
      for (const double level : traced.levels) {
        const auto found = crossings.find({h, level});
        const std::size_t drawn = found == crossings.end() ? 0 : found->second.size();
        EXPECT_EQ(drawn, sign_changes(along, level))
            << named.name << ", half-edge " << h << ", level " << level;
      }
    }
  }
}

TEST_P(IsolinesOf, SmallMeshesLieInTheFacesTheyName) {
  for (const NamedMesh& named : meshes()) {
    const Mesh mesh(named.soup, Numbering::along_surface);
    const Traced traced = trace(GetParam(), mesh, {{.at = 4}, {.at = 9, .distance = 0.1}});
    for (std::size_t i = 0; i < traced.isolines.pieces.size(); ++i) {
      for (const Vec3& p : traced.points(i)) {
        EXPECT_LE(place_in(named.soup, traced.isolines.pieces[i].face, p).miss, 1e-12)
            << named.name << ", piece " << i;
      }
    }
  }
}

// On a regular tetrahedron with edges of length 1 the middle of the face opposite to the source is
// farther than any vertex; paths arrive across its three edges.
TEST_P(IsolinesOf, ATetrahedronCloseAroundTheFarthestPointInsideAFace) {
  const double s = std::sqrt(0.125);
  const TriangleSoup soup{{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}}};
  const Traced traced = trace(GetParam(), Mesh(soup), {{.at = 0}}, {1.1});
  ASSERT_EQ(traced.isolines.pieces.size(), 1u);
  EXPECT_EQ(traced.isolines.pieces[0].face, 3u);
  const auto points = traced.points(0);
  EXPECT_EQ(points.front(), points.back());
  // The source, unfolded across the edge opposite to each corner: the corner mirrored in the middle
  // of that edge.
  std::set<std::size_t> images;
  for (const Vec3& p : points) {
    double nearest = kInfinity;
    std::size_t image = 0;
    for (std::size_t corner = 1; corner < 4; ++corner) {
      Vec3 mirrored;
      for (std::size_t k = 0; k < 3; ++k) {
        mirrored[k] = -2 * soup.positions[corner][k];
        for (std::size_t v = 1; v < 4; ++v) mirrored[k] += soup.positions[v][k];
      }
      if (distance(p, mirrored) < nearest) image = corner;
      nearest = std::min(nearest, distance(p, mirrored));
    }
    EXPECT_NEAR(nearest, 1.1, kExact);
    images.insert(image);
  }
  EXPECT_EQ(images.size(), 3u) << "arcs about three images";
}

INSTANTIATE_TEST_SUITE_P(Solvers, IsolinesOf, ::testing::ValuesIn(solvers_with_windows()),
                         [](const auto& solver) {
                           std::string name = solver.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(IsolineLevels, DivideTheGreatestFiniteDistanceEqually) {
  const std::vector<double> levels = isoline_levels(std::vector{0.0, 8.0, kInfinity, 3.0});
  ASSERT_EQ(levels.size(), 39u);
  EXPECT_DOUBLE_EQ(levels.front(), 0.2);
  EXPECT_DOUBLE_EQ(levels.back(), 7.8);
  EXPECT_TRUE(isoline_levels(std::vector{0.0, kInfinity}).empty());
}

TEST(IsolineLevels, EncloseTheShareOfReachedVerticesThatIsAskedForAndMeetNone) {
  const std::vector distances = {40.0, kInfinity, 1.3, 0.0, 20.5, 5.2, kInfinity};
  const std::vector<double> levels = isoline_levels(distances, std::vector{0.2, 0.5, 0.6});
  ASSERT_EQ(levels.size(), 39u + 2);  // two of the shares enclose the same vertices
  EXPECT_TRUE(std::ranges::is_sorted(levels));
  EXPECT_TRUE(std::ranges::binary_search(levels, (0.0 + 1.3) / 2));
  EXPECT_TRUE(std::ranges::binary_search(levels, (5.2 + 20.5) / 2));
}

TEST(IsolineLevels, AreAboveZeroWhereVerticesCoincideWithTheSource) {
  const std::vector<double> levels =
      isoline_levels(std::vector{0.0, 0.0, 0.0, 8.0}, std::vector{0.25});
  ASSERT_EQ(levels.size(), 39u);
  EXPECT_GT(levels.front(), 0);
}

}  // namespace
}  // namespace geodesic::harness
