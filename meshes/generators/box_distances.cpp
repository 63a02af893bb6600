#include <algorithm>
#include <array>

#include "meshes/generators/known_distances.h"
#include "meshes/plane.h"

namespace geodesic {
namespace {

/// A side of the box: its plane is at coordinate 0 or at the box's size along `axis`.
struct Side {
  std::size_t axis;
  bool far;
  std::size_t number() const { return 2 * axis + (far ? 1 : 0); }
};

/// A side laid into the plane: a point `anchor` of it at `image`, unit steps along the three axes
/// as `steps` (the one along its normal is not used).
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
/// crossed on the way.
struct Unfolding {
  Layout last;
  std::vector<Gate> gates;
};

/// All unfoldings that start at a source and enter no side twice.
class Unfolder {
 public:
  Unfolder(const Vec3& size, const Vec3& source) : size_(size) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool far : {false, true}) {
        const Side side = {axis, far};
        if (!lies_on(source, side)) continue;
        std::array<PlanePoint, 3> steps;
        steps[(axis + 1) % 3] = {1, 0};
        steps[(axis + 2) % 3] = {0, 1};
        visit({side, source, {}, steps});
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
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool far : {false, true})
        if (axis != here.side.axis && !entered_[2 * axis + (far ? 1 : 0)])
          cross_into({axis, far}, here);
    entered_[here.side.number()] = false;
  }

  void cross_into(const Side& next, const Layout& here) {
    const std::size_t from = here.side.axis, to = next.axis, along = 3 - from - to;
    Vec3 corner = {0, 0, 0};
    corner[from] = here.side.far ? size_[from] : 0;
    corner[to] = next.far ? size_[to] : 0;
    Vec3 other = corner;
    other[along] = size_[along];
    // Beyond the edge the way goes on against the outer normal of the side that is left.
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
  std::vector<Gate> gates_;  // of the chain that is being unfolded, as is `entered_`
  std::array<bool, 6> entered_ = {};
};

}  // namespace

std::vector<double> box_distances(const CheckedParameters& /*parameters*/, const TriangleSoup& soup,
                                  Index source) {
  // The corner opposite to the origin is the last vertex.
  const Unfolder unfolder(soup.positions.back(), soup.positions[source]);
  std::vector<double> distances;
  distances.reserve(soup.positions.size());
  for (const Vec3& position : soup.positions)
    distances.push_back(static_cast<double>(unfolder.least_distance(position)));
  return distances;
}

}  // namespace geodesic
