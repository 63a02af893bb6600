// Generates a closed box of square cells, and computes its distances.
#include <algorithm>
#include <array>

#include "meshes/generators/families.h"
#include "meshes/plane.h"

namespace geodesic {
namespace {

/// The lattice points on the surface of a box of a x b x c unit cells, numbered layer by layer in
/// z: all points of the first and last layer, the border of the others.
class BoxSurface {
 public:
  BoxSurface(Index a, Index b, Index c) : size_{a, b, c} {
    check_face_count(4 * (1.0 * a * b + 1.0 * b * c + 1.0 * c * a));
  }

  Index vertex(const std::array<Index, 3>& point) const {
    const auto [x, y, z] = point;
    const auto [a, b, c] = size_;
    if (z == 0) return y * (a + 1) + x;
    const Index first_of_layer = layer() + (z - 1) * border();
    return z == c ? first_of_layer + y * (a + 1) + x : first_of_layer + along_border(x, y);
  }

  template <typename Visit>
  void for_each_point(Visit visit) const {
    const auto [a, b, c] = size_;
    for (Index z = 0; z <= c; ++z) {
      for (Index y = 0; y <= b; ++y) {
        const bool inside = 0 < z && z < c && 0 < y && y < b;
        for (Index x = 0; x <= a; x += inside ? a : 1) visit(std::array<Index, 3>{x, y, z});
      }
    }
  }

  const std::array<Index, 3>& size() const { return size_; }

 private:
  Index layer() const { return (size_[0] + 1) * (size_[1] + 1); }
  Index border() const { return 2 * (size_[0] + size_[1]); }
  /// Index of a border point of a layer in the order of for_each_point.
  Index along_border(Index x, Index y) const {
    const auto [a, b, c] = size_;
    if (y == 0) return x;
    const Index first_of_row = a + 1 + 2 * (y - 1);
    return y == b ? first_of_row + x : first_of_row + (x == 0 ? 0 : 1);
  }

  std::array<Index, 3> size_;
};

/// Adds the side with normal +`axis` or -`axis`.
void add_side(TriangleSoup& soup, const BoxSurface& box, std::size_t axis, bool positive,
              Diagonal diagonal) {
  // (u, v, axis) is right-handed for the positive side, and mirrored for the negative one.
  const std::size_t u = (axis + (positive ? 1 : 2)) % 3, v = (axis + (positive ? 2 : 1)) % 3;
  const Sheet sheet{.columns = box.size()[u], .rows = box.size()[v], .diagonal = diagonal};
  const auto vertex_of = [&](Index id) {
    std::array<Index, 3> point;
    point[axis] = positive ? box.size()[axis] : 0;
    point[u] = id % sheet.vertex_columns();
    point[v] = id / sheet.vertex_columns();
    return box.vertex(point);
  };
  for (const Triangle& face : sheet_faces(sheet)) {
    soup.triangles.push_back({vertex_of(face[0]), vertex_of(face[1]), vertex_of(face[2])});
  }
}

TriangleSoup make_box(const CheckedParameters& parameters) {
  const BoxSurface box(parameters.integer("x-cells"), parameters.integer("y-cells"),
                       parameters.integer("z-cells"));
  const double spacing = parameters.real("spacing");
  TriangleSoup soup;
  box.for_each_point([&](const std::array<Index, 3>& point) {
    soup.positions.push_back({point[0] * spacing, point[1] * spacing, point[2] * spacing});
  });
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool positive : {false, true}) {
      add_side(soup, box, axis, positive, diagonal_of(parameters));
    }
  }
  return soup;
}

/// A side of the box: its plane is at coordinate 0 or at the box's size along `axis`.
struct Side {
  std::size_t axis;
  bool far;
  std::size_t number() const { return 2 * axis + (far ? 1 : 0); }
};

/// A side unfolded into the plane: its point `anchor` lies at `image`, and unit steps along the
/// three axes become `steps` (the one along its normal is not used).
struct Layout {
  Side side;
  Vec3 anchor;
  PlanePoint image;
  std::array<PlanePoint, 3> steps;

  PlanePoint lay_out(const Vec3& p) const {
    PlanePoint q = image;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == side.axis) continue;
      q.x += (Real{p[k]} - anchor[k]) * steps[k].x;
      q.y += (Real{p[k]} - anchor[k]) * steps[k].y;
    }
    return q;
  }
};

/// The image of an edge that a path crosses.
struct Gate {
  PlanePoint a, b;
};

/// A chain of sides unfolded from the source, which lies at (0, 0): the last side, and the edges
/// crossed before it.
struct Unfolding {
  Layout last;
  std::vector<Gate> gates;
};

/// All unfoldings that start at a source and enter no side twice.
class Unfolder {
 public:
  Unfolder(const Vec3& size, const Vec3& source) : size_(size) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool far : {false, true}) {
        const Side side = {axis, far};
        if (!lies_on(source, side)) continue;
        std::array<PlanePoint, 3> steps;
        steps[(axis + 1) % 3] = {1, 0};
        steps[(axis + 2) % 3] = {0, 1};
        visit({side, source, {}, steps});
      }
    }
  }

  Real least_distance(const Vec3& target) const {
    Real least = kInfinity;
    for (const Unfolding& unfolding : unfoldings_) {
      if (!lies_on(target, unfolding.last.side)) continue;
      const PlanePoint image = unfolding.last.lay_out(target);
      if (passes(unfolding.gates, image)) least = std::min(least, distance({}, image));
    }
    return least;
  }

 private:
  Real plane(const Side& side) const { return side.far ? size_[side.axis] : 0.0; }
  bool lies_on(const Vec3& p, const Side& side) const { return p[side.axis] == plane(side); }

  void visit(const Layout& here) {
    unfoldings_.push_back({here, gates_});
    entered_[here.side.number()] = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool far : {false, true}) {
        if (axis != here.side.axis && !entered_[2 * axis + (far ? 1 : 0)]) {
          cross_into({axis, far}, here);
        }
      }
    }
    entered_[here.side.number()] = false;
  }

  void cross_into(const Side& next, const Layout& here) {
    const std::size_t from = here.side.axis, to = next.axis, along = 3 - from - to;
    Vec3 corner = {0, 0, 0};
    corner[from] = here.side.far ? size_[from] : 0;
    corner[to] = next.far ? size_[to] : 0;
    Vec3 other = corner;
    other[along] = size_[along];
    // Beyond the edge the path continues against the outer normal of the previous side.
    Layout there = {next, corner, here.lay_out(corner), here.steps};
    const Real sign = here.side.far == next.far ? -1 : 1;
    there.steps[from] = {sign * here.steps[to].x, sign * here.steps[to].y};
    gates_.push_back({here.lay_out(corner), here.lay_out(other)});
    visit(there);
    gates_.pop_back();
  }

  /// Whether the straight line from the source to `target` crosses every gate. A line that misses
  /// the end of a gate by the tolerance t would bend there, which lengthens it by t^2 only.
  bool passes(const std::vector<Gate>& gates, const PlanePoint& target) const {
    const Real tolerance = 1e-14L * (Real{size_[0]} + size_[1] + size_[2]);
    const auto on_one_side = [&](const PlanePoint& a, const PlanePoint& b, const PlanePoint& p,
                                 const PlanePoint& q) {
      const Real s = turn(a, b, p), t = turn(a, b, q), slack = tolerance * distance(a, b);
      return std::min(s, t) > slack || std::max(s, t) < -slack;
    };
    return std::none_of(gates.begin(), gates.end(), [&](const Gate& gate) {
      return on_one_side({}, target, gate.a, gate.b) || on_one_side(gate.a, gate.b, {}, target);
    });
  }

  Vec3 size_;
  std::vector<Unfolding> unfoldings_;
  std::vector<Gate> gates_;  // of the present chain, like `entered_`
  std::array<bool, 6> entered_ = {};
};

/// Distances by the shortest straight line over all unfoldings of chains of sides. A shortest path
/// crosses no side of a box twice (Sharir, Schorr 1986: no face of a convex polyhedron).
std::vector<double> box_distances(const CheckedParameters& /*parameters*/, const TriangleSoup& soup,
                                  Index source) {
  // The corner opposite to the origin is the last vertex.
  const Unfolder unfolder(soup.positions.back(), soup.positions[source]);
  return distances_to_all(soup,
                          [&](Index v) { return unfolder.least_distance(soup.positions[v]); });
}

}  // namespace

Family box() {
  return {{.name = "box",
           .description = "closed box from the origin, of square cells; a cube when all three "
                          "counts are equal; 2 (xy + yz + zx) + 2 vertices",
           .closed_form = "on one side |a - b|; on adjacent sides the least over the unfoldings "
                          "across the shared edge and around its two ends; on opposite sides the "
                          "least over the twelve unfoldings across one or two sides between",
           .parameters = {integer_parameter("x-cells", 16, 1, 10000, "cells along x"),
                          integer_parameter("y-cells", 16, 1, 10000, "cells along y"),
                          integer_parameter("z-cells", 16, 1, 10000, "cells along z"),
                          real_parameter("spacing", 1, 1e-6, 1e6, "side of a cell"),
                          diagonal_parameter()}},
          make_box,
          box_distances};
}

}  // namespace geodesic
