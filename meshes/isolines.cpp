#include "meshes/isolines.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "meshes/formats/bytes.h"

namespace geodesic {
namespace {

std::string text_of(double number) {
  std::string text;
  append_text(text, number);
  return text;
}

// The half-edge of the same edge in the other face, of an edge of two faces that paths cross.
Index beyond(const Mesh& mesh, Index h) {
  const Index twin = mesh.twin(h);
  if (twin == kNone || !mesh.crosses_non_manifold_edges()) return twin;
  if (mesh.is_branching(h)) return kNone;
  return twin < mesh.half_edge_count() / 2 ? twin : mesh.mirrored(twin);
}

// One level. A line enters a face through one of its half-edges and leaves through another.
class Level {
 public:
  // @param distances by internal vertex
  Level(const Mesh& mesh, std::span<const double> distances, double level)
      : mesh_(mesh), distances_(distances), level_(level), passed_(mesh.given_face_count()) {}

  void append_lines(std::vector<Isoline>& lines) {
    for (Index given = 0; given < mesh_.external_face_count(); ++given) {
      const Index face = mesh_.numbers().internal_face(given);
      if (face == kNone || passed_[face] || !is_crossed(face)) continue;
      Isoline line = line_from(first_of_line(entry(face)));
      if (line.points.size() > 1) lines.push_back(std::move(line));
    }
  }

 private:
  bool is_farther(Index v) const { return distances_[v] >= level_; }
  bool is_crossed(Index face) const {
    const auto [a, b, c] = mesh_.triangle(face);
    return (is_farther(a) != is_farther(b) || is_farther(b) != is_farther(c)) &&
           std::max({distances_[a], distances_[b], distances_[c]}) < kInfinity;
  }
  bool cuts(Index h) const { return is_farther(mesh_.origin(h)) != is_farther(mesh_.head(h)); }

  // The half-edge of a crossed face that has its nearer end on the left of the line through it.
  Index entry(Index face) const {
    Index h = 3 * face;
    while (is_farther(mesh_.origin(h)) || !is_farther(mesh_.head(h))) ++h;
    return h;
  }
  Index other_in_face(Index h) const {
    const Index next = Mesh::next(h);
    return cuts(next) ? next : Mesh::previous(h);
  }
  // The same edge in the face where the line continues; kNone at its end.
  Index continued(Index h) const {
    const Index there = beyond(mesh_, h);
    return there != kNone && is_crossed(there / 3) ? there : kNone;
  }

  // Where the line that enters through h begins: h itself on a closed line.
  Index first_of_line(Index h) const {
    Index first = h;
    for (Index before = continued(h); before != kNone; before = continued(first)) {
      first = other_in_face(before);
      if (first == h) break;
    }
    return first;
  }

  Isoline line_from(Index first) {
    Isoline line{.level = level_, .points = {point_on(first)}};
    Index h = first;
    do {
      const Index face = h / 3, out = other_in_face(h);
      passed_[face] = true;
      h = continued(out);
      add(line.points, h == first ? line.points.front() : point_on(out), face);
    } while (h != kNone && h != first);
    // Also when it goes from a boundary vertex back to it.
    line.closed = line.points.front().at == line.points.back().at;
    return line;
  }

  PathPoint point_on(Index h) const {
    const Index a = mesh_.origin(h), b = mesh_.head(h);
    const bool upward = is_farther(b);
    const double near = distances_[upward ? a : b], far = distances_[upward ? b : a];
    const double share = (level_ - near) / (far - near);  // of the way to the farther end
    InternalPoint point;
    if (share == 0 || share == 1) {
      point = InternalPoint((share == 1) == upward ? b : a);
    } else {
      point.face = h / 3;
      point.weights[h % 3] = upward ? 1 - share : share;
      point.weights[Mesh::next(h) % 3] = upward ? share : 1 - share;
    }
    return {.at = in_external_numbers(mesh_, point), .position = position_of(mesh_, point)};
  }

  // The line passes several edges of a vertex at the level; that is one point.
  void add(std::vector<PathPoint>& points, const PathPoint& point, Index face) const {
    PathPoint& last = points.back();
    if (point.at.is_vertex() && point.at == last.at) return;
    last.face = mesh_.numbers().external_face(face);
    const double travelled = last.travelled + norm(subtract(point.position, last.position));
    points.push_back({.at = point.at, .position = point.position, .travelled = travelled});
  }

  const Mesh& mesh_;
  std::span<const double> distances_;
  double level_;
  std::vector<bool> passed_;  // by internal face
};

}  // namespace

std::vector<double> equal_levels(std::span<const double> distances, Index count) {
  if (count == 0 || count > kMostLevels) {
    throw std::invalid_argument("the number of levels must be between 1 and " +
                                std::to_string(kMostLevels) + ", not " + std::to_string(count));
  }
  double largest = 0;
  for (const double d : distances) {
    if (d < kInfinity) largest = std::max(largest, d);
  }
  std::vector<double> levels;
  for (Index i = 1; i <= count && largest > 0; ++i) levels.push_back(largest * i / (count + 1));
  return levels;
}

std::vector<Isoline> isolines(const Mesh& mesh, std::span<const double> distances,
                              const std::vector<double>& levels) {
  if (distances.size() != mesh.vertex_count()) {
    throw std::invalid_argument(
        "isolines need one distance a vertex: " + std::to_string(distances.size()) + " for " +
        std::to_string(mesh.vertex_count()) + " vertices");
  }
  std::vector<double> own(distances.size());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!(distances[v] >= 0)) {
      throw std::invalid_argument("the distance of vertex " + std::to_string(v) +
                                  " must be 0 or more, not " + text_of(distances[v]));
    }
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    own[v] = distances[mesh.numbers().external_vertex(v)];
  }
  for (const double level : levels) {
    if (!(level > 0 && level < kInfinity)) {
      throw std::invalid_argument(
          "the level of an isoline must be a finite distance above 0, not " + text_of(level));
    }
  }
  std::vector<Isoline> lines;
  for (const double level : levels) Level(mesh, own, level).append_lines(lines);
  return lines;
}

}  // namespace geodesic
