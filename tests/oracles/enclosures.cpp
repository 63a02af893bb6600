#include "tests/oracles/enclosures.h"

#include <algorithm>
#include <array>
#include <map>

namespace geodesic {
namespace {

using Bound = decltype(lower(Interval{}));

struct Point {
  Interval x, y;
};

bool is_positive(const Interval& x) { return lower(x) > 0; }
bool may_be_positive(const Interval& x) { return upper(x) > 0; }

Interval least(const Interval& a, const Interval& b) {
  return {std::min(Bound(lower(a)), Bound(lower(b))), std::min(Bound(upper(a)), Bound(upper(b)))};
}

Interval from_below(const Interval& x) { return {Bound(lower(x)), Bound(kInfinity)}; }

Interval length_of(const Interval& x, const Interval& y) {
  Interval length;
  mpfi_hypot(length.backend().data(), x.backend().data(), y.backend().data());
  return length;
}

// Whether x is certainly 0: digits that cancel exactly.
bool is_zero(const Interval& x) { return lower(x) == 0 && upper(x) == 0; }

// Positive where b lies to the left of the ray from (0, 0) through a.
Interval turn(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

using Vector = std::array<Interval, 3>;

Vector between(const Mesh& mesh, Index a, Index b) {
  Vector d;
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = Interval(mesh.position(b)[k]) - Interval(mesh.position(a)[k]);
  }
  return d;
}

Interval dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Exactly zero for the difference of equal positions.
Interval norm(const Vector& a) { return length_of(length_of(a[0], a[1]), a[2]); }

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_collapsed(const Mesh& mesh, Index h) {
  return mesh.position(mesh.origin(h)) == mesh.position(mesh.head(h));
}

// Position of the apex of half-edge h, which lies from p to q and is longer than 0.
Point apex_of(const Mesh& mesh, Index h, const Point& p, const Point& q) {
  const Vector base = between(mesh, mesh.origin(h), mesh.head(h));
  const Vector side = between(mesh, mesh.origin(h), mesh.apex(h));
  const Interval square = dot(base, base);
  const Interval along = dot(base, side) / square, across = norm(cross(base, side)) / square;
  const Point e = {q.x - p.x, q.y - p.y};
  return {p.x + along * e.x - across * e.y, p.y + along * e.y + across * e.x};
}

// A lower bound, in its lower end, of the distance from (0, 0) to the edge from a to b.
Interval distance_to(const Point& a, const Point& b) {
  const Point d = {b.x - a.x, b.y - a.y};
  const Interval before = -(a.x * d.x + a.y * d.y), behind = b.x * d.x + b.y * d.y;
  if (is_positive(before) && is_positive(behind)) return abs(turn(a, b)) / length_of(d.x, d.y);
  const Interval nearest = least(length_of(a.x, a.y), length_of(b.x, b.y));
  return may_be_positive(before) && may_be_positive(behind) ? Interval(0) : nearest;
}

// Finds the lines from one vertex to all vertices that it may see.
class View {
 public:
  View(const Mesh& mesh, const Bound& reach)
      : mesh_(mesh), reach_(reach), entered_(mesh.given_face_count()) {}

  std::map<Index, Interval> from(Index v) {
    for (const Index h : mesh_.outgoing(v)) {
      add(mesh_.head(h), norm(between(mesh_, v, mesh_.head(h))));
      add(mesh_.apex(h), norm(between(mesh_, v, mesh_.apex(h))));
      if (is_collapsed(mesh_, h) || is_collapsed(mesh_, Mesh::previous(h))) continue;
      const Point right = {norm(between(mesh_, v, mesh_.head(h))), 0};
      const Point left = apex_of(mesh_, h, {0, 0}, right);
      entered(h) = true;
      leave(Mesh::next(h), left, right, left, right);
      entered(h) = false;
    }
    return std::move(seen_);
  }

 private:
  void add(Index v, const Interval& length) {
    const auto [at, is_new] = seen_.try_emplace(v, length);
    if (!is_new) at->second = least(at->second, length);
  }

  void leave(Index h, const Point& left, const Point& right, const Point& l, const Point& r) {
    mesh_.for_each_sheet(h, [&](Index g) { enter(mesh_.twin(g), left, right, l, r); });
  }

  // Enters the face above h, which lies from left to right. All that may be seen lies between the
  // rays through l and r.
  void enter(Index h, const Point& left, const Point& right, const Point& l, const Point& r) {
    if (entered(h) || is_collapsed(mesh_, h)) return;
    const bool half_plane = is_zero(turn(r, l)) && is_positive(-(r.x * l.x + r.y * l.y));
    if (!may_be_positive(turn(r, l)) && !half_plane) return;
    if (lower(distance_to(left, right)) > reach_) return;
    entered(h) = true;
    crossed_.push_back({left, right});
    const Point apex = apex_of(mesh_, h, left, right);
    const Interval right_of_l = turn(apex, l), left_of_r = turn(r, apex);
    // A point on the line of a face without area sees the half-plane through one of its edges.
    const bool in_line = half_plane && is_zero(left_of_r) && is_zero(right_of_l);
    const bool is_left = in_line || may_be_positive(left_of_r);
    const bool is_right = in_line || may_be_positive(right_of_l);
    if (is_left && is_right) {
      const Interval length = length_of(apex.x, apex.y);
      add(mesh_.apex(h), in_line || is_seen(apex) ? length : from_below(length));
    }
    if (is_right) {
      leave(Mesh::previous(h), left, apex, l, in_line || is_positive(left_of_r) ? apex : r);
    }
    if (is_left) {
      leave(Mesh::next(h), apex, right, in_line || is_positive(right_of_l) ? apex : l, r);
    }
    crossed_.pop_back();
    entered(h) = false;
  }

  bool is_seen(const Point& p) const {
    return std::ranges::all_of(crossed_, [&](const auto& edge) {
      return is_positive(turn(p, edge.left)) && is_positive(turn(edge.right, p));
    });
  }

  std::vector<bool>::reference entered(Index h) {
    return entered_[h / 3 % mesh_.given_face_count()];
  }

  struct Edge {
    Point left, right;
  };

  const Mesh& mesh_;
  Bound reach_;
  std::vector<bool> entered_;  // a shortest path crosses no face twice
  std::vector<Edge> crossed_;
  std::map<Index, Interval> seen_;
};

using Lines = std::vector<std::vector<std::pair<Index, Interval>>>;

std::vector<Interval> shortest_chains(const Lines& lines, std::span<const Source> sources) {
  std::vector<Interval> reached(lines.size(), Interval(kInfinity));
  std::vector<Index> changed;
  const auto reach = [&](Index v, const Interval& d) {
    const Interval shorter = least(reached[v], d);
    if (lower(shorter) == lower(reached[v]) && upper(shorter) == upper(reached[v])) return;
    reached[v] = shorter;
    changed.push_back(v);
  };
  for (const Source& source : sources) reach(source.at.vertex, Interval(source.distance));
  while (!changed.empty()) {
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const Index v : std::exchange(changed, {})) {
      for (const auto& [w, length] : lines[v]) reach(w, reached[v] + length);
    }
  }
  return reached;
}

Lines edges_of(const Mesh& mesh) {
  Lines lines(mesh.vertex_count());
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const Interval length = norm(between(mesh, mesh.origin(h), mesh.head(h)));
    lines[mesh.origin(h)].emplace_back(mesh.head(h), length);
    lines[mesh.head(h)].emplace_back(mesh.origin(h), length);
  }
  return lines;
}

}  // namespace

Enclosures::Enclosures(const Mesh& mesh) : lines_(mesh.vertex_count()) {
  const Lines edges = edges_of(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    Bound reach = 0;
    for (const Interval& d : shortest_chains(edges, std::vector<Source>{{.at = v}})) {
      if (upper(d) < kInfinity) reach = std::max(reach, Bound(upper(d)));
    }
    for (const auto& [w, length] : View(mesh, reach).from(v)) lines_[v].emplace_back(w, length);
  }
}

std::vector<Interval> Enclosures::distances(std::span<const Source> sources) const {
  return shortest_chains(lines_, sources);
}

}  // namespace geodesic
