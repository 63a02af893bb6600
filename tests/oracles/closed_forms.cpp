#include "tests/oracles/closed_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "tests/oracles/random.h"

namespace geodesic::oracles {
namespace {

struct Point {
  double x, y;
};

double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// Two triangles for the cell with corners a, b, c, d in counter-clockwise order.
void add_cell(TriangleSoup& soup, Index a, Index b, Index c, Index d, bool first_diagonal) {
  if (first_diagonal) {
    soup.triangles.insert(soup.triangles.end(), {{a, b, c}, {a, c, d}});
  } else {
    soup.triangles.insert(soup.triangles.end(), {{a, b, d}, {b, c, d}});
  }
}

double euclid(const std::vector<Point>& points, Index a, Index b) {
  return distance(points[a], points[b]);
}

}  // namespace

ClosedForm flat_grid(Index columns, Index rows, double shake, bool tilted) {
  Random random(7);
  TriangleSoup soup;
  std::vector<Point> points;
  for (Index j = 0; j <= rows; ++j) {
    for (Index i = 0; i <= columns; ++i) {
      const bool border_x = i == 0 || i == columns, border_y = j == 0 || j == rows;
      points.push_back({i + (border_x ? 0 : shake * random.between(-1, 1)),
                        j + (border_y ? 0 : shake * random.between(-1, 1))});
      const auto [x, y] = points.back();
      const double c = std::cos(0.4), s = std::sin(0.4);
      soup.positions.push_back(tilted ? Vec3{c * x, y * c + s * s * x, y * s - s * c * x}
                                      : Vec3{x, y, 0});
    }
  }
  const Index row = columns + 1;
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * row + i;
      add_cell(soup, a, a + 1, a + row + 1, a + row, (i + j) % 3 != 0);
    }
  }
  return {soup, [points](Index a, Index b) { return euclid(points, a, b); }};
}

// ---- box ------------------------------------------------------------------------------------

namespace {

// Faces of a box are numbered 2 * axis + side, side 0 at coordinate 0, side 1 at the box's size.
struct BoxFace {
  std::size_t axis;
  bool far;
  double sign() const { return far ? 1.0 : -1.0; }
};

// Where a face lies in the plane: a point `anchor` of it at `image`, unit steps along the three
// axes as `steps` (the one along the face's normal is not used).
struct Unfolding {
  BoxFace face;
  Vec3 anchor;
  Point image;
  std::array<Point, 3> steps;

  Point lay_out(const Vec3& p) const {
    Point q = image;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == face.axis) continue;
      q.x += (p[k] - anchor[k]) * steps[k].x;
      q.y += (p[k] - anchor[k]) * steps[k].y;
    }
    return q;
  }
};

struct Gate {
  Point a, b;
};

double side(const Point& s, const Point& t, const Point& p) {
  return (t.x - s.x) * (p.y - s.y) - (t.y - s.y) * (p.x - s.x);
}

class BoxUnfolder {
 public:
  BoxUnfolder(const Vec3& size, const Vec3& source, const Vec3& target)
      : size_(size), source_(source), target_(target) {}

  double least() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool far : {false, true}) {
        const BoxFace face = {axis, far};
        if (!lies_on(source_, face)) continue;
        std::array<Point, 3> steps = {};
        steps[(axis + 1) % 3] = {1, 0};
        steps[(axis + 2) % 3] = {0, 1};
        visit({face, source_, {0, 0}, steps});
      }
    }
    return least_;
  }

 private:
  bool lies_on(const Vec3& p, const BoxFace& f) const {
    return p[f.axis] == (f.far ? size_[f.axis] : 0.0);
  }

  void visit(const Unfolding& here) {
    const std::size_t number = 2 * here.face.axis + here.face.far;
    if (lies_on(target_, here.face)) try_straight_line(here.lay_out(target_));
    visited_[number] = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == here.face.axis) continue;
      for (const bool far : {false, true}) {
        if (!visited_[2 * axis + far]) cross_into({axis, far}, here);
      }
    }
    visited_[number] = false;
  }

  void cross_into(const BoxFace& next, const Unfolding& here) {
    const std::size_t from = here.face.axis, to = next.axis, along = 3 - from - to;
    Vec3 corner = {0, 0, 0};
    corner[from] = here.face.far ? size_[from] : 0;
    corner[to] = next.far ? size_[to] : 0;
    Vec3 other = corner;
    other[along] = size_[along];
    // Beyond the edge the way goes on against the normal of the face that is left.
    Unfolding there = {next, corner, here.lay_out(corner), here.steps};
    const double turn = -here.face.sign() * next.sign();
    there.steps[from] = {turn * here.steps[to].x, turn * here.steps[to].y};
    gates_.push_back({here.lay_out(corner), here.lay_out(other)});
    visit(there);
    gates_.pop_back();
  }

  // The source lies at (0, 0). A line that misses the end of a gate by the tolerance t would bend
  // there, which lengthens it by the square of t only.
  void try_straight_line(const Point& target) {
    const Point source = {0, 0};
    const double length = distance(source, target);
    const double tolerance = 1e-9 * (size_[0] + size_[1] + size_[2]);
    for (const Gate& gate : gates_) {
      const double a = side(source, target, gate.a), b = side(source, target, gate.b);
      if (std::min(a, b) > tolerance * length || std::max(a, b) < -tolerance * length) return;
      const double width = distance(gate.a, gate.b);
      const double s = side(gate.a, gate.b, source), t = side(gate.a, gate.b, target);
      if (std::min(s, t) > tolerance * width || std::max(s, t) < -tolerance * width) return;
    }
    least_ = std::min(least_, length);
  }

  Vec3 size_, source_, target_;
  std::array<bool, 6> visited_ = {};
  std::vector<Gate> gates_;
  double least_ = kInfinity;
};

}  // namespace

ClosedForm box(const Vec3& size, Index cells) {
  TriangleSoup soup;
  std::map<std::array<Index, 3>, Index> numbers;
  const auto vertex = [&](const std::array<Index, 3>& at) {
    const auto [entry, added] = numbers.try_emplace(at, static_cast<Index>(numbers.size()));
    if (added) {
      Vec3 p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = at[k] == cells ? size[k] : size[k] * at[k] / cells;
      soup.positions.push_back(p);
    }
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool far : {false, true}) {
      // Counter-clockwise from outside: u before v on the far side, v before u on the near one.
      const std::size_t u = (axis + (far ? 1 : 2)) % 3, v = (axis + (far ? 2 : 1)) % 3;
      const auto corner = [&](Index i, Index j) {
        std::array<Index, 3> at;
        at[axis] = far ? cells : 0;
        at[u] = i;
        at[v] = j;
        return vertex(at);
      };
      for (Index j = 0; j < cells; ++j) {
        for (Index i = 0; i < cells; ++i) {
          add_cell(soup, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1),
                   (i + j) % 2 == 0);
        }
      }
    }
  }
  return {soup, [size, positions = soup.positions](Index a, Index b) {
            return BoxUnfolder(size, positions[a], positions[b]).least();
          }};
}

// ---- cone and saddle --------------------------------------------------------------------------

namespace {

struct Polar {
  double radius, angle;
};

// Triangles with a common apex at the origin, between each leg (a unit vector) and the next.
ClosedForm sectors(const std::vector<Vec3>& legs, Index levels) {
  const Index count = static_cast<Index>(legs.size());
  const Vec3 &p = legs[0], &q = legs[1];
  const double cosine = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  const double sine =
      std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
  const double sector = std::atan2(sine, cosine);

  // Row r holds count * r vertices; number j of sector i is its (i r + j)-th.
  const auto vertex = [count](Index i, Index row, Index j) {
    return row == 0 ? 0 : 1 + count * (row * (row - 1) / 2) + (i * row + j) % (count * row);
  };
  TriangleSoup soup;
  soup.positions.push_back({0, 0, 0});
  std::vector<Polar> polar = {{0, 0}};
  for (Index row = 1; row <= levels; ++row) {
    for (Index i = 0; i < count; ++i) {
      for (Index j = 0; j < row; ++j) {
        const double s = static_cast<double>(row - j) / levels;
        const double t = static_cast<double>(j) / levels;
        const Vec3 &a = legs[i], &b = legs[(i + 1) % count];
        soup.positions.push_back({s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]});
        const Point flat = {s + t * cosine, t * sine};
        polar.push_back({std::hypot(flat.x, flat.y), i * sector + std::atan2(flat.y, flat.x)});
      }
    }
  }
  for (Index i = 0; i < count; ++i) {
    for (Index row = 0; row < levels; ++row) {
      for (Index j = 0; j <= row; ++j) {
        soup.triangles.push_back(
            {vertex(i, row, j), vertex(i, row + 1, j), vertex(i, row + 1, j + 1)});
        if (j == row) continue;
        soup.triangles.push_back(
            {vertex(i, row, j), vertex(i, row + 1, j + 1), vertex(i, row, j + 1)});
      }
    }
  }
  const double total = count * sector;
  return {soup, [polar, total](Index a, Index b) {
            const double one_way = std::abs(polar[a].angle - polar[b].angle);
            const double angle = std::min(one_way, total - one_way);
            const double r = polar[a].radius, s = polar[b].radius;
            if (angle >= std::numbers::pi) return r + s;
            // The law of cosines, in a form that loses no digits when the angle is small.
            return std::hypot(r - s, 2 * std::sqrt(r * s) * std::sin(angle / 2));
          }};
}

Vec3 leg(double azimuth, double slope) {
  return {std::cos(slope) * std::cos(azimuth), std::cos(slope) * std::sin(azimuth),
          std::sin(slope)};
}

}  // namespace

ClosedForm cone(Index count, double slope, Index levels) {
  std::vector<Vec3> legs;
  for (Index i = 0; i < count; ++i) legs.push_back(leg(2 * std::numbers::pi * i / count, -slope));
  return sectors(legs, levels);
}

ClosedForm saddle(Index count, double slope, Index levels) {
  std::vector<Vec3> legs;
  for (Index i = 0; i < count; ++i) {
    legs.push_back(leg(2 * std::numbers::pi * i / count, i % 2 == 0 ? slope : -slope));
  }
  return sectors(legs, levels);
}

// ---- cylinder -----------------------------------------------------------------------------------

ClosedForm cylinder(Index count, Index rows, Index columns) {
  const double step = 2 * std::numbers::pi / count, radius = 0.5 / std::sin(step / 2);
  const Index around = count * columns;
  TriangleSoup soup;
  for (Index j = 0; j <= rows; ++j) {
    for (Index i = 0; i < around; ++i) {
      const double t = static_cast<double>(i % columns) / columns;
      const double a = step * (i / columns), b = step * (i / columns + 1);
      soup.positions.push_back({radius * ((1 - t) * std::cos(a) + t * std::cos(b)),
                                radius * ((1 - t) * std::sin(a) + t * std::sin(b)),
                                static_cast<double>(j)});
    }
  }
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < around; ++i) {
      const Index a = j * around + i, b = j * around + (i + 1) % around;
      add_cell(soup, a, b, b + around, a + around, (i + j) % 2 == 0);
    }
  }
  return {soup, [=](Index a, Index b) {
            const double u = std::abs(static_cast<double>(a % around) - b % around) / columns;
            const double z = std::abs(static_cast<double>(a / around) - b / around);
            return std::hypot(std::min(u, count - u), z);
          }};
}

// ---- square with a hole -----------------------------------------------------------------------

namespace {

// True when the segment meets the open square (lo, hi) x (lo, hi).
bool is_blocked(const Point& p, const Point& q, double lo, double hi) {
  double enter = 0, leave = 1;
  for (const auto& [from, to] : {std::pair{p.x, q.x}, std::pair{p.y, q.y}}) {
    if (from == to) {
      if (from <= lo || from >= hi) return false;
      continue;
    }
    const double at_lo = (lo - from) / (to - from), at_hi = (hi - from) / (to - from);
    enter = std::max(enter, std::min(at_lo, at_hi));
    leave = std::min(leave, std::max(at_lo, at_hi));
  }
  return enter < leave;
}

// Shortest path over the visibility graph of two points and the square's corners.
double around_square(const Point& a, const Point& b, double lo, double hi) {
  const std::array<Point, 6> nodes = {a, b, {lo, lo}, {lo, hi}, {hi, lo}, {hi, hi}};
  std::array<double, 6> reached;
  reached.fill(kInfinity);
  reached[0] = 0;
  for (std::size_t round = 0; round < nodes.size(); ++round) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t j = 0; j < nodes.size(); ++j) {
        if (is_blocked(nodes[i], nodes[j], lo, hi)) continue;
        reached[j] = std::min(reached[j], reached[i] + distance(nodes[i], nodes[j]));
      }
    }
  }
  return reached[1];
}

}  // namespace

ClosedForm square_with_hole(Index size, Index hole) {
  const Index lo = (size - hole) / 2, hi = lo + hole;
  TriangleSoup soup;
  std::vector<Point> points;
  std::map<std::pair<Index, Index>, Index> numbers;
  const auto vertex = [&](Index i, Index j) {
    const auto [entry, added] = numbers.try_emplace({i, j}, static_cast<Index>(numbers.size()));
    if (added) {
      points.push_back({static_cast<double>(i), static_cast<double>(j)});
      soup.positions.push_back({points.back().x, points.back().y, 0});
    }
    return entry->second;
  };
  for (Index j = 0; j < size; ++j) {
    for (Index i = 0; i < size; ++i) {
      if (i >= lo && i < hi && j >= lo && j < hi) continue;
      add_cell(soup, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1),
               (i + j) % 2 == 0);
    }
  }
  return {soup, [=](Index a, Index b) { return around_square(points[a], points[b], lo, hi); }};
}

}  // namespace geodesic::oracles
