#include "meshes/summary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/connectivity.h"
#include "meshes/defects.h"
#include "solvers/core/tolerance.h"

namespace geodesic {
namespace {

// The usable faces, oriented alike, with the twin of each half-edge and the fan of each corner.
class Surface {
 public:
  explicit Surface(const TriangleSoup& soup) : soup_(soup), usable_(take_census(soup).usable) {
    const Orientation orientation =
        orient(soup.triangles, EdgeTable(soup.triangles, usable_, soup.positions.size()));
    orientable_ = orientation.one_sided_edges == 0;
    for (Index f = 0; f < soup.triangles.size(); ++f) {
      if (!usable_[f]) continue;
      const Triangle& t = soup.triangles[f];
      triangles_.push_back(orientation.flipped[f] ? flip(t) : t);
    }
    const std::vector<bool> all(triangles_.size(), true);
    twins_ = pair_half_edges(triangles_, EdgeTable(triangles_, all, soup.positions.size()));
    fans_ = join_fans(twins_);
  }

  void count(MeshSummary& summary);
  void measure_edges(MeshSummary& summary) const;
  void measure_angles(MeshSummary& summary);

 private:
  Index half_edges() const { return static_cast<Index>(twins_.size()); }
  bool is_boundary(Index h) const { return twins_[h] == kNone; }
  // An edge with two sides is represented by the half-edge of lower number.
  bool stands_for_edge(Index h) const { return is_boundary(h) || h < twins_[h]; }
  const Vec3& corner(Index h) const { return soup_.positions[origin_of(triangles_, h)]; }
  Vec3 along(Index h) const { return subtract(corner(next_in_face(h)), corner(h)); }
  std::size_t count_boundary_loops() const;
  std::size_t count_pieces() const;

  const TriangleSoup& soup_;
  const std::vector<bool> usable_;
  bool orientable_ = true;
  std::vector<Triangle> triangles_;
  std::vector<Index> twins_;
  DisjointSets fans_{0};  // sets of corners
};

std::size_t count_sets(DisjointSets& sets, Index elements) {
  std::size_t count = 0;
  for (Index e = 0; e < elements; ++e) count += sets.find(e) == e ? 1u : 0u;
  return count;
}

// The boundary runs against the half-edge. It continues at the half-edge's origin, at the other end
// of the fan there, which a rotation around the origin finds.
std::size_t Surface::count_boundary_loops() const {
  std::vector<bool> seen(twins_.size(), false);
  std::size_t loops = 0;
  for (Index start = 0; start < half_edges(); ++start) {
    if (!is_boundary(start) || seen[start]) continue;
    ++loops;
    for (Index h = start; !seen[h];) {
      seen[h] = true;
      h = previous_in_face(h);
      while (!is_boundary(h)) h = previous_in_face(twins_[h]);
    }
  }
  return loops;
}

// Counts the parts that are connected across edges.
std::size_t Surface::count_pieces() const {
  DisjointSets pieces = fans_;
  for (Index h = 0; h < half_edges(); h += 3) {
    pieces.join(h, h + 1);
    pieces.join(h, h + 2);
  }
  return count_sets(pieces, half_edges());
}

void Surface::count(MeshSummary& summary) {
  for (Index h = 0; h < half_edges(); ++h) {
    summary.edges += stands_for_edge(h) ? 1u : 0u;
    summary.boundary_edges += is_boundary(h) ? 1u : 0u;
  }
  const std::vector<bool> used = used_vertices(triangles_, soup_.positions.size());
  const std::vector<bool> avoided = avoided_vertices(soup_);
  for (Index v = 0; v < used.size(); ++v) {
    summary.isolated_vertices += used[v] || avoided[v] || soup_.is_joined(v) ? 0U : 1U;
  }
  summary.left_out_faces = soup_.triangles.size() - triangles_.size();
  summary.components = first_faces(soup_.triangles, usable_, soup_.positions.size()).size();
  summary.boundary_loops = count_boundary_loops();
  summary.orientable = orientable_;
  if (!orientable_) return;
  // Euler: vertices - edges + faces = sum over pieces of (2 - 2 genus - loops), one vertex per fan.
  summary.genus = (2 * count_pieces() + summary.edges - summary.boundary_loops -
                   count_sets(fans_, half_edges()) - triangles_.size()) /
                  2;
}

void Surface::measure_edges(MeshSummary& summary) const {
  if (triangles_.empty()) return;
  EdgeLengths lengths{.least = kInfinity};
  double sum = 0;
  for (Index h = 0; h < half_edges(); ++h) {
    if (!stands_for_edge(h)) continue;
    const double length = norm(along(h));
    sum += length;
    lengths.least = std::min(lengths.least, length);
    lengths.greatest = std::max(lengths.greatest, length);
  }
  lengths.mean = sum / static_cast<double>(summary.edges);
  summary.edge_lengths = lengths;
}

void Surface::measure_angles(MeshSummary& summary) {
  std::vector<double> totals(twins_.size(), 0.0);  // by the fan's least corner
  std::vector<bool> on_boundary(twins_.size(), false);
  double smallest = kInfinity;
  for (Index h = 0; h < half_edges(); ++h) {
    const Index before = previous_in_face(h);
    const Vec3 back = scale(-1, along(before));
    // The tangent is used, since the cosine loses half the digits of small angles.
    const double angle =
        std::atan2(norm(geodesic::cross(along(h), back)), geodesic::dot(along(h), back));
    const Index fan = fans_.find(h);
    totals[fan] += angle;
    if (is_boundary(h) || is_boundary(before)) on_boundary[fan] = true;
    if (!has_zero_area(soup_.positions, triangles_[h / 3])) smallest = std::min(smallest, angle);
  }
  if (smallest < kInfinity) summary.smallest_angle = smallest * 180 / std::numbers::pi;
  for (Index fan = 0; fan < half_edges(); ++fan) {
    const bool saddle = totals[fan] > 2 * std::numbers::pi + kSaddleAngleExcess;
    summary.saddle_vertices += saddle && !on_boundary[fan] ? 1u : 0u;
  }
}

}  // namespace

MeshSummary summarize(const TriangleSoup& soup) {
  Surface surface(soup);
  MeshSummary summary;
  summary.vertices = soup.positions.size();
  summary.faces = soup.triangles.size();
  surface.count(summary);
  surface.measure_edges(summary);
  surface.measure_angles(summary);
  return summary;
}

}  // namespace geodesic
