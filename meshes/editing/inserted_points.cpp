#include "meshes/editing/inserted_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "meshes/connectivity.h"
#include "meshes/editing/edited_mesh.h"
#include "meshes/editing/open_mesh.h"

namespace geodesic {
namespace {

auto order_of(const SurfacePoint& p) { return std::tie(p.vertex, p.face, p.weights); }

bool comes_before(const std::pair<SurfacePoint, Index>& a,
                  const std::pair<SurfacePoint, Index>& b) {
  return order_of(a.first) < order_of(b.first);
}

double distance(const Point2& a, const Point2& b) { return norm(Point2{a.x - b.x, a.y - b.y}); }

// Height of p above the line from a to b, positive on its left.
double height(const Point2& a, const Point2& b, const Point2& p) {
  return ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / distance(a, b);
}

// Subtracts the coordinate nearest to 0 along an axis from all of them if that changes no bit of
// their differences (Sterbenz 1974): a point between them then has more digits.
void move_to_origin(std::vector<Vec3>& positions) {
  const Box box = box_around(positions);
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = box.low[k], high = box.high[k];
    const double shift = low > 0 && high <= 2 * low ? low : high < 0 && low >= 2 * high ? high : 0;
    for (Vec3& p : positions) p[k] -= shift;
  }
}

// A side of an edge in one of its faces.
struct SheetSide {
  Index half_edge;
  bool turned;  // against the direction of the given half-edge
};

// Returns all sides of the edge of h, that of h first, without mirror images.
// @param h a half-edge of a face that is not a mirror image
std::vector<SheetSide> sides_of_edge(const Mesh& mesh, Index h) {
  std::vector<SheetSide> sides = {{h, false}};
  mesh.for_each_sheet(h, [&](Index g) {
    const Index twin = mesh.twin(g);
    const bool is_image = twin >= 3 * mesh.given_face_count();
    sides.push_back({is_image ? mesh.mirrored(twin) : twin, !is_image});
  });
  return sides;
}

// Builds the finer mesh. Points are first sorted by vertex, edge and face; then edges and faces are
// split at them. The edited mesh has one edge per sheet for an edge of several faces; the vertices
// on these edges have one number.
class Inserter {
 public:
  explicit Inserter(const Mesh& mesh) : mesh_(mesh), soup_(without_left_out(soup_of(mesh))) {
    places_.resize(soup_.triangles.size());
    for (Index face = 0, place = 0; face < mesh.external_face_count(); ++face) {
      const Index own = mesh.numbers().internal_face(face);
      if (own != kNone) places_[own] = place++;
    }
    move_to_origin(soup_.positions);
    for (const Vec3& p : soup_.positions) {
      for (const double c : p) place_ = std::max(place_, 0x1p-49 * std::abs(c));
    }
    TriangleSoup sheets = soup_;
    const std::vector<Index> originals = separate_sheets(sheets);
    numbers_.resize(soup_.positions.size());
    std::iota(numbers_.begin(), numbers_.end(), Index{0});
    numbers_.insert(numbers_.end(), originals.begin(), originals.end());
    edited_ = edited(sheets);
    edited_.add_property(face_of_);
    for (Index face = 0; face < soup_.triangles.size(); ++face) {
      edited_.property(face_of_, edited_.face_handle(places_[face])) = face;
    }
    corners_ = std::move(sheets.triangles);
  }

  double place() const { return place_; }

  std::vector<Index> insert(std::span<const SurfacePoint> points) {
    vertices_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) sort_in(i, points[i]);
    for (auto& [edge, on_edge] : on_edges_) insert_on_edge(edge, on_edge);
    for (const auto& [face, inside] : in_faces_) {
      for (const Inside& point : inside) insert_in_face(face, point);
    }
    return std::move(vertices_);
  }

  TriangleSoup take_soup() {
    soup_.triangles = soup_of(edited_).triangles;
    for (Triangle& face : soup_.triangles) {
      for (Index& corner : face) corner = numbers_[corner];
    }
    return std::move(soup_);
  }

 private:
  using Vertex = EditedMesh::VertexHandle;
  using Part = EditedMesh::FaceHandle;
  struct OnEdge {
    double position;  // from the origin of the half-edge of least number
    std::size_t point;
    Vec3 at;
  };
  struct OnSide {
    double position;
    Index vertex;  // external number
  };
  struct Inside {
    std::size_t point;
    InternalPoint at;
  };
  // A face of the given mesh: its parts, and their corners in its plane, scaled to a longest side
  // of 1, so that products of lengths stay within range.
  struct Plane {
    double longest = 0;
    std::vector<Part> parts;
    std::map<Vertex, Point2> at = {};
  };

  Index external_vertex(Index own) const { return mesh_.numbers().external_vertex(own); }

  // The origin of half-edge h in the edited mesh.
  Vertex origin(Index h) const { return edited_.vertex_handle(corners_[places_[h / 3]][h % 3]); }

  Vec3 position_in(const InternalPoint& own) const {
    Vec3 at{};
    const Triangle corners = mesh_.triangle(own.face);
    for (std::size_t k = 0; k < 3; ++k) {
      at = add(at, scale(own.weights[k], soup_.positions[external_vertex(corners[k])]));
    }
    return at;
  }

  Plane& plane_of(Index face) {
    Plane& plane = planes_[face];
    if (!plane.parts.empty()) return plane;
    const Index first = 3 * face;
    for (Index h = first; h < first + 3; ++h) {
      plane.longest = std::max(plane.longest, mesh_.half_edge(h).length);
    }
    plane.parts = {edited_.face_handle(places_[face])};
    const HalfEdge& base = mesh_.half_edge(first);
    const double unit = 1 / plane.longest;
    plane.at = {{origin(first), {0, 0}},
                {origin(first + 1), {unit * base.length, 0}},
                {origin(first + 2), {unit * base.apex_x, unit * base.apex_y}}};
    return plane;
  }

  // Assigns a point to a vertex, to an edge or to the inside of a face.
  void sort_in(std::size_t i, const SurfacePoint& point) {
    const std::string defect = defect_of(mesh_, point);
    if (!defect.empty()) throw std::invalid_argument(defect);
    if (point.is_vertex()) {
      vertices_[i] = point.vertex;
      return;
    }
    const InternalPoint own = in_internal_numbers(mesh_, point);
    Index edge = kNone;
    for (Index h = 3 * own.face; h < 3 * own.face + 3; ++h) {
      const Point2 at = in_frame(mesh_, own, h);
      if (norm(at) <= place_) {
        vertices_[i] = external_vertex(mesh_.origin(h));
        return;
      }
      // In a face without height all edges lie on nearly the same line.
      const double beyond = std::max({-at.x, at.x - mesh_.half_edge(h).length, 0.0});
      if (norm(Point2{beyond, at.y}) <= place_) edge = h;
    }
    if (edge == kNone) {
      in_faces_[own.face].push_back({i, own});
      return;
    }
    const double along = in_frame(mesh_, own, edge).x;
    const auto [least, turned] =
        std::ranges::min(sides_of_edge(mesh_, edge), {}, &SheetSide::half_edge);
    on_edges_[least].push_back(
        {turned ? mesh_.half_edge(edge).length - along : along, i, position_in(own)});
  }

  Index add_number(const Vec3& at) {
    const auto number = static_cast<Index>(soup_.positions.size());
    soup_.positions.push_back(at);
    if (!soup_.joined_to.empty()) soup_.joined_to.push_back(number);
    return number;
  }

  Vertex add_vertex(Index number) {
    numbers_.push_back(number);
    return edited_.add_vertex(to_point(soup_.positions[number]));
  }

  void insert_on_edge(Index h, std::vector<OnEdge>& points) {
    std::ranges::sort(points, {}, [](const OnEdge& p) { return std::pair(p.position, p.point); });
    std::vector<OnSide> added;
    for (const OnEdge& p : points) {
      if (added.empty() || p.position - added.back().position > place_) {
        added.push_back({p.position, add_number(p.at)});
      }
      vertices_[p.point] = added.back().vertex;
    }
    std::vector<OnSide> reversed(added.rbegin(), added.rend());
    for (OnSide& p : reversed) p.position = mesh_.half_edge(h).length - p.position;
    for (const auto& [side, turned] : sides_of_edge(mesh_, h)) {
      split_side(side, turned ? reversed : added);
    }
  }

  // @param points the points of the side, in order
  void split_side(Index side, const std::vector<OnSide>& points) {
    Plane& plane = plane_of(side / 3);
    const Vertex end = origin(Mesh::next(side));
    const Point2 begins = plane.at.at(origin(side)), ends = plane.at.at(end);
    Vertex from = origin(side);
    for (const OnSide& point : points) {
      // If the face beyond is in the same sheet, it has already split the edge.
      const auto around = edited_.vv_range(from);
      const auto there = std::find_if(around.begin(), around.end(), [&](Vertex v) {
        return numbers_[static_cast<std::size_t>(v.idx())] == point.vertex;
      });
      if (there != around.end()) {
        from = *there;
      } else {
        const Vertex added = add_vertex(point.vertex);
        split(edited_.edge_handle(edited_.find_halfedge(from, end)), added);
        from = added;
      }
      const double share = point.position / mesh_.half_edge(side).length;
      plane.at[from] = {begins.x + share * (ends.x - begins.x),
                        begins.y + share * (ends.y - begins.y)};
    }
  }

  void insert_in_face(Index face, const Inside& inside) {
    Plane& plane = plane_of(face);
    const Point2 own = in_frame(mesh_, inside.at, 3 * face);
    const Point2 at{own.x / plane.longest, own.y / plane.longest};
    const double place = place_ / plane.longest;
    const auto heights = [&](Part part) {
      std::array<double, 3> above;
      std::ranges::transform(edited_.fh_range(part), above.begin(), [&](auto side) {
        return height(plane.at.at(side.from()), plane.at.at(side.to()), at);
      });
      return above;
    };
    const Part part = std::ranges::max(plane.parts, {},
                                       [&](Part each) { return std::ranges::min(heights(each)); });
    for (const Vertex corner : edited_.fv_range(part)) {
      if (distance(plane.at.at(corner), at) > place) continue;
      vertices_[inside.point] = numbers_[static_cast<std::size_t>(corner.idx())];
      return;
    }
    const std::array<double, 3> above = heights(part);
    const auto lowest = std::ranges::min_element(above) - above.begin();
    const auto side = *std::next(edited_.fh_range(part).begin(), lowest);
    vertices_[inside.point] = add_number(position_in(inside.at));
    const Vertex added = add_vertex(vertices_[inside.point]);
    plane.at[added] = at;
    const auto is_inner = [&] {
      return !side.edge().is_boundary() &&
             edited_.property(face_of_, side.opp().face()) == edited_.property(face_of_, part);
    };
    if (above[static_cast<std::size_t>(lowest)] <= place && is_inner()) {
      split(side.edge(), added);
    } else {
      split(part, added);
    }
  }

  template <class Element>
  void split(Element edge_or_face, Vertex at) {
    auto part = static_cast<unsigned>(edited_.n_faces());
    edited_.split_copy(edge_or_face, at);  // the new faces inherit face_of_
    for (; part < edited_.n_faces(); ++part) {
      const Part added = edited_.face_handle(part);
      plane_of(edited_.property(face_of_, added)).parts.push_back(added);
    }
  }

  const Mesh& mesh_;
  TriangleSoup soup_;  // in external numbers
  double place_ = 0;
  EditedMesh edited_;
  std::vector<Index> numbers_;     // external numbers, by vertex of the edited mesh
  std::vector<Index> places_;      // of faces among those that are not left out, in external order
  std::vector<Triangle> corners_;  // in the edited mesh, by place
  OpenMesh::FPropHandleT<Index> face_of_;
  std::vector<Index> vertices_;                    // by point
  std::map<Index, Plane> planes_;                  // by face
  std::map<Index, std::vector<OnEdge>> on_edges_;  // by least half-edge of the edge
  std::map<Index, std::vector<Inside>> in_faces_;  // by face
};

}  // namespace

InsertedPoints::InsertedPoints(const Mesh& mesh, std::span<const SurfacePoint> points)
    : given_count_(mesh.vertex_count()) {
  Inserter inserter(mesh);
  const std::vector<Index> vertices = inserter.insert(points);
  place_ = inserter.place();
  mesh_ = std::make_unique<Mesh>(
      inserter.take_soup(),
      mesh.numbers().is_identity() ? Numbering::as_given : Numbering::along_surface,
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

}  // namespace geodesic
