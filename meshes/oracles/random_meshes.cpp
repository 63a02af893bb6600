#include "meshes/oracles/random_meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"
#include "meshes/random.h"

namespace geodesic {
namespace {

void add_cell(TriangleSoup& soup, Index a, Index b, Index c, Index d, Random& random) {
  if (random.below(2) == 0) {
    soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
  } else {
    soup.triangles.insert(soup.triangles.end(), {{a, b, d}, {b, c, d}});
  }
}

}  // namespace

TriangleSoup rough_terrain(std::uint64_t seed, Index columns, Index rows, double relief) {
  Random random(seed);
  TriangleSoup soup;
  for (Index j = 0; j <= rows; ++j) {
    for (Index i = 0; i <= columns; ++i) {
      const double x = i + random.between(-0.3, 0.3), y = j + random.between(-0.3, 0.3);
      soup.positions.push_back({x, y, random.between(0, relief)});
    }
  }
  const Index row = columns + 1;
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * row + i;
      add_cell(soup, a, a + 1, a + row + 1, a + row, random);
    }
  }
  return soup;
}

TriangleSoup rough_sphere(std::uint64_t seed, int levels, double noise) {
  Random random(seed);
  TriangleSoup soup = generate("icosphere", {{"frequency", 1 << levels}});
  for (Vec3& p : soup.positions) p = scale(random.between(1 - noise, 1 + noise), p);
  return soup;
}

TriangleSoup rough_torus(std::uint64_t seed, Index around, Index across, double noise) {
  Random random(seed);
  TriangleSoup soup;
  for (Index j = 0; j < across; ++j) {
    for (Index i = 0; i < around; ++i) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double tube = random.between(1 - noise, 1 + noise), r = 2.5 + tube * std::cos(v);
      soup.positions.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
    }
  }
  for (Index j = 0; j < across; ++j) {
    for (Index i = 0; i < around; ++i) {
      const Index right = (i + 1) % around, up = (j + 1) % across * around;
      add_cell(soup, j * around + i, j * around + right, up + right, up + i, random);
    }
  }
  return soup;
}

TriangleSoup with_holes(TriangleSoup soup, std::uint64_t seed, Index holes) {
  Random random(seed);
  std::vector<bool> taken = boundary_vertices(soup);  // then also those at or beside a hole
  const auto touches = [](const Triangle& t, Index v) { return std::ranges::count(t, v) > 0; };
  for (Index made = 0, tries = 0; made < holes && tries < 1000; ++tries) {
    const Index centre = random.below(static_cast<Index>(soup.positions.size()));
    const auto star_is_free = std::ranges::all_of(soup.triangles, [&](const Triangle& t) {
      return !touches(t, centre) || std::ranges::none_of(t, [&](Index v) { return taken[v]; });
    });
    if (taken[centre] || !star_is_free) continue;
    for (const Triangle& t : soup.triangles) {
      if (touches(t, centre)) {
        for (const Index v : t) taken[v] = true;
      }
    }
    std::erase_if(soup.triangles, [&](const Triangle& t) { return touches(t, centre); });
    ++made;
  }
  return soup;
}

TriangleSoup with_missing_faces(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in) {
  Random random(seed);
  std::erase_if(soup.triangles, [&](const Triangle&) { return random.below(one_in) == 0; });
  return soup;
}

TriangleSoup with_collapsed_edges(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in) {
  Random random(seed);
  for (const Triangle& t : soup.triangles) {
    if (random.below(one_in) == 0) soup.positions[t[0]] = soup.positions[t[1]];
  }
  return soup;
}

TriangleSoup with_flat_caps(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in) {
  Random random(seed);
  const std::size_t faces = soup.triangles.size();
  for (std::size_t f = 0; f < faces; ++f) {
    if (random.below(one_in) != 0) continue;
    const auto [a, b, c] = soup.triangles[f];
    const Vec3 middle = scale(0.5, add(soup.positions[a], soup.positions[b]));
    const Index m = static_cast<Index>(soup.positions.size());
    soup.positions.push_back(middle);
    soup.triangles[f] = {a, m, c};
    soup.triangles.push_back({m, b, c});
    soup.triangles.push_back({a, b, m});
  }
  return soup;
}

std::vector<NamedMesh> random_meshes() {
  return {
      {"rough_terrain", rough_terrain(1, 9, 9, 1.5)},
      {"steep_terrain", rough_terrain(2, 8, 8, 6)},
      {"terrain_with_holes", with_holes(rough_terrain(3, 9, 9, 1), 3, 3)},
      {"rough_sphere", rough_sphere(4, 1, 0.3)},
      {"spiky_sphere", rough_sphere(5, 1, 0.7)},
      {"sphere_with_holes", with_holes(rough_sphere(6, 2, 0.1), 6, 4)},
      {"rough_torus", rough_torus(7, 12, 7, 0.4)},
      {"smooth_torus", rough_torus(8, 10, 8, 0.01)},
  };
}

}  // namespace geodesic
