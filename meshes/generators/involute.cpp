// Generates a plate of needles around a convex arc. Every corner sends windows over all needles
// behind it: the worst case of window counts (Mitchell, Mount, Papadimitriou 1987, section 4).
#include "meshes/generators/families.h"
#include "meshes/plane.h"

namespace geodesic {
namespace {

/// Corner k of the arc is vertex k; the vertex of the rim behind it is corners + 1 + k.
TriangleSoup make_involute(const CheckedParameters& parameters) {
  const Index corners = parameters.integer("corners");
  // With three corners or more the rim stays outside of the arc, at any angle and width.
  const double turns = parameters.real("angle") / 360, width = parameters.real("width");
  check_face_count(2.0 * corners);
  TriangleSoup soup;
  for (const double radius : {1.0, 1 + width}) {
    for (Index k = 0; k <= corners; ++k) {
      const auto [cosine, sine] = circle_point(turns * k / corners);
      soup.positions.push_back({radius * cosine, radius * sine, 0});
    }
  }
  for (Index k = 0; k < corners; ++k) {
    const Index rim = corners + 1 + k;
    soup.triangles.push_back({k, rim, rim + 1});
    soup.triangles.push_back({k, rim + 1, k + 1});
  }
  return soup;
}

/// A string from the source around the corners of the arc, pulled taut.
class TautString {
 public:
  /// @param side 1 if the string runs counter-clockwise, with the arc to its left; else -1
  TautString(const PlanePoint& source, int side) : side_(side), bends_{{source, 0}} {}

  Real length_to(const PlanePoint& end) const {
    const Bend& last = bends_[last_on_way(end)];
    return last.travelled + distance(last.at, end);
  }

  /// Continues around the next corner.
  void pass(const PlanePoint& corner) {
    const Real travelled = length_to(corner);
    bends_.resize(last_on_way(corner) + 1);
    bends_.push_back({corner, travelled});
  }

 private:
  struct Bend {
    PlanePoint at;
    Real travelled;
  };

  std::size_t last_on_way(const PlanePoint& end) const {
    std::size_t last = bends_.size() - 1;
    while (last > 0 && side_ * turn(bends_[last - 1].at, bends_[last].at, end) <= 0) --last;
    return last;
  }

  int side_;
  std::vector<Bend> bends_;
};

std::vector<double> involute_distances(const CheckedParameters& parameters,
                                       const TriangleSoup& soup, Index source) {
  const auto corners = static_cast<int>(parameters.integer("corners")), columns = corners + 1;
  const auto at = [&](int column, bool rim) -> PlanePoint {
    const int v = column + (rim ? columns : 0);
    const Vec3& p = soup.positions[static_cast<std::size_t>(v)];
    return {p[0], p[1]};
  };
  const int own = static_cast<int>(source) % columns;
  const PlanePoint from = at(own, static_cast<int>(source) >= columns);
  std::vector<Real> reached(soup.positions.size());
  const auto reach = [&](int column, bool rim, Real length) {
    const int v = column + (rim ? columns : 0);
    reached[static_cast<std::size_t>(v)] = length;
  };
  for (const bool rim : {false, true}) reach(own, rim, distance(from, at(own, rim)));
  for (const int side : {1, -1}) {
    TautString string(from, side);
    for (int k = own + side; k >= 0 && k <= corners; k += side) {
      for (const bool rim : {false, true}) reach(k, rim, string.length_to(at(k, rim)));
      string.pass(at(k, false));
    }
  }
  return distances_to_all(soup, [&](Index v) { return reached[v]; });
}

}  // namespace

Family involute() {
  return {{.name = "involute",
           .description = "flat plate of needles around a convex arc of radius 1 in the plane z = "
                          "0, 2 (corners + 1) vertices: vertex k is corner k of the arc, vertex "
                          "corners + 1 + k lies behind it on the rim; fronts from vertex 0 are "
                          "involutes, and windows grow as corners^2",
           .closed_form = "the length of a string from a to b around the corners between them, "
                          "pulled taut",
           .parameters = {integer_parameter("corners", 64, 3, 1000000, "of the arc, less one"),
                          real_parameter("angle", 300, 1, 350, "of the arc, degrees"),
                          real_parameter("width", 2, 1, 1000, "from the arc to the rim")}},
          make_involute,
          involute_distances};
}

}  // namespace geodesic
