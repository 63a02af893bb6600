#include "meshes/oracles/random_case.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "meshes/connectivity.h"
#include "meshes/formats/npy.h"
#include "meshes/generators/generators.h"
#include "meshes/mesh_file.h"
#include "meshes/oracles/random_meshes.h"
#include "meshes/random.h"

namespace geodesic {
namespace {

// Above this number of faces no change adds faces, and another solver replaces brute force.
constexpr double kManyFaces = 150;

// Factors for counts of cells; each mesh has one. Some errors occur on the larger meshes only.
constexpr double kSizes[] = {1, 1, 1, 1, 1.5, 1.5, 1.5, 2, 2, 3};

// The functions of a scene draw the next numbers. The arguments of a call must not contain two of
// them, since the compiler chooses their order.
struct Scene {
  Random& random;
  const std::filesystem::path& scratch;
  double size;  ///< factor for counts of cells

  /// Returns a number in {least, ..., most * size}.
  Index cells(Index least, Index most) const {
    const auto end = static_cast<Index>(size * most) + 1;
    return least + random.below(std::max(end, least + 1) - least);
  }
  double real(double least, double most) const { return random.between(least, most); }
  std::uint32_t seed() const { return random.below(1u << 31); }
  const char* diagonal() const {
    constexpr const char* kDiagonals[] = {"alternating", "forward", "backward"};
    return kDiagonals[random.below(3)];
  }
};

struct RandomSurface {
  const char* name;
  TriangleSoup (*make)(const Scene& s);
};

void write(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

TriangleSoup elevation(const Scene& s) {
  const Index columns = s.cells(4, 8);
  std::vector<double> heights(std::size_t{columns} * s.cells(4, 8));
  for (double& z : heights) z = s.real(0, 3);
  const std::filesystem::path file = s.scratch / "heights.npy";
  write(file, npy_bytes<double>(heights, columns));
  return generate("elevation", {{"input", file.string()},
                                {"columns", s.cells(2, 7)},
                                {"rows", s.cells(2, 7)},
                                {"diagonal", s.diagonal()}});
}

constexpr RandomSurface kSurfaces[] = {
    {"rough-terrain",
     [](const Scene& s) {
       const Index columns = s.cells(1, 9), rows = s.cells(1, 9);
       const double relief = s.real(0, 4);
       return rough_terrain(s.seed(), columns, rows, relief);
     }},
    {"hardly-rough-terrain",
     [](const Scene& s) {
       const Index columns = s.cells(1, 9), rows = s.cells(1, 9);
       const double relief = std::pow(10, s.real(-14, -1));
       return rough_terrain(s.seed(), columns, rows, relief);
     }},
    {"rough-sphere",
     [](const Scene& s) {
       const Index levels = s.cells(0, 1);
       const double noise = s.real(0, 0.7);
       return rough_sphere(s.seed(), static_cast<int>(levels), noise);
     }},
    {"rough-torus",
     [](const Scene& s) {
       const Index around = s.cells(3, 11), across = s.cells(3, 6);
       const double noise = s.real(0, 0.5);
       return rough_torus(s.seed(), around, across, noise);
     }},
    {"box",
     [](const Scene& s) {
       return generate("box", {{"x-cells", s.cells(1, 3)},
                               {"y-cells", s.cells(1, 3)},
                               {"z-cells", s.cells(1, 3)},
                               {"diagonal", s.diagonal()}});
     }},
    {"cone",
     [](const Scene& s) {
       return generate(
           "cone",
           {{"sectors", s.cells(3, 9)}, {"angle", s.real(2, 359)}, {"rings", s.cells(1, 4)}});
     }},
    {"saddle-cone",
     [](const Scene& s) {
       return generate("saddle-cone", {{"sectors", 2 * s.cells(2, 5)},
                                       {"sector-angle", s.real(91, 119)},
                                       {"rings", s.cells(1, 4)}});
     }},
    {"cylinder",
     [](const Scene& s) {
       return generate("cylinder", {{"sides", s.cells(3, 10)},
                                    {"rows", s.cells(1, 6)},
                                    {"height", s.real(0.1, 9)},
                                    {"diagonal", s.diagonal()}});
     }},
    {"egg-carton",
     [](const Scene& s) {
       return generate("egg-carton", {{"cells", s.cells(2, 8)},
                                      {"bumps", s.real(0.5, 3)},
                                      {"height", s.real(0, 3)},
                                      {"diagonal", s.diagonal()}});
     }},
    {"elevation", elevation},
    {"grid",
     [](const Scene& s) {
       return generate(
           "grid",
           {{"columns", s.cells(1, 9)}, {"rows", s.cells(1, 9)}, {"diagonal", s.diagonal()}});
     }},
    {"holed-plate",
     [](const Scene& s) {
       return generate("holed-plate", {{"holes", s.cells(1, 2)},
                                       {"pitch", 4},
                                       {"bulge", s.real(-1, 1)},
                                       {"diagonal", s.diagonal()}});
     }},
    {"icosphere",
     [](const Scene& s) {
       return generate("icosphere", {{"frequency", s.cells(1, 2)}});
     }},
    {"needles",
     [](const Scene& s) {
       return generate("needles", {{"sides", s.cells(3, 10)},
                                   {"rows", s.cells(1, 5)},
                                   {"aspect", std::pow(10, s.real(0, 6))},
                                   {"waist", s.real(0, 0.9)},
                                   {"diagonal", s.diagonal()}});
     }},
    {"square-with-hole",
     [](const Scene& s) {
       return generate(
           "square-with-hole",
           {{"hole", s.cells(1, 4)}, {"rim", s.cells(1, 2)}, {"diagonal", s.diagonal()}});
     }},
    {"terrain",
     [](const Scene& s) {
       return generate("terrain", {{"columns", s.cells(1, 9)},
                                   {"rows", s.cells(1, 9)},
                                   {"seed", s.seed()},
                                   {"height", s.real(0, 5)},
                                   {"diagonal", s.diagonal()}});
     }},
    {"torus",
     [](const Scene& s) {
       return generate("torus", {{"rings", s.cells(3, 11)},
                                 {"sides", s.cells(3, 6)},
                                 {"tube-radius", s.real(0.05, 0.95)},
                                 {"diagonal", s.diagonal()}});
     }},
    {"torus-knot",
     [](const Scene& s) {
       const Index p = s.cells(1, 3);  // has no divisor in common with p + 1
       return generate("torus-knot", {{"p", p},
                                      {"q", p + 1},
                                      {"rings", s.cells(8, 18)},
                                      {"sides", s.cells(3, 4)},
                                      {"diagonal", s.diagonal()}});
     }},
    {"two-components",
     [](const Scene& s) {
       return generate("two-components", {{"frequency", s.cells(1, 2)}, {"cells", s.cells(1, 2)}});
     }},
};

std::pair<const char*, TriangleSoup> random_surface(const Scene& s) {
  const RandomSurface& surface = kSurfaces[s.random.below(std::size(kSurfaces))];
  return {surface.name, surface.make(s)};
}

// Changes a mesh by a generator that reads one.
TriangleSoup changed_by(const char* generator, const Scene& s, const TriangleSoup& soup,
                        GeneratorParameters parameters) {
  const std::filesystem::path file = s.scratch / "mesh.ply";
  write(file, mesh_bytes(soup, file));
  parameters.emplace("input", file.string());
  return generate(generator, parameters);
}

// Splits faces at arbitrary inner points: the nearer to a side, the thinner the new faces.
TriangleSoup with_points_in_faces(TriangleSoup soup, const Scene& s) {
  const std::size_t cuts = 1 + s.random.below(20);
  for (std::size_t cut = 0; cut < cuts; ++cut) {
    const std::size_t f = s.random.below(static_cast<std::uint32_t>(soup.triangles.size()));
    const auto [a, b, c] = soup.triangles[f];
    const double u = s.real(0.02, 0.98), v = s.real(0.02, 0.98) * (1 - u);
    Vec3 p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] =
          u * soup.positions[a][k] + v * soup.positions[b][k] + (1 - u - v) * soup.positions[c][k];
    }
    const Index m = static_cast<Index>(soup.positions.size());
    soup.positions.push_back(p);
    soup.triangles[f] = {a, b, m};
    soup.triangles.push_back({b, c, m});
    soup.triangles.push_back({c, a, m});
  }
  return soup;
}

TriangleSoup with_vertices_moved_anywhere(TriangleSoup soup, const Scene& s) {
  const double most = std::pow(10, s.real(-9, -0.5));
  for (Vec3& p : soup.positions) {
    for (double& x : p) x += most * s.real(-1, 1);
  }
  return soup;
}

// Joins two vertices that share no neighbour: the vertex then has several fans.
TriangleSoup with_joined_vertices(TriangleSoup soup, const Scene& s) {
  const Index count = static_cast<Index>(soup.positions.size());
  const Index kept = s.random.below(count), gone = s.random.below(count);
  const auto has = [](const Triangle& t, Index v) { return std::ranges::find(t, v) != t.end(); };
  std::vector<bool> beside(count);
  for (const Triangle& t : soup.triangles) {
    for (const Index v : t) beside[v] = beside[v] || has(t, kept);
  }
  const bool too_near = std::ranges::any_of(soup.triangles, [&](const Triangle& t) {
    return has(t, gone) && std::ranges::any_of(t, [&](Index v) { return beside[v]; });
  });
  if (too_near) return soup;
  for (Triangle& t : soup.triangles) std::ranges::replace(t, gone, kept);
  return soup;
}

TriangleSoup with_turned_faces(TriangleSoup soup, const Scene& s) {
  for (Triangle& t : soup.triangles) {
    if (s.random.below(30) == 0) std::swap(t[0], t[1]);
  }
  return soup;
}

TriangleSoup stretched(TriangleSoup soup, const Scene& s) {
  const double factor = std::pow(10, s.real(-2, 2));
  for (Vec3& p : soup.positions) p[0] *= factor;
  return soup;
}

struct Change {
  const char* name;
  bool makes_larger;
  TriangleSoup (*make)(TriangleSoup soup, const Scene& s);
};

// NOLINTBEGIN(performance-unnecessary-value-param): one type of function for all
constexpr Change kChanges[] = {
    {"noise", false,
     [](TriangleSoup soup, const Scene& s) {
       return changed_by("noise", s, soup, {{"amplitude", s.real(0, 1)}, {"seed", s.seed()}});
     }},
    {"moved", false, with_vertices_moved_anywhere},
    {"stretched", false, stretched},
    {"refined", true,
     [](TriangleSoup soup, const Scene& s) {
       const auto count = static_cast<Index>(soup.positions.size());
       return changed_by("refine", s, soup, {{"vertices", count + s.random.below(count / 2 + 1)}});
     }},
    {"subdivided", true,
     [](TriangleSoup soup, const Scene& s) {
       constexpr const char* kSteps[] = {"midpoint", "loop", "barycentric"};
       if (soup.triangles.size() > 50) return soup;
       return changed_by("subdivide", s, soup, {{"steps", kSteps[s.random.below(3)]}});
     }},
    {"points in faces", true, with_points_in_faces},
    {"missing faces", false,
     [](TriangleSoup soup, const Scene& s) {
       const std::uint32_t one_in = 2 + s.random.below(20);
       return with_missing_faces(std::move(soup), s.seed(), one_in);
     }},
    {"holes", false,
     [](TriangleSoup soup, const Scene& s) {
       const Index holes = 1 + s.random.below(4);
       return with_holes(std::move(soup), s.seed(), holes);
     }},
    {"joined vertices", false, with_joined_vertices},
    {"turned faces", false, with_turned_faces},
    {"another component", true,
     [](TriangleSoup soup, const Scene& s) {
       return side_by_side(std::move(soup), random_surface(s).second);
     }},
    {"cleaned", false,
     [](TriangleSoup soup, const Scene& s) {
       return changed_by("clean", s, soup, {{"parts", "all"}});
     }},
    {"collapsed edges", false,
     [](TriangleSoup soup, const Scene& s) {
       const std::uint32_t one_in = 8 + s.random.below(30);
       return with_collapsed_edges(std::move(soup), s.seed(), one_in);
     }},
    {"flat caps", false,
     [](TriangleSoup soup, const Scene& s) {
       const std::uint32_t one_in = 4 + s.random.below(30);
       return with_flat_caps(std::move(soup), s.seed(), one_in);
     }},
};
// NOLINTEND(performance-unnecessary-value-param)

void apply_changes(RandomCase& made, const Scene& s) {
  for (std::uint32_t left = s.random.below(4); left > 0; --left) {
    const Change& change = kChanges[s.random.below(std::size(kChanges))];
    if (made.soup.triangles.empty()) return;
    if (change.makes_larger &&
        static_cast<double>(made.soup.triangles.size()) > kManyFaces * s.size) {
      continue;
    }
    TriangleSoup changed;
    try {
      changed = change.make(made.soup, s);
    } catch (const std::exception&) {
      continue;  // the generator does not accept this mesh
    }
    made.soup = std::move(changed);
    made.recipe += std::string(", ") + change.name;
  }
}

// Returns a query with mostly one source, sometimes several, initial distances and a limit.
Query random_query(const TriangleSoup& soup, Random& random) {
  const auto count = static_cast<Index>(soup.positions.size());
  Query query;
  const std::uint32_t sources = random.below(4) > 0 ? 1 : 2 + random.below(3);
  const double latest = random.below(2) == 0 ? 0 : random.between(0, 3);
  for (std::uint32_t i = 0; i < sources; ++i) {
    query.sources.push_back({random.below(count), sources > 1 ? random.between(0, latest) : 0});
  }
  if (random.below(6) == 0) query.limit = random.between(0.1, 5);
  return query;
}

double longest_edge(const Mesh& mesh) {
  double longest = 0;
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    longest = std::max(longest, mesh.half_edge(h).length);
  }
  return longest;
}

// Returns the least height of a face over its longest edge, relative to that edge.
double least_height(const Mesh& mesh) {
  double least = 1;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double longest = 0, area = 0;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const HalfEdge& e = mesh.half_edge(h);
      if (e.length > longest) {
        longest = e.length;
        area = e.length * e.apex_y;
      }
    }
    if (longest > 0) least = std::min(least, area / (longest * longest));
  }
  return least;
}

}  // namespace

const char* name_of(MeshKind kind) {
  switch (kind) {
    case MeshKind::clean:
      return "clean";
    case MeshKind::non_manifold:
      return "non-manifold";
    case MeshKind::thin:
      return "thin";
    case MeshKind::degenerate:
      return "degenerate";
  }
  return "";
}

MeshKind kind_of(const Mesh& mesh) {
  if (mesh.has_degenerate_faces()) return MeshKind::degenerate;
  if (least_height(mesh) < kThin) return MeshKind::thin;
  return mesh.has_non_manifold_vertices() ? MeshKind::non_manifold : MeshKind::clean;
}

RandomCase random_case(std::uint64_t seed, std::uint64_t number,
                       const std::filesystem::path& scratch) {
  Random random(split_mix(split_mix(seed) ^ number));
  const Scene scene{random, scratch, kSizes[random.below(std::size(kSizes))]};
  auto [name, soup] = random_surface(scene);
  RandomCase made{.recipe = name, .soup = std::move(soup), .query = {}, .least_distance = 0};
  apply_changes(made, scene);
  made.query = random_query(made.soup, random);
  made.least_distance = kEdgePart * longest_edge(Mesh(made.soup));
  return made;
}

}  // namespace geodesic
