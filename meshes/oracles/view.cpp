#include "meshes/oracles/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace geodesic {
namespace {

std::array<Real, 3> vector_between(const Mesh& mesh, Index a, Index b) {
  return subtract(extended(mesh.position(b)), extended(mesh.position(a)));
}

// Whether the rays through r and l enclose a positive angle, pi included: a vertex in the middle of
// an edge (of a face without area) has a half-plane across that edge in view.
bool opens(const PlanePoint& r, const PlanePoint& l) {
  const Real area = turn({}, r, l);
  return area > 0 || (area == 0 && r.x * l.x + r.y * l.y < 0);
}

Real nearest(const PlanePoint& a, const PlanePoint& b) {
  const PlanePoint d = {b.x - a.x, b.y - a.y};
  const Real square = d.x * d.x + d.y * d.y;
  Real t = square > 0 ? -(a.x * d.x + a.y * d.y) / square : 0;
  t = std::min(Real{1}, std::max(Real{0}, t));
  return norm(PlanePoint{a.x + t * d.x, a.y + t * d.y});
}

class View {
 public:
  View(const Mesh& mesh, Real reach, const std::function<void(const Sight&)>& see)
      : mesh_(mesh), reach_(reach), see_(see), entered_(mesh.given_face_count()) {}

  void look_from(Index v) {
    for (const Index h : mesh_.outgoing(v)) {
      const PlanePoint right = {straight_distance(mesh_, v, mesh_.head(h)), 0};
      if (right.x == 0) continue;  // everything beyond is visible from a bend at the other end
      const PlanePoint left = lay_out_apex(mesh_, h, {0, 0}, right);
      entered(h) = true;
      leave(Mesh::next(h), left, right, left, right);
      entered(h) = false;
    }
  }

 private:
  // Leaves a face through h, and enters each face beyond.
  void leave(Index h, const PlanePoint& left, const PlanePoint& right, const PlanePoint& l,
             const PlanePoint& r) {
    mesh_.for_each_sheet(h, [&](Index g) { enter(mesh_.twin(g), left, right, l, r); });
  }

  // Enters the face of h, visible from below between the rays through `l` and `r`. h runs from
  // `left` to `right` with its face above.
  void enter(Index h, const PlanePoint& left, const PlanePoint& right, const PlanePoint& l,
             const PlanePoint& r) {
    if (!opens(r, l) || nearest(left, right) > reach_) return;
    if (entered(h) || mesh_.half_edge(h).length == 0) return;
    if (left.x == right.x && left.y == right.y) return;  // a bend at its ends sees the same
    entered(h) = true;
    strip_.push_back({h, left, right});
    const PlanePoint apex = lay_out_apex(mesh_, h, left, right);
    // The apex splits the visible part. A line exactly through it is continued by the bend there.
    const Index left_edge = Mesh::previous(h), right_edge = Mesh::next(h);
    const Real from_l = turn({}, apex, l), from_r = turn({}, r, apex);
    const bool half_plane =
        turn({}, r, l) == 0;  // not a narrow cone whose lines both round to the apex
    if (half_plane && from_l == 0 && from_r == 0) {
      // A face without area, seen from a point of its line: one of its edges has the half-plane.
      see_({mesh_.apex(h), apex, norm(apex), {}});
      leave(left_edge, left, apex, left, apex);
      leave(right_edge, apex, right, apex, right);
    } else {
      const bool right_of_l = from_l > 0, left_of_r = from_r > 0;
      if (right_of_l && left_of_r) {
        see_({mesh_.apex(h), apex, norm(apex), strip_});
      }
      if (right_of_l) leave(left_edge, left, apex, l, left_of_r ? apex : r);
      if (left_of_r) leave(right_edge, apex, right, right_of_l ? apex : l, r);
    }
    strip_.pop_back();
    entered(h) = false;
  }

  // The flag of both images of the face, if there are two.
  std::vector<bool>::reference entered(Index h) {
    return entered_[h / 3 % mesh_.given_face_count()];
  }

  const Mesh& mesh_;
  Real reach_;
  const std::function<void(const Sight&)>& see_;
  std::vector<EdgeInView> strip_;
  std::vector<bool> entered_;  // faces of the strip: a shortest path crosses none twice
};

}  // namespace

PlanePoint lay_out_apex(const Mesh& mesh, Index h, const PlanePoint& p, const PlanePoint& q) {
  // Needles lose digits in two places. The area is computed from the two shorter sides: with two
  // long sides it is a difference of products as large as their squares. Rounding rotates the
  // direction from p to q if they are close. It is made a unit vector by their distance in the
  // plane: a rotation changes no length of a line through there, another unit would.
  const std::array<Real, 3> base = vector_between(mesh, mesh.origin(h), mesh.head(h));
  const std::array<Real, 3> left = vector_between(mesh, mesh.origin(h), mesh.apex(h));
  const std::array<Real, 3> right = vector_between(mesh, mesh.head(h), mesh.apex(h));
  const Real longest = std::max({dot(base, base), dot(left, left), dot(right, right)});
  const Real area = dot(base, base) == longest   ? norm(cross(left, right))
                    : dot(left, left) == longest ? norm(cross(base, right))
                                                 : norm(cross(base, left));
  const Real length = norm(base), laid = distance(p, q);
  const Real along = dot(base, left) / length, across = area / length;
  const PlanePoint e = {(q.x - p.x) / laid, (q.y - p.y) / laid};
  return {p.x + along * e.x - across * e.y, p.y + along * e.y + across * e.x};
}

Real straight_distance(const Mesh& mesh, Index a, Index b) {
  return norm(vector_between(mesh, a, b));
}

void view_from(const Mesh& mesh, Index v, Real reach,
               const std::function<void(const Sight&)>& see) {
  View(mesh, reach, see).look_from(v);
}

}  // namespace geodesic
