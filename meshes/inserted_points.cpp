#include "meshes/inserted_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace geodesic {
namespace {

auto order_of(const SurfacePoint& p) { return std::tie(p.vertex, p.face, p.weights); }

bool comes_before(const std::pair<SurfacePoint, Index>& a,
                  const std::pair<SurfacePoint, Index>& b) {
  return order_of(a.first) < order_of(b.first);
}

double distance(const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// Of p above the line from a to b, positive on its left.
double height(const Point2& a, const Point2& b, const Point2& p) {
  return ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / distance(a, b);
}

// All coordinates along an axis less the lowest one, where that changes no bit of their differences
// (Sterbenz 1974): a point between them then has more digits.
void move_to_origin(std::vector<Vec3>& positions) {
  const Box box = box_around(positions);
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = box.low[k], high = box.high[k];
    const double shift = low > 0 && high <= 2 * low ? low : high < 0 && low >= 2 * high ? high : 0;
    for (Vec3& p : positions) p[k] -= shift;
  }
}

TriangleSoup as_given(const Mesh& mesh) {
  const MeshNumbers& numbers = mesh.numbers();
  TriangleSoup soup{std::vector<Vec3>(mesh.vertex_count()),
                    std::vector<Triangle>(mesh.given_face_count())};
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    soup.positions[numbers.given_vertex(v)] = mesh.position(v);
  }
  for (Index f = 0; f < mesh.given_face_count(); ++f) {
    Triangle& given = soup.triangles[numbers.given_face(f)];
    given = mesh.triangle(f);
    for (Index& corner : given) corner = numbers.given_vertex(corner);
  }
  return soup;
}

// A vertex of a finer mesh, in the plane of a face.
struct PlanarVertex {
  Index vertex;
  Point2 at;
};

// The triangles that take the place of a face.
class SplitFace {
 public:
  // @param place within which points are the same, in the unit of the plane
  SplitFace(const std::array<PlanarVertex, 3>& corners, double place)
      : place_(place), vertices_(corners.begin(), corners.end()), triangles_{{0, 1, 2}} {}

  // Splits the side that begins at corner k at points on it, in order along it. Before any point
  // inside.
  void split_side(Index k, std::span<const PlanarVertex> points) {
    const Side side = find(k, (k + 1) % 3);
    const Triangle whole = triangles_[side.triangle];
    const Index end = (k + 1) % 3, apex = whole[(side.number + 2) % 3];
    Index from = k;
    for (const PlanarVertex& point : points) {
      const Index added = add(point);
      triangles_.push_back({from, added, apex});
      from = added;
    }
    triangles_[side.triangle] = {from, end, apex};
  }

  // The vertex at a point inside the face: one that is there, or a new one.
  // @param make returns the number of a new vertex
  template <class Make>
  Index insert(const Point2& at, const Make& make) {
    const std::size_t around = triangle_around(at);
    const Triangle corners = triangles_[around];
    for (const Index corner : corners) {
      if (distance(vertices_[corner].at, at) <= place_) return vertices_[corner].vertex;
    }
    const std::array<double, 3> above = heights(corners, at);
    const auto lowest = static_cast<Index>(std::ranges::min_element(above) - above.begin());
    const Side beyond =
        above[lowest] <= place_ ? find(corners[(lowest + 1) % 3], corners[lowest]) : Side{};
    const Index vertex = make();
    const Index added = add({vertex, at});
    split(around, added, beyond.number == kNone ? kNone : lowest);
    if (beyond.number != kNone) split(beyond.triangle, added, beyond.number);
    return vertex;
  }

  // With the numbers of their vertices.
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> numbered = triangles_;
    for (Triangle& t : numbered) {
      for (Index& corner : t) corner = vertices_[corner].vertex;
    }
    return numbered;
  }

 private:
  struct Side {
    std::size_t triangle = 0;
    Index number = kNone;  // 0 to 2; kNone: there is no such side
  };

  Index add(const PlanarVertex& vertex) {
    vertices_.push_back(vertex);
    return static_cast<Index>(vertices_.size() - 1);
  }

  Side find(Index from, Index to) const {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (Index k = 0; k < 3; ++k) {
        if (triangles_[t][k] == from && triangles_[t][(k + 1) % 3] == to) return {t, k};
      }
    }
    return {};
  }

  // Replaces a triangle by those between a point and its sides, but for the side that the point
  // lies on.
  void split(std::size_t triangle, Index point, Index lies_on) {
    const Triangle whole = triangles_[triangle];
    bool replaced = false;
    for (Index k = 0; k < 3; ++k) {
      if (k == lies_on) continue;
      const Triangle part{whole[k], whole[(k + 1) % 3], point};
      if (replaced) {
        triangles_.push_back(part);
      } else {
        triangles_[triangle] = part;
      }
      replaced = true;
    }
  }

  std::array<double, 3> heights(const Triangle& t, const Point2& at) const {
    std::array<double, 3> above;
    for (std::size_t k = 0; k < 3; ++k) {
      above[k] = height(vertices_[t[k]].at, vertices_[t[(k + 1) % 3]].at, at);
    }
    return above;
  }

  std::size_t triangle_around(const Point2& at) const {
    std::size_t around = 0;
    double greatest = -kInfinity;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const double least = std::ranges::min(heights(triangles_[t], at));
      if (!(least > greatest)) continue;
      greatest = least;
      around = t;
    }
    return around;
  }

  double place_;
  std::vector<PlanarVertex> vertices_;
  std::vector<Triangle> triangles_;
};

// A face's side of an edge.
struct EdgeSide {
  Index half_edge;
  bool turned;  // against the one that was asked for
};

// All sides of the edge of h, its own first; none of mirror images.
// @param h of a face that is no mirror image
std::vector<EdgeSide> sides_of_edge(const Mesh& mesh, Index h) {
  std::vector<EdgeSide> sides = {{h, false}};
  mesh.for_each_sheet(h, [&](Index g) {
    const Index twin = mesh.twin(g);
    const bool is_image = twin >= 3 * mesh.given_face_count();
    sides.push_back({is_image ? mesh.mirrored(twin) : twin, !is_image});
  });
  return sides;
}

// Builds the finer mesh: points are first sorted by where they lie, then edges get theirs, then
// faces are split.
class Inserter {
 public:
  explicit Inserter(const Mesh& mesh) : mesh_(mesh), soup_(as_given(mesh)) {
    move_to_origin(soup_.positions);
    for (const Vec3& p : soup_.positions) {
      for (const double c : p) place_ = std::max(place_, 0x1p-49 * std::abs(c));
    }
  }

  double place() const { return place_; }

  std::vector<Index> insert(std::span<const SurfacePoint> points) {
    vertices_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) sort_in(i, points[i]);
    for (auto& [edge, on_edge] : on_edges_) insert_on_edge(edge, on_edge);
    for (const auto& [face, inside] : in_faces_) split_face(face, inside);
    return std::move(vertices_);
  }

  TriangleSoup take_soup() { return std::move(soup_); }

 private:
  struct OnEdge {
    double position;  // from the origin of the half-edge of least number
    std::size_t point;
    Vec3 at;
  };
  struct OnSide {
    double position;
    Index vertex;  // given number
  };
  struct Inside {
    std::size_t point;
    SurfacePoint own;
  };

  const Vec3& position(Index own_vertex) const {
    return soup_.positions[mesh_.numbers().given_vertex(own_vertex)];
  }

  Vec3 position_in(const SurfacePoint& own) const {
    Vec3 at{};
    const Triangle corners = mesh_.triangle(own.face);
    for (std::size_t k = 0; k < 3; ++k) at = add(at, scale(own.weights[k], position(corners[k])));
    return at;
  }

  // To a vertex, an edge or the inside of a face.
  void sort_in(std::size_t i, const SurfacePoint& point) {
    const std::string defect = defect_of(mesh_, point);
    if (!defect.empty()) throw std::invalid_argument(defect);
    if (point.is_vertex()) {
      vertices_[i] = point.vertex;
      return;
    }
    const SurfacePoint own = in_own_numbers(mesh_, point);
    Index edge = kNone;
    for (Index h = 3 * own.face; h < 3 * own.face + 3; ++h) {
      const Point2 at = in_frame(mesh_, own, h);
      if (std::hypot(at.x, at.y) <= place_) {
        vertices_[i] = mesh_.numbers().given_vertex(mesh_.origin(h));
        return;
      }
      if (at.y <= place_) edge = h;
    }
    if (edge == kNone) {
      in_faces_[own.face].push_back({i, own});
      return;
    }
    const double along = in_frame(mesh_, own, edge).x;
    const auto [least, turned] =
        std::ranges::min(sides_of_edge(mesh_, edge), {}, &EdgeSide::half_edge);
    on_edges_[least].push_back(
        {turned ? mesh_.half_edge(edge).length - along : along, i, position_in(own)});
  }

  Index add_vertex(const Vec3& at) {
    soup_.positions.push_back(at);
    return static_cast<Index>(soup_.positions.size() - 1);
  }

  void insert_on_edge(Index h, std::vector<OnEdge>& points) {
    std::ranges::sort(points, {}, [](const OnEdge& p) { return std::pair(p.position, p.point); });
    std::vector<OnSide> added;
    for (const OnEdge& p : points) {
      if (added.empty() || p.position - added.back().position > place_) {
        added.push_back({p.position, add_vertex(p.at)});
      }
      vertices_[p.point] = added.back().vertex;
    }
    std::vector<OnSide> reversed(added.rbegin(), added.rend());
    for (OnSide& p : reversed) p.position = mesh_.half_edge(h).length - p.position;
    for (const auto& [side, turned] : sides_of_edge(mesh_, h)) {
      in_faces_[side / 3];
      sides_[side] = turned ? reversed : added;
    }
  }

  void split_face(Index face, const std::vector<Inside>& points) {
    const Index first = 3 * face;
    const HalfEdge& base = mesh_.half_edge(first);
    // In a plane where the longest side is 1: products of lengths stay within range.
    double longest = 0;
    for (Index h = first; h < first + 3; ++h) {
      longest = std::max(longest, mesh_.half_edge(h).length);
    }
    const auto scaled = [&](const Point2& p) { return Point2{p.x / longest, p.y / longest}; };
    std::array<PlanarVertex, 3> corners{{{kNone, {0, 0}},
                                         {kNone, scaled({base.length, 0})},
                                         {kNone, scaled({base.apex_x, base.apex_y})}}};
    for (Index k = 0; k < 3; ++k) {
      corners[k].vertex = mesh_.numbers().given_vertex(mesh_.origin(first + k));
    }
    SplitFace split(corners, place_ / longest);
    for (Index k = 0; k < 3; ++k) {
      const auto side = sides_.find(first + k);
      if (side == sides_.end()) continue;
      const Point2 &from = corners[k].at, &to = corners[(k + 1) % 3].at;
      std::vector<PlanarVertex> on_side;
      for (const OnSide& p : side->second) {
        const double share = p.position / mesh_.half_edge(first + k).length;
        on_side.push_back(
            {p.vertex, {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}});
      }
      split.split_side(k, on_side);
    }
    for (const Inside& p : points) {
      vertices_[p.point] = split.insert(scaled(in_frame(mesh_, p.own, first)),
                                        [&] { return add_vertex(position_in(p.own)); });
    }
    const std::vector<Triangle> parts = split.triangles();
    soup_.triangles[mesh_.numbers().given_face(face)] = parts.front();
    soup_.triangles.insert(soup_.triangles.end(), parts.begin() + 1, parts.end());
  }

  const Mesh& mesh_;
  TriangleSoup soup_;
  double place_ = 0;
  std::vector<Index> vertices_;                    // by point
  std::map<Index, std::vector<OnEdge>> on_edges_;  // by half-edge, the least of the edge
  std::map<Index, std::vector<OnSide>> sides_;     // by half-edge, in order along it
  std::map<Index, std::vector<Inside>> in_faces_;  // by face: all that are split
};

std::vector<SurfacePoint> joined(std::span<const SurfacePoint> a, std::span<const SurfacePoint> b) {
  std::vector<SurfacePoint> both(a.begin(), a.end());
  both.insert(both.end(), b.begin(), b.end());
  return both;
}

// A point as one of a face: of each that it lies in, a vertex included.
struct InFace {
  Index face;
  std::array<double, 3> weights;
};

// @param own in the mesh's own numbers
std::vector<InFace> faces_of(const Mesh& mesh, const SurfacePoint& own) {
  std::vector<InFace> faces;
  if (!own.is_vertex()) {
    for (const SurfacePoint& image : images_of(mesh, own)) {
      faces.push_back({image.face, image.weights});
    }
    return faces;
  }
  for (const Index h : mesh.outgoing(own.vertex)) {
    faces.push_back({h / 3, {}});
    faces.back().weights[h % 3] = 1;
  }
  return faces;
}

// Of the line within a face that both points lie in, kInfinity where there is none. From weights:
// short ones keep their digits.
double straight_length(const Mesh& mesh, const std::vector<InFace>& from,
                       const std::vector<InFace>& to) {
  double least = kInfinity;
  for (const InFace& a : from) {
    for (const InFace& b : to) {
      if (a.face != b.face) continue;
      const auto k = static_cast<Index>(std::ranges::max_element(a.weights) - a.weights.begin());
      const HalfEdge& e = mesh.half_edge(3 * a.face + k);
      const Index head = (k + 1) % 3, apex = (k + 2) % 3;
      const double x = b.weights[head] - a.weights[head], y = b.weights[apex] - a.weights[apex];
      least = std::min(least, std::hypot(x * e.length + y * e.apex_x, y * e.apex_y));
    }
  }
  return least;
}

bool takes(const Description& solver, std::span<const SurfacePoint> sources,
           std::span<const SurfacePoint> targets) {
  const auto are_vertices = [](std::span<const SurfacePoint> points) {
    return std::ranges::all_of(points, &SurfacePoint::is_vertex);
  };
  return (are_vertices(sources) || solver.abilities.surface_sources) &&
         (are_vertices(targets) || solver.abilities.paths);
}

}  // namespace

InsertedPoints::InsertedPoints(const Mesh& mesh, std::span<const SurfacePoint> points)
    : given_count_(mesh.vertex_count()) {
  Inserter inserter(mesh);
  const std::vector<Index> vertices = inserter.insert(points);
  place_ = inserter.place();
  mesh_ = std::make_unique<Mesh>(
      inserter.take_soup(),
      mesh.numbers().are_given() ? Numbering::as_given : Numbering::along_surface,
      mesh.non_manifold_edges());
  for (std::size_t i = 0; i < points.size(); ++i) vertices_.emplace_back(points[i], vertices[i]);
  std::ranges::sort(vertices_, comes_before);
}

Index InsertedPoints::vertex(const SurfacePoint& point) const {
  if (point.is_vertex() && point.vertex < given_count_) return point.vertex;
  const auto found = std::lower_bound(vertices_.begin(), vertices_.end(),
                                      std::pair(point, Index{0}), comes_before);
  if (found == vertices_.end() || found->first != point) {
    throw std::invalid_argument("a point that was not inserted");
  }
  return found->second;
}

Query InsertedPoints::translated(const Query& query) const {
  Query own = query;
  for (Source& source : own.sources) source.at = vertex(source.at);
  for (SurfacePoint& target : own.targets) target = vertex(target);
  return own;
}

std::shared_ptr<const InsertedPoints> insert_for(const Description& solver, const Mesh& mesh,
                                                 std::span<const SurfacePoint> sources,
                                                 std::span<const SurfacePoint> targets) {
  const std::vector<SurfacePoint> points = joined(sources, targets);
  for (const SurfacePoint& point : points) {
    const std::string defect = defect_of(mesh, point);
    if (!defect.empty()) throw std::invalid_argument(defect);
  }
  if (takes(solver, sources, targets)) return nullptr;
  return std::make_shared<const InsertedPoints>(mesh, points);
}

PointSolver::PointSolver(std::string_view solver, const Mesh& mesh,
                         std::shared_ptr<const InsertedPoints> inserted)
    : description_(solver_named(solver)),
      mesh_(mesh),
      inserted_(std::move(inserted)),
      solver_(make_solver(solver, inserted_ == nullptr ? mesh : inserted_->mesh())) {}

void PointSolver::solve(const Query& query, std::span<double> distances,
                        std::span<double> at_targets) {
  if (at_targets.size() != query.targets.size()) {
    throw std::invalid_argument(description_.name + ": needs room for one distance a target");
  }
  if (inserted_ != nullptr) return solve_inserted(query, distances, at_targets);
  if (std::ranges::all_of(query.targets, &SurfacePoint::is_vertex)) {
    solver_->solve(query, distances);
    for (std::size_t i = 0; i < at_targets.size(); ++i) {
      at_targets[i] = distances[query.targets[i].vertex];
    }
    return;
  }
  Recording recording;
  recording.what = Record::paths;
  solver_->solve(query, distances, &recording);
  std::ranges::transform(recording.targets, at_targets.begin(), &AtTarget::distance);
}

void PointSolver::solve_inserted(const Query& query, std::span<double> distances,
                                 std::span<double> at_targets) {
  const Query finer = inserted_->translated(query);
  finer_.resize(inserted_->mesh().vertex_count());
  if (distances.size() != mesh_.vertex_count()) {
    throw std::invalid_argument(description_.name + ": needs room for one distance a vertex");
  }
  solver_->solve(finer, finer_);
  std::copy_n(finer_.begin(), distances.size(), distances.begin());
  for (std::size_t i = 0; i < at_targets.size(); ++i) {
    at_targets[i] = finer_[finer.targets[i].vertex];
  }
  correct_near_sources(query, distances, at_targets);
}

// Next to a source, where a point's place in space is known to a few digits only, the line within
// the face has all of them.
void PointSolver::correct_near_sources(const Query& query, std::span<double> distances,
                                       std::span<double> at_targets) const {
  const auto correct = [&](double& distance, double straight) {
    if (std::abs(distance - straight) <= 4 * inserted_->place()) distance = straight;
  };
  std::vector<std::vector<InFace>> targets;
  for (const SurfacePoint& target : query.targets) {
    targets.push_back(faces_of(mesh_, in_own_numbers(mesh_, target)));
  }
  for (const Source& source : query.sources) {
    const std::vector<InFace> at = faces_of(mesh_, in_own_numbers(mesh_, source.at));
    const auto line = [&](const std::vector<InFace>& to) {
      return source.distance + straight_length(mesh_, at, to);
    };
    for (std::size_t i = 0; i < targets.size(); ++i) correct(at_targets[i], line(targets[i]));
    if (source.at.is_vertex()) continue;
    for (const InFace& face : at) {
      for (const Index corner : mesh_.triangle(face.face)) {
        correct(distances[mesh_.numbers().given_vertex(corner)], line(faces_of(mesh_, corner)));
      }
    }
  }
}

}  // namespace geodesic
