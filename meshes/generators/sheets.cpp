// Generates open sheets over a square or rectangle: flat, with holes, or with bumps.
#include <algorithm>
#include <array>

#include "meshes/generators/families.h"
#include "meshes/plane.h"

namespace geodesic {
namespace {

TriangleSoup make_grid(const CheckedParameters& parameters) {
  const double spacing = parameters.real("spacing");
  return make_sheet(sheet_of(parameters, "columns", "rows"), [&](Index i, Index j) {
    return Vec3{i * spacing, j * spacing, 0};
  });
}

PlanePoint seen_from_above(const Vec3& p) { return {p[0], p[1]}; }

/// The distances are straight lines in a convex part of a plane.
std::vector<double> grid_distances(const CheckedParameters& /*parameters*/,
                                   const TriangleSoup& soup, Index source) {
  const PlanePoint from = seen_from_above(soup.positions[source]);
  return distances_to_all(
      soup, [&](Index v) { return distance(from, seen_from_above(soup.positions[v])); });
}

/// Adds a triangle on each inner edge (i, j) - (i + 1, j). Its third vertex is at the height "cap"
/// over the edge's middle, in the face above: the sheet stays flat and cells stay covered once.
TriangleSoup make_capped_grid(const CheckedParameters& parameters) {
  Sheet sheet = sheet_of(parameters, "columns", "rows");
  const double height = parameters.real("cap");
  TriangleSoup soup = make_sheet(sheet, [](Index i, Index j) { return Vec3{1.0 * i, 1.0 * j, 0}; });
  const Index width = sheet.vertex_columns();
  for (Index j = 1; j < sheet.rows; ++j) {
    for (Index i = 0; i < sheet.columns; ++i) {
      const Index a = j * width + i, b = a + 1, cap = static_cast<Index>(soup.positions.size());
      soup.positions.push_back({i + 0.5, j + height, 0});
      Triangle& above = soup.triangles[2 * (std::size_t{j} * sheet.columns + i)];  // {a, b, apex}
      const Index apex = above[2];
      above = {a, cap, apex};
      soup.triangles.push_back({cap, b, apex});
      soup.triangles.push_back({a, b, cap});
    }
  }
  return soup;
}

TriangleSoup make_square_with_hole(const CheckedParameters& parameters) {
  const Index hole = parameters.integer("hole");
  const Index rim = parameters.integer("rim");
  const Index end = rim + hole;
  const Sheet sheet{.columns = end + rim, .rows = end + rim, .diagonal = diagonal_of(parameters)};
  const auto position = [](Index i, Index j) { return Vec3{1.0 * i, 1.0 * j, 0}; };
  const auto solid = [&](Index i, Index j) { return i < rim || i >= end || j < rim || j >= end; };
  TriangleSoup soup = make_sheet(sheet, position, solid);
  drop_isolated_vertices(soup);
  return soup;
}

/// The open square (low, high) x (low, high) that no path may enter.
class Hole {
 public:
  Hole(Real low, Real high)
      : low_(low), high_(high), corners_{{{low, low}, {high, low}, {high, high}, {low, high}}} {}

  const std::array<PlanePoint, 4>& corners() const { return corners_; }

  /// Whether the segment enters the square: neither an axis of the square nor the segment's own
  /// normal separates the two. Exact for integer coordinates below 2^30.
  bool blocks(const PlanePoint& p, const PlanePoint& q) const {
    if (std::max(p.x, q.x) <= low_ || std::min(p.x, q.x) >= high_) return false;
    if (std::max(p.y, q.y) <= low_ || std::min(p.y, q.y) >= high_) return false;
    const auto side = [&](const PlanePoint& corner) { return turn(p, q, corner); };
    return std::any_of(corners_.begin(), corners_.end(), [&](auto& c) { return side(c) > 0; }) &&
           std::any_of(corners_.begin(), corners_.end(), [&](auto& c) { return side(c) < 0; });
  }

  /// Returns the distances of the corners from `source`: straight, or along the hole's sides.
  std::array<Real, 4> corner_distances(const PlanePoint& source) const {
    std::array<Real, 4> reached;
    for (std::size_t c = 0; c < 4; ++c) {
      reached[c] = blocks(source, corners_[c]) ? kInfinity : distance(source, corners_[c]);
    }
    for (int round = 0; round < 3; ++round) {
      for (std::size_t c = 0; c < 4; ++c) {
        for (const std::size_t next : {(c + 1) % 4, (c + 3) % 4}) {
          reached[next] =
              std::min(reached[next], reached[c] + distance(corners_[c], corners_[next]));
        }
      }
    }
    return reached;
  }

 private:
  Real low_, high_;
  std::array<PlanePoint, 4> corners_;  // neighbours in order
};

/// Distances are straight lines if the hole does not block them, else paths over its corners (the
/// shortest paths of a visibility graph: Lozano-Perez, Wesley 1979).
std::vector<double> square_with_hole_distances(const CheckedParameters& parameters,
                                               const TriangleSoup& soup, Index source) {
  const Index rim = parameters.integer("rim");
  const Hole hole(rim, rim + parameters.integer("hole"));
  const PlanePoint from = seen_from_above(soup.positions[source]);
  const std::array<Real, 4> corners = hole.corner_distances(from);
  return distances_to_all(soup, [&](Index v) {
    const PlanePoint to = seen_from_above(soup.positions[v]);
    Real least = hole.blocks(from, to) ? kInfinity : distance(from, to);
    for (std::size_t c = 0; c < 4; ++c) {
      if (!hole.blocks(hole.corners()[c], to)) {
        least = std::min(least, corners[c] + distance(hole.corners()[c], to));
      }
    }
    return least;
  });
}

/// Offset, in cells, of the middle of cell k from the middle of the hole of its `pitch` cells.
double from_hole_centre(Index k, Index pitch) { return k % pitch + 0.5 - 0.5 * pitch; }

TriangleSoup make_holed_plate(const CheckedParameters& parameters) {
  const Index pitch = parameters.integer("pitch");
  const Index cells = parameters.integer("holes") * pitch;
  const double radius = parameters.real("hole-radius") * pitch;
  const double bulge = parameters.real("bulge");
  const Sheet sheet{.columns = cells, .rows = cells, .diagonal = diagonal_of(parameters)};
  const auto position = [&](Index i, Index j) {
    const double x = 1.0 * i / cells, y = 1.0 * j / cells;
    return Vec3{x, y, bulge * (16 * x * (1 - x) * y * (1 - y))};
  };
  const auto solid = [&](Index i, Index j) {
    const double x = from_hole_centre(i, pitch), y = from_hole_centre(j, pitch);
    return x * x + y * y > radius * radius;
  };
  TriangleSoup soup = make_sheet(sheet, position, solid);
  drop_isolated_vertices(soup);
  return soup;
}

TriangleSoup make_egg_carton(const CheckedParameters& parameters) {
  const Sheet sheet = sheet_of(parameters, "cells", "cells");
  const Index cells = sheet.columns;
  const double bumps = parameters.real("bumps");
  const double amplitude = parameters.real("height") / bumps;
  std::vector<double> wave(cells + 1);  // sin(2 pi bumps k / cells)
  for (Index k = 0; k <= cells; ++k) wave[k] = circle_point(bumps * k / cells).sine;
  return make_sheet(sheet, [&](Index i, Index j) {
    return Vec3{1.0 * i / cells, 1.0 * j / cells, amplitude * wave[i] * wave[j]};
  });
}

}  // namespace

std::vector<Family> sheets() {
  return {
      {{.name = "grid",
        .description = "flat rectangle in the plane z = 0, (columns + 1)(rows + 1) vertices",
        .closed_form = "d(a, b) = |a - b|",
        .parameters = {integer_parameter("columns", 32, 1, 40000, "cells along x"),
                       integer_parameter("rows", 32, 1, 40000, "cells along y"),
                       real_parameter("spacing", 1, 1e-6, 1e6, "side of a cell"),
                       diagonal_parameter()}},
       make_grid,
       grid_distances},
      {{.name = "capped-grid",
        .description = "flat rectangle of unit cells in the plane z = 0 with a flat triangle on "
                       "every inner edge along x, (columns + 1)(rows + 1) + columns (rows - 1) "
                       "vertices",
        .closed_form = "d(a, b) = |a - b|",
        .parameters = {integer_parameter("columns", 8, 1, 40000, "cells along x"),
                       integer_parameter("rows", 8, 1, 40000, "cells along y"),
                       real_parameter("cap", 1e-6, 0, 0.4,
                                      "height of these triangles; without area at 0"),
                       diagonal_parameter()}},
       make_capped_grid,
       grid_distances},
      {{.name = "square-with-hole",
        .description = "flat square of unit cells in the plane z = 0 with a square hole in its "
                       "middle, hole corners at rim and rim + hole",
        .closed_form = "the least length of a polyline from a to b through none, one or two "
                       "neighbouring corners of the hole that does not enter its interior",
        .parameters = {integer_parameter("hole", 10, 1, 20000, "side of the hole in cells"),
                       integer_parameter("rim", 10, 1, 10000, "cells from hole to border"),
                       diagonal_parameter()}},
       make_square_with_hole,
       square_with_hole_distances},
      {{.name = "holed-plate",
        .description = "unit square with holes x holes round holes whose rims follow the cells, "
                       "so that every second rim vertex is a corner that paths bend at; flat or "
                       "bulging; one outer boundary loop and one a hole",
        .parameters = {integer_parameter("holes", 3, 1, 1000, "along x and along y"),
                       integer_parameter("pitch", 16, 4, 1000, "cells from hole to hole"),
                       real_parameter("hole-radius", 0.25, 0.15, 0.45, "by the pitch"),
                       real_parameter("bulge", 0, -10, 10, "height of the plate's middle"),
                       diagonal_parameter()}},
       make_holed_plate},
      {{.name = "egg-carton",
        .description = "z = height / bumps sin(2 pi bumps x) sin(2 pi bumps y) over the unit "
                       "square, (cells + 1)^2 vertices; about half of them are saddles",
        .parameters = {integer_parameter("cells", 48, 2, 20000, "cells along x and along y"),
                       real_parameter("bumps", 4, 0.5, 10000, "periods along x and along y"),
                       real_parameter("height", 0.3, 0, 10, "of a bump by its period"),
                       diagonal_parameter("forward")}},
       make_egg_carton},
  };
}

}  // namespace geodesic
