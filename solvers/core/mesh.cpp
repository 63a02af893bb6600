#include "solvers/core/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "solvers/core/mesh_input.h"
#include "solvers/core/messages.h"
#include "solvers/core/tolerance.h"

namespace geodesic {

namespace {

std::vector<Triangle> chosen(std::span<const Triangle> triangles, std::span<const Index> faces) {
  std::vector<Triangle> list;
  list.reserve(faces.size());
  for (const Index f : faces) list.push_back(triangles[f]);
  return list;
}

}  // namespace

void check_extent(std::span<const Vec3> positions) {
  const double half = box_around(positions).half_extent();
  if (half == 0 || (half >= kLeastExtent / 2 && half <= kGreatestExtent / 2)) return;
  throw std::invalid_argument("the longest side of the mesh is " + significant(2 * half, 3) +
                              ", and must be from " + significant(kLeastExtent, 3) + " to " +
                              significant(kGreatestExtent, 3) + "; scale it");
}

void check_names(std::size_t vertices, std::span<const Triangle> triangles,
                 std::span<const Index> joined_to, const std::vector<bool>& left_out) {
  if (!left_out.empty() && left_out.size() != triangles.size()) {
    throw std::invalid_argument("left_out has " + std::to_string(left_out.size()) + " flags for " +
                                std::to_string(triangles.size()) + " triangles");
  }
  if (joined_to.empty()) return;
  if (joined_to.size() != vertices) {
    throw std::invalid_argument("joined_to has " + std::to_string(joined_to.size()) +
                                " numbers for " + std::to_string(vertices) + " vertices");
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    const Index first = joined_to[v];
    if (first < vertices && joined_to[first] == first) continue;
    throw std::invalid_argument(
        "vertex " + std::to_string(v) + " is joined to vertex " + std::to_string(first) +
        (first < vertices ? ", which is joined to another one" : ", which is not there"));
  }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!left_out.empty() && left_out[f]) continue;
    for (const Index v : triangles[f]) {
      if (v >= vertices || joined_to[v] == v) continue;
      throw std::invalid_argument("face " + std::to_string(f) + " names vertex " +
                                  std::to_string(v) + ", which is joined to vertex " +
                                  std::to_string(joined_to[v]) + "; it must name that one");
    }
  }
}

void check_mesh_input(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                      const std::vector<bool>& left_out) {
  if (positions.size() >= kNone || triangles.size() >= kNone / 3) {
    throw std::invalid_argument("mesh too large: indices have 32 bits");
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!is_finite(positions[v])) {
      throw std::invalid_argument("vertex " + std::to_string(v) + " has a non-finite coordinate");
    }
  }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!left_out.empty() && left_out[f]) continue;
    const auto& [a, b, c] = triangles[f];
    if (std::max({a, b, c}) >= positions.size()) {
      throw std::invalid_argument("face " + std::to_string(f) +
                                  " names a vertex that is not there");
    }
    if (a == b || b == c || c == a) {
      throw std::invalid_argument("face " + std::to_string(f) + " names a vertex twice");
    }
  }
  check_extent(positions);
}

Mesh::Mesh(std::span<const Vec3> positions, std::span<const Triangle> triangles,
           std::span<const Index> joined_to, const std::vector<bool>& left_out, Numbering numbering,
           NonManifoldEdges non_manifold_edges) {
  check_names(positions.size(), triangles, joined_to, left_out);
  check_mesh_input(positions, triangles, left_out);
  external_faces_ = static_cast<Index>(triangles.size());
  std::vector<Index> faces;
  faces.reserve(triangles.size());
  for (Index f = 0; f < triangles.size(); ++f) {
    if (left_out.empty() || !left_out[f]) faces.push_back(f);
  }
  if (numbering == Numbering::along_surface) {
    number_along_surface(positions, triangles, faces);
  } else {
    positions_.assign(positions.begin(), positions.end());
    set_faces(chosen(triangles, faces));
    if (!joined_to.empty() || faces.size() < triangles.size()) {
      std::vector<Index> vertices(positions.size());
      std::iota(vertices.begin(), vertices.end(), Index{0});
      numbers_ = MeshNumbers(std::move(vertices), std::move(faces), triangles.size());
    }
  }
  if (!joined_to.empty()) numbers_.join(joined_to);
  index_outgoing(half_edge_count());
  const bool is_cut = link_twins();
  if (is_cut && non_manifold_edges == NonManifoldEdges::crossed) {
    add_mirror_images();
    index_outgoing(half_edge_count());
    link_sheets();
  }
  compute_frames();
  classify_vertices();
}

Mesh::Mesh(Part part)
    : positions_(std::move(part.positions)),
      half_edges_(std::move(part.half_edges)),
      pseudo_source_(std::move(part.pseudo_source)),
      mean_edge_length_(part.mean_edge_length) {
  index_outgoing(3 * part.faces);
}

void Mesh::number_along_surface(std::span<const Vec3> positions,
                                std::span<const Triangle> triangles, std::span<const Index> faces) {
  std::vector<Triangle> renamed = chosen(triangles, faces);
  std::vector<std::uint8_t> is_corner(positions.size(), 0);
  for (const Triangle& t : renamed) {
    for (const Index v : t) is_corner[v] = 1;
  }
  std::vector<Index> vertices(positions.size()), own(positions.size());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  // Isolated vertices come last.
  const auto isolated =
      std::ranges::stable_partition(vertices, [&](Index v) { return is_corner[v] != 0; });
  const std::span corners(vertices.begin(), isolated.begin());
  std::ranges::transform(cells_along_curve(positions, corners), corners.begin(), &OnCurve::vertex);
  positions_.resize(vertices.size());
  for (Index v = 0; v < vertices.size(); ++v) {
    own[vertices[v]] = v;
    positions_[v] = positions[vertices[v]];
  }
  for (Triangle& t : renamed) {
    for (Index& corner : t) corner = own[corner];
  }
  std::vector<Index> order = order_by_least_vertex(renamed, vertex_count());
  set_faces(chosen(renamed, order));
  for (Index& f : order) f = faces[f];
  numbers_ = MeshNumbers(std::move(vertices), std::move(order), triangles.size());
}

void Mesh::set_faces(std::span<const Triangle> triangles) {
  half_edges_.resize(3 * triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) half_edges_[3 * f + k].origin = triangles[f][k];
  }
}

void Mesh::index_outgoing(Index half_edges) {
  first_outgoing_.assign(positions_.size() + 1, 0);
  for (Index h = 0; h < half_edges; ++h) ++first_outgoing_[origin(h) + 1];
  for (std::size_t v = 0; v < positions_.size(); ++v) first_outgoing_[v + 1] += first_outgoing_[v];
  outgoing_.resize(half_edges);
  std::vector<Index> fill(first_outgoing_.begin(), first_outgoing_.end() - 1);
  for (Index h = 0; h < half_edges; ++h) outgoing_[fill[origin(h)]++] = h;
}

// @return whether some edge has several faces and no twins
bool Mesh::link_twins() {
  for (HalfEdge& e : half_edges_) e.twin = kNone;
  bool is_cut = false;
  // For vertex a: the half-edges a -> b and b -> a of each neighbour b > a, as b 2^32 + half-edge.
  // Sorting them avoids quadratic time at a vertex of very high valence.
  std::vector<std::uint64_t> sides;
  const auto add_side = [&sides](Index neighbour, Index h) {
    sides.push_back(std::uint64_t{neighbour} << 32 | h);
  };
  const auto neighbour_of = [&sides](std::size_t i) { return sides[i] >> 32; };
  edge_count_ = 0;
  for (Index a = 0; a < vertex_count(); ++a) {
    sides.clear();
    for (const Index h : outgoing(a)) {
      if (head(h) > a) add_side(head(h), h);
      const Index into = previous(h);
      if (origin(into) > a) add_side(origin(into), into);
    }
    std::ranges::sort(sides);
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && neighbour_of(end) == neighbour_of(i)) ++end;
      const auto h = static_cast<Index>(sides[i]), g = static_cast<Index>(sides[end - 1]);
      if (end - i == 2 && origin(h) != origin(g)) {  // one leaves a, the other arrives
        half_edges_[h].twin = g;
        half_edges_[g].twin = h;
        ++edge_count_;
      } else {
        edge_count_ += static_cast<Index>(end - i);  // a boundary edge for each face
        is_cut |= end - i > 1;
      }
      i = end;
    }
  }
  return is_cut;
}

void Mesh::add_mirror_images() {
  const Index given = half_edge_count();
  if (given > kNone / 2) throw std::invalid_argument("mesh too large: indices have 32 bits");
  half_edges_.resize(2 * static_cast<std::size_t>(given));
  for (Index h = 0; h < given; h += 3) {
    for (const auto& [to, from] : {std::pair<Index, Index>{0, 0}, {1, 2}, {2, 1}}) {
      half_edges_[given + h + to].origin = half_edges_[h + from].origin;
    }
  }
  next_sheet_.assign(half_edges_.size(), kNone);
}

// next_sheet_ links the images of the faces of an edge that have it in one direction, in some
// order; those that have it in the other direction, in the reverse order. Twins lead out of face i
// into face i + 1, and back.
void Mesh::link_sheets() {
  std::vector<std::pair<Index, Index>> sides;  // of vertex a: neighbour b > a, half-edge a -> b
  edge_count_ = 0;
  for (HalfEdge& e : half_edges_) e.twin = kNone;
  for (Index a = 0; a < vertex_count(); ++a) {
    sides.clear();
    for (const Index h : outgoing(a)) {
      if (head(h) > a) sides.emplace_back(head(h), h);
    }
    std::ranges::sort(sides);
    for (std::size_t first = 0; first < sides.size();) {
      std::size_t end = first + 1;
      while (end < sides.size() && sides[end].first == sides[first].first) ++end;
      for (std::size_t i = first; i < end; ++i) {
        const Index h = sides[i].second, next = sides[i + 1 < end ? i + 1 : first].second;
        next_sheet_[h] = next;
        next_sheet_[mirrored(next)] = mirrored(h);
        if (next == h) continue;  // a boundary
        half_edges_[h].twin = mirrored(next);
        half_edges_[mirrored(next)].twin = h;
      }
      ++edge_count_;
      first = end;
    }
  }
}

// True for exactly one half-edge of every edge.
bool Mesh::is_least_of_edge(Index h) const {
  if (!crosses_non_manifold_edges()) return twin(h) == kNone || twin(h) > h;
  Index g = h;
  do {
    if (g < h || mirrored(g) < h) return false;
    g = next_sheet(g);
  } while (g != h);
  return true;
}

void Mesh::compute_frames() {
  double sum = 0;
  for (Index first = 0; first < half_edge_count(); first += 3) {
    compute_frames_of_face(first);
    for (Index h = first; h < first + 3; ++h) {
      if (is_least_of_edge(h)) sum += half_edges_[h].length;
    }
  }
  mean_edge_length_ = edge_count_ > 0 ? sum / edge_count_ : 0;
}

// Sets the frames of the face whose half-edges start with `first`. Both sides of an edge get the
// same bits: a difference and its negative differ only in signs.
void Mesh::compute_frames_of_face(Index first) {
  const std::span<HalfEdge, 3> sides(&half_edges_[first], 3);
  std::array<Vec3, 3> along;
  std::size_t longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    along[k] = subtract(position(sides[(k + 1) % 3].origin), position(sides[k].origin));
    sides[k].length = norm(along[k]);
    if (sides[k].length > sides[longest].length) longest = k;
  }
  // The product of any two sides is the same, but its rounding is relative to the product of their
  // lengths. With the two shorter sides every height keeps its digits, relative to each side it
  // belongs to: unfolding across a short side between two long ones divides a height by it, and
  // must neither stretch nor shrink a path.
  const double twice_area = norm(cross(along[(longest + 1) % 3], along[(longest + 2) % 3]));
  for (std::size_t k = 0; k < 3; ++k) {
    HalfEdge& e = sides[k];
    const std::size_t previous = (k + 2) % 3;
    if (e.length > 0) {
      e.apex_x =
          dot(subtract(position(sides[previous].origin), position(e.origin)), along[k]) / e.length;
      e.apex_y = twice_area / e.length;
      if (sides[(k + 1) % 3].length == 0) e.apex_x = e.length;
    } else {  // a zero-length edge has no direction: upright keeps the other two lengths
      e.apex_x = 0;
      e.apex_y = sides[previous].length;
    }
  }
}

std::span<const Index> Mesh::given_corners(Index v) const {
  const std::span<const Index> all = outgoing(v);
  return crosses_non_manifold_edges() ? all.first(all.size() / 2) : all;
}

double Mesh::total_angle(Index v) const {
  double sum = 0;
  for (const Index h : given_corners(v)) {
    sum += std::atan2(half_edge(h).apex_y, half_edge(h).apex_x);
  }
  return sum;
}

bool Mesh::is_boundary(Index v) const {
  for (const Index h : outgoing(v)) {
    if (twin(h) == kNone || twin(previous(h)) == kNone) return true;
  }
  return false;
}

// The fan around v that contains its first half-edge.
Mesh::Fan Mesh::fan_at(Index v) const {
  const Index start = outgoing(v).front();
  Fan fan{.faces = 1, .closed = true};
  Index h = twin(previous(start));
  for (; h != start && h != kNone; h = twin(previous(h))) ++fan.faces;
  if (h == start) return fan;
  fan.closed = false;  // turn the other way too
  for (h = start; twin(h) != kNone; h = next(twin(h))) ++fan.faces;
  return fan;
}

// True when the total angle exceeds that of a plane by kSaddleAngleExcess. Turning a vector by each
// angle shows where the sum lies between multiples of 2 pi; near a multiple, the angles are
// computed.
bool Mesh::has_angle_excess(Index v) const {
  double x = 1, y = 0;
  bool past_full_turn = false;
  for (const Index h : given_corners(v)) {
    const HalfEdge& e = half_edge(h);
    const double scale = 1 / half_edge(previous(h)).length;
    const double cosine = e.apex_x * scale, sine = e.apex_y * scale;
    const double turned_y = x * sine + y * cosine;
    past_full_turn |= y < 0 && turned_y >= 0;
    x = x * cosine - y * sine;
    y = turned_y;
  }
  const bool clear = std::abs(y) > kNearTurn || x < 0;  // false for a NaN (degenerate faces)
  return clear ? past_full_turn : total_angle(v) > 2 * std::numbers::pi + kSaddleAngleExcess;
}

void Mesh::classify_vertices() {
  pseudo_source_.assign(positions_.size(), 0);
  for (Index v = 0; v < vertex_count(); ++v) {
    const std::span<const Index> around = given_corners(v);
    if (around.empty()) continue;
    const Fan fan = fan_at(v);
    const bool several_fans = fan.faces < around.size();
    has_non_manifold_vertices_ |= several_fans;
    // A path that bends at a boundary has more than half a plane on one side.
    const bool bends =
        fan.closed ? has_angle_excess(v) : total_angle(v) > std::numbers::pi + kSaddleAngleExcess;
    if (several_fans || bends) pseudo_source_[v] = 1;
  }
  if (crosses_non_manifold_edges()) {
    // Around such a vertex every two sheets form a separate surface with its own angles.
    for (Index h = 0; h < half_edge_count(); ++h) {
      if (!is_branching(h)) continue;
      pseudo_source_[origin(h)] = pseudo_source_[head(h)] = 1;
      has_non_manifold_vertices_ = true;
    }
  }
  for (Index h = 0; h < half_edge_count(); ++h) {
    const HalfEdge& e = half_edge(h);
    has_thin_faces_ |= e.apex_y < kThinFace * e.length;
    if (e.apex_y > kFlatFace * e.length) continue;
    pseudo_source_[origin(h)] = pseudo_source_[head(h)] = pseudo_source_[apex(h)] = 1;
    has_degenerate_faces_ |= !(e.apex_y > 0 && e.length > 0);
  }
}

}  // namespace geodesic
