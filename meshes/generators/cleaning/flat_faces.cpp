#include <algorithm>
#include <queue>
#include <tuple>

#include "meshes/defects.h"
#include "meshes/edges.h"
#include "meshes/generators/cleaning/steps.h"
#include "solvers/core/geometry.h"

namespace geodesic {
namespace {

/// Flips first the longest edge of all flat faces: the face beyond it, when flat too, then has no
/// longer one, so that the new edge is shorter and flipping among flat faces ends.
class Remover {
 public:
  explicit Remover(TriangleSoup& soup) : soup_(soup) {
    for (Index f = 0; f < soup.triangles.size(); ++f) enqueue_if_flat(f);
    if (queue_.empty()) return;
    twins_ = pair_half_edges(soup);
    removed_.assign(soup.triangles.size(), false);
    // A flip that turns a face with area into a flat one, by rounding, could be undone by the next.
    flips_left_ = 64 + 16 * queue_.size();
  }

  std::vector<RepairAction> remove() {
    while (!queue_.empty()) {
      const FlatFace next = queue_.top();
      queue_.pop();
      const bool is_up_to_date = !removed_[next.side / 3] && is_flat(next.side / 3) &&
                                 longest_side(next.side / 3) == next.side;
      if (is_up_to_date) remove(next.side);
    }
    drop_removed_faces();
    return actions();
  }

 private:
  struct FlatFace {
    double length;
    Index side;  // the face's longest

    bool operator<(const FlatFace& other) const {  // later in the queue
      return std::tie(length, other.side) < std::tie(other.length, side);
    }
  };

  Index origin(Index h) const { return origin_of(soup_.triangles, h); }
  Index apex(Index h) const { return origin(previous_in_face(h)); }
  bool is_flat(Index f) const { return geodesic::is_flat(soup_.positions, soup_.triangles[f]); }

  double length(Index h) const {
    return norm(subtract(soup_.positions[origin(next_in_face(h))], soup_.positions[origin(h)]));
  }

  Index longest_side(Index f) const {
    Index longest = 3 * f;
    for (const Index h : {3 * f + 1, 3 * f + 2}) {
      if (length(h) > length(longest)) longest = h;
    }
    return longest;
  }

  void enqueue_if_flat(Index f) {
    if (is_flat(f)) queue_.push({length(longest_side(f)), longest_side(f)});
  }

  void remove(Index side) {
    if (twins_[side] == kNone || flips_left_ == 0) {
      drop(side / 3);
    } else if (apex(side) != apex(twins_[side])) {
      flip(side);
    }  // else a flip laid the two back to back, and the next round cancels them
  }

  void link(Index h, Index twin) {
    if (h != kNone) twins_[h] = twin;
    if (twin != kNone) twins_[twin] = h;
  }

  void drop(Index f) {
    for (const Index h : {3 * f, 3 * f + 1, 3 * f + 2}) link(kNone, twins_[h]);
    removed_[f] = true;
    ++drops_;
  }

  /// From the faces (a, b, c) and (b, a, d) of side a -> b to (d, b, c) and (c, a, d).
  void flip(Index side) {
    const Index beyond = twins_[side];
    const Index f = side / 3, g = beyond / 3;
    const Index a = origin(side), b = origin(beyond), c = apex(side), d = apex(beyond);
    const Index bc = twins_[next_in_face(side)], ca = twins_[previous_in_face(side)];
    const Index ad = twins_[next_in_face(beyond)], db = twins_[previous_in_face(beyond)];
    soup_.triangles[f] = {d, b, c};
    soup_.triangles[g] = {c, a, d};
    link(3 * f, db);
    link(3 * f + 1, bc);
    link(3 * g, ca);
    link(3 * g + 1, ad);
    link(3 * f + 2, 3 * g + 2);
    ++flips_;
    --flips_left_;
    enqueue_if_flat(f);
    enqueue_if_flat(g);
  }

  void drop_removed_faces() {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < removed_.size(); ++f) {
      if (!removed_[f]) soup_.triangles[kept++] = soup_.triangles[f];
    }
    if (!removed_.empty()) soup_.triangles.resize(kept);
  }

  std::vector<RepairAction> actions() const {
    std::vector<RepairAction> list;
    const auto did = [&](const char* key, const char* text, std::size_t count) {
      if (count > 0) list.push_back({key, text, count});
    };
    did("flipped_edges", "edges flipped to the vertex that a face without area had on them",
        flips_);
    did("dropped_flat_faces", "faces without area dropped", drops_);
    return list;
  }

  TriangleSoup& soup_;
  std::vector<Index> twins_;
  std::vector<bool> removed_;
  std::priority_queue<FlatFace> queue_;
  std::size_t flips_left_ = 0;
  std::size_t flips_ = 0, drops_ = 0;
};

}  // namespace

bool is_flat(std::span<const Vec3> positions, const Triangle& face) {
  if (has_zero_area(positions, face)) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = positions[face[k]];
    const Vec3 along = subtract(positions[face[(k + 1) % 3]], corner);
    const Vec3 across = subtract(positions[face[(k + 2) % 3]], corner);
    // Solvers divide the one by the other and want a height above 0.
    const double height = norm(cross(along, across)) / norm(along);
    if (!(height > 0)) return true;
  }
  return false;
}

std::vector<RepairAction> remove_flat_faces(TriangleSoup& soup) { return Remover(soup).remove(); }

}  // namespace geodesic
