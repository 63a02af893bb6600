// Properties on surfaces of several sheets that meet in edges, and on surfaces with inconsistent
// orientations. Paths lead from each face of an edge into each of the others.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "harness/verify/properties/properties.h"
#include "meshes/oracles/brute_force.h"
#include "meshes/random.h"

namespace geodesic::harness {
namespace {

Case crossed(const std::string& name, const TriangleSoup& soup, std::vector<Query> queries) {
  Case given{name, soup, std::move(queries)};
  given.non_manifold_edges = NonManifoldEdges::crossed;
  return given;
}

// Adds faces on edges of a surface, each with a new vertex.
TriangleSoup with_fins(TriangleSoup soup, std::uint64_t seed, std::uint32_t one_in) {
  Random random(seed);
  const std::vector<Triangle> faces = soup.triangles;
  for (const Triangle& face : faces) {
    if (random.below(one_in) != 0) continue;
    const Index top = static_cast<Index>(soup.positions.size());
    Vec3 above = soup.positions[face[2]];
    for (double& c : above) c += random.between(0.1, 1);
    soup.positions.push_back(above);
    soup.triangles.push_back(random.below(2) == 0 ? Triangle{face[0], face[1], top}
                                                  : Triangle{face[1], face[0], top});
  }
  return soup;
}

// Pages of cells that share a spine. The orientation of each face is random.
class Book {
 public:
  // @param relief largest displacement of vertices off the spine, in sides of a cell
  Book(std::uint64_t seed, Index pages, Index cells, double relief)
      : pages_(pages), cells_(cells), random_(seed) {
    for (Index j = 0; j <= cells_; ++j) soup_.positions.push_back({0, double(j), 0});
    for (Index page = 0; page < pages_; ++page) add_page(page, relief);
  }

  const TriangleSoup& soup() const { return soup_; }

  // Distance of two vertices of a book with flat pages.
  double distance(Index a, Index b) const {
    const double out_a = out_of(a), out_b = out_of(b);
    const bool same_page = page_of(a) == page_of(b) || out_a == 0 || out_b == 0;
    return std::hypot(same_page ? out_a - out_b : out_a + out_b,
                      soup_.positions[a][1] - soup_.positions[b][1]);
  }

 private:
  Index vertex(Index page, Index i, Index j) const {
    return i == 0 ? j : (cells_ + 1) * (1 + page * cells_ + (i - 1)) + j;
  }
  Index page_of(Index v) const { return (v / (cells_ + 1) + cells_ - 1) / cells_; }
  double out_of(Index v) const {
    const Index column = v / (cells_ + 1);
    return column == 0 ? 0 : (column - 1) % cells_ + 1;
  }

  void add_page(Index page, double relief) {
    const double turn = 2 * std::numbers::pi * page / pages_;
    for (Index i = 1; i <= cells_; ++i) {
      for (Index j = 0; j <= cells_; ++j) {
        const auto moved = [&](double by) { return by + relief * random_.between(-1, 1); };
        const double out = moved(i), up = moved(j), off = moved(0);
        soup_.positions.push_back({out * std::cos(turn) - off * std::sin(turn), up,
                                   out * std::sin(turn) + off * std::cos(turn)});
      }
    }
    for (Index i = 0; i < cells_; ++i) {
      for (Index j = 0; j < cells_; ++j) {
        const Index a = vertex(page, i, j), b = vertex(page, i + 1, j);
        const Index c = vertex(page, i + 1, j + 1), d = vertex(page, i, j + 1);
        add({a, b, c});
        add({a, c, d});
      }
    }
  }

  void add(Triangle face) {
    if (random_.below(2) == 0) std::swap(face[1], face[2]);
    soup_.triangles.push_back(face);
  }

  Index pages_, cells_;
  Random random_;
  TriangleSoup soup_;
};

TriangleSoup with_flipped_faces(TriangleSoup soup, std::uint64_t seed) {
  Random random(seed);
  for (Triangle& face : soup.triangles) {
    if (random.below(3) == 0) std::swap(face[1], face[2]);
  }
  return soup;
}

// A strip of cells whose ends are joined after turning one of them over. It has only one side.
TriangleSoup one_sided_strip(Index cells) {
  TriangleSoup soup;
  for (Index i = 0; i < cells; ++i) {
    const double around = 2 * std::numbers::pi * i / cells, tilt = around / 2;
    for (const double across : {-1.0, 1.0}) {
      const double out = 3 + across * std::cos(tilt);
      soup.positions.push_back(
          {out * std::cos(around), out * std::sin(around), across * std::sin(tilt)});
    }
  }
  for (Index i = 0; i < cells; ++i) {
    const Index a = 2 * i, b = a + 1;
    const bool last = i + 1 == cells;
    const Index c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    soup.triangles.insert(soup.triangles.end(), {{a, c, b}, {b, c, d}});
  }
  return soup;
}

Cases flat_books() {
  Cases cases;
  for (const Index pages : {3u, 5u}) {
    const Book book(90 + pages, pages, 6, 0);
    Case given = crossed("book of " + std::to_string(pages) + " pages", book.soup(),
                         some_sources(book.soup()));
    given.queries.push_back(from(20));
    given.known = [book](const Query& query) {
      std::vector<double> distances;
      for (Index v = 0; v < book.soup().positions.size(); ++v) {
        distances.push_back(book.distance(query.sources[0].at.vertex, v));
      }
      return distances;
    };
    // Turned pages are flat up to the rounding of their corners.
    cases.push_back(std::move(given));
  }
  return cases;
}

Cases flipped_surfaces() {
  Cases cases;
  for (std::uint64_t seed = 95; seed < 98; ++seed) {
    const auto add = [&](const std::string& name, const TriangleSoup& soup) {
      Case given = crossed(name, with_flipped_faces(soup, seed), some_sources(soup));
      given.known = [mesh = std::make_shared<const Mesh>(soup)](const Query& query) {
        return BruteForce(*mesh).distances(query.sources);
      };
      cases.push_back(std::move(given));
    };
    add("sphere", rough_sphere(seed, 1, 0.3));
    add("terrain", rough_terrain(seed, 7, 7, 1));
  }
  return cases;
}

}  // namespace

Cases surfaces_of_several_sheets() {
  Cases cases;
  const auto add = [&](const std::string& name, const TriangleSoup& soup) {
    cases.push_back(crossed(name, soup, some_sources(soup)));
  };
  add("one-sided strip", one_sided_strip(9));
  for (std::uint64_t seed = 100; seed < 104; ++seed) {
    add("terrain with fins", with_fins(rough_terrain(seed, 6, 6, 1), seed, 5));
    add("sphere with fins", with_fins(rough_sphere(seed, 1, 0.3), seed, 4));
    const TriangleSoup book = Book(seed, 2 + static_cast<Index>(seed % 4), 4, 0.3).soup();
    add("rough book", book);
    add("ragged book", with_missing_faces(book, seed, 4));
    const Index last = static_cast<Index>(book.positions.size()) - 1;
    cases.back().queries.push_back(from({7, last / 2, last}));
  }
  return cases;
}

std::vector<Property> sheet_properties() {
  return {
      {"pages-of-a-book-are-as-far-apart-as-in-a-plane",
       "across an edge of several faces a path goes on in each of them: any two pages of a book "
       "are "
       "a plane",
       flat_books, distances_are_right, kNonManifoldEdges},
      {"flipped-faces-change-no-distance-where-paths-cross-their-edges",
       "faces that run along their common edge in the same direction are neighbours all the same",
       flipped_surfaces, distances_are_right, kNonManifoldEdges},
      {"distances-over-several-sheets-equal-brute-force",
       "on books, on surfaces with fins and on such of one side distances equal brute force",
       surfaces_of_several_sheets, distances_are_right, kNonManifoldEdges},
  };
}

}  // namespace geodesic::harness
