#include "meshes/defects.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "meshes/coincidence.h"
#include "solvers/core/geometry.h"

namespace geodesic {
namespace {

constexpr std::array<DefectType, kDefectKinds> kTypes = {{
    {"index_out_of_range", "face that names a vertex that does not exist",
     "faces that name a vertex that does not exist", Severity::error},
    {"repeated_vertex", "face of fewer than three different vertices",
     "faces of fewer than three different vertices", Severity::error},
    {"non_finite_coordinate", "vertex with a coordinate that is not finite or above 1e150",
     "vertices with a coordinate that is not finite or above 1e150", Severity::error},
    {"repeated_face", "repeated face", "repeated faces", Severity::error},
    {"non_manifold_edge", "non-manifold edge", "non-manifold edges", Severity::error},
    {"inconsistent_orientation", "edge between inconsistently oriented faces",
     "edges between inconsistently oriented faces", Severity::error},
    {"non_manifold_vertex", "non-manifold vertex", "non-manifold vertices", Severity::warning},
    {"zero_area_face", "degenerate face of zero area", "degenerate faces of zero area",
     Severity::warning},
    {"zero_length_edge", "zero-length edge", "zero-length edges", Severity::warning},
    {"isolated_vertex", "isolated vertex", "isolated vertices", Severity::warning},
    {"coincident_vertex", "vertex where an earlier one lies", "vertices where an earlier one lies",
     Severity::warning},
    {"nearly_coincident_vertex", "vertex within 1e-6 mean edge lengths of an earlier one",
     "vertices within 1e-6 mean edge lengths of an earlier one", Severity::warning},
    {"several_components", "component", "components that no path connects", Severity::warning},
}};

bool is_usable_position(const Vec3& p) {
  return std::all_of(p.begin(), p.end(), [](double c) {
    return std::abs(c) <= kLargestCoordinate;  // false for a NaN
  });
}

// The census without repeated faces.
FaceCensus take_census_of_faces(const TriangleSoup& soup) {
  FaceCensus census;
  census.finite_vertices.resize(soup.positions.size());
  for (Index v = 0; v < soup.positions.size(); ++v) {
    census.finite_vertices[v] = is_usable_position(soup.positions[v]);
  }
  census.usable.resize(soup.triangles.size());
  for (Index f = 0; f < soup.triangles.size(); ++f) {
    if (!soup.is_face(f)) continue;
    const auto& [a, b, c] = soup.triangles[f];
    if (std::max({a, b, c}) >= soup.positions.size()) {
      census.index_out_of_range.push_back(f);
    } else if (names_a_vertex_twice(soup.triangles[f])) {
      census.repeated_vertex.push_back(f);
    } else if (!census.finite_vertices[a] || !census.finite_vertices[b] ||
               !census.finite_vertices[c]) {
      census.at_non_finite_vertex.push_back(f);
    } else {
      census.usable[f] = true;
    }
  }
  return census;
}

// Returns the triangles that have the same three vertices as an earlier usable one, in ascending
// order. They share all three edges; each is found at the edge between its two lesser vertices.
std::vector<Index> find_repeats(std::span<const Triangle> triangles, const EdgeTable& edges) {
  std::vector<Index> repeats;
  std::vector<std::pair<Index, Index>> at_edge;  // third vertex, face
  edges.for_each_edge([&](std::span<const EdgeSide> sides) {
    at_edge.clear();
    for (const EdgeSide& side : sides) {
      const Index third = origin_of(triangles, previous_in_face(side.half_edge));
      if (third > side.high) at_edge.emplace_back(third, side.half_edge / 3);
    }
    if (at_edge.size() < 2) return;
    std::ranges::sort(at_edge);
    for (std::size_t i = 1; i < at_edge.size(); ++i) {
      if (at_edge[i].first == at_edge[i - 1].first) repeats.push_back(at_edge[i].second);
    }
  });
  std::ranges::sort(repeats);
  return repeats;
}

// Adds the repeated faces to a census.
// @return the edges of the faces that are usable then
EdgeTable complete(FaceCensus& census, const TriangleSoup& soup) {
  const auto edges_of_usable = [&] {
    return EdgeTable(soup.triangles, census.usable, soup.positions.size());
  };
  EdgeTable edges = edges_of_usable();
  census.repeated_face = find_repeats(soup.triangles, edges);
  if (census.repeated_face.empty()) return edges;
  for (const Index f : census.repeated_face) census.usable[f] = false;
  return edges_of_usable();
}

class Finder {
 public:
  Finder(const TriangleSoup& soup, const FileLines& lines)
      : soup_(soup),
        positions_(soup.positions),
        triangles_(soup.triangles),
        lines_(lines),
        census_(take_census_of_faces(soup)),
        edges_(complete(census_, soup)) {}

  DefectReport find() {
    report_unusable_faces();
    report_edges();
    report_fans();
    report_coincidences();
    report_flat_faces();
    report_components();
    std::ranges::sort(report_.defects, {}, &Defect::kind);
    return std::move(report_);
  }

 private:
  void report(DefectKind kind, std::size_t count, std::string example) {
    if (count > 0) report_.defects.push_back({kind, count, std::move(example)});
  }

  // Reports those of `count` elements for which `is_found` is true; the first is the example.
  template <class IsFound, class Example>
  void report_all(DefectKind kind, std::size_t count, IsFound is_found, Example example) {
    std::size_t found = 0;
    Index first = kNone;
    for (Index i = 0; i < count; ++i) {
      if (is_found(i) && found++ == 0) first = i;
    }
    if (found > 0) report(kind, found, example(first));
  }

  std::string line(const std::vector<std::uint32_t>& of, Index which) const {
    return which < of.size() ? " (line " + std::to_string(of[which]) + ")" : "";
  }
  std::string vertex(Index v) const {
    return "vertex " + std::to_string(v) + line(lines_.vertices, v);
  }
  std::string face(Index f) const {
    return "face " + std::to_string(f) + line(lines_.triangles, f);
  }
  std::string face_with_vertices(Index f) const {
    const Triangle& t = triangles_[f];
    const auto id = [](Index v) { return v == kNone ? "?" : std::to_string(v); };
    return face(f) + " of vertices " + id(t[0]) + ", " + id(t[1]) + ", " + id(t[2]);
  }
  // "edge 3-5 of face 1 (line 7) and face 2 (line 8)"
  std::string edge(std::span<const EdgeSide> sides) const {
    std::string text =
        "edge " + std::to_string(sides[0].low) + "-" + std::to_string(sides[0].high) + " of ";
    constexpr std::size_t kMostFaces = 6;
    const std::size_t shown = std::min(sides.size(), kMostFaces);
    for (std::size_t i = 0; i < shown; ++i) {
      text += (i == 0 ? "" : ", ") + face(sides[i].half_edge / 3);
    }
    return text + (shown < sides.size() ? ", ..." : "");
  }

  void report_unusable_faces() {
    const auto report_faces = [&](DefectKind kind, const std::vector<Index>& faces,
                                  const std::string& remark) {
      if (!faces.empty()) report(kind, faces.size(), face_with_vertices(faces.front()) + remark);
    };
    report_faces(
        DefectKind::index_out_of_range, census_.index_out_of_range,
        "; the mesh has " + std::to_string(positions_.size()) + " vertices, counted here from 0");
    report_faces(DefectKind::repeated_vertex, census_.repeated_vertex, "");
    report_faces(DefectKind::repeated_face, census_.repeated_face, "");
    report_vertices(DefectKind::non_finite_coordinate,
                    [&](Index v) { return !census_.finite_vertices[v]; });
  }

  void report_edges() {
    std::array<std::size_t, kDefectKinds> counts = {};
    std::array<std::string, kDefectKinds> examples;
    edges_.for_each_edge([&](std::span<const EdgeSide> sides) {
      const auto found = [&](DefectKind kind) {
        const auto k = static_cast<std::size_t>(kind);
        if (counts[k]++ == 0) examples[k] = edge(sides);
      };
      if (sides.size() > 2) found(DefectKind::non_manifold_edge);
      if (sides.size() == 2 &&
          origin_of(triangles_, sides[0].half_edge) == origin_of(triangles_, sides[1].half_edge)) {
        found(DefectKind::inconsistent_orientation);
      }
      const double length = length_of(sides);
      if (length == 0) found(DefectKind::zero_length_edge);
      sum_of_lengths_ += length;
      ++edge_count_;
    });
    for (std::size_t k = 0; k < kDefectKinds; ++k) {
      report(static_cast<DefectKind>(k), counts[k], examples[k]);
    }
  }

  // Corners have the numbers of the half-edges that start at them. Two corners at a vertex belong
  // together if their faces share an edge there.
  void report_fans() {
    DisjointSets groups(3 * triangles_.size());
    std::vector<Index> groups_at(positions_.size(), 0);
    for (Index f = 0; f < triangles_.size(); ++f) {
      if (!census_.usable[f]) continue;
      for (const Index v : triangles_[f]) ++groups_at[v];
    }
    edges_.for_each_edge([&](std::span<const EdgeSide> sides) {
      const auto corner_at = [&](const EdgeSide& side, Index v) {
        const Index h = side.half_edge;
        return origin_of(triangles_, h) == v ? h : next_in_face(h);
      };
      for (std::size_t i = 1; i < sides.size(); ++i) {
        for (const Index v : {sides[0].low, sides[0].high}) {
          if (groups.join(corner_at(sides[0], v), corner_at(sides[i], v))) --groups_at[v];
        }
      }
    });
    report_vertices(DefectKind::non_manifold_vertex, [&](Index v) { return groups_at[v] > 1; });
    const std::vector<bool> avoided = avoided_vertices(soup_);
    report_vertices(DefectKind::isolated_vertex, [&](Index v) {
      return groups_at[v] == 0 && !soup_.is_joined(v) && !avoided[v];
    });
  }

  double length_of(std::span<const EdgeSide> sides) const {
    return norm(subtract(positions_[sides[0].low], positions_[sides[0].high]));
  }

  // Vertices that short edges connect belong to one surface there. Vertices of other sets are
  // counted, one less than sets.
  void report_coincidences() {
    if (edge_count_ == 0) return;
    const double near = kNearlyCoincident * (sum_of_lengths_ / static_cast<double>(edge_count_));
    std::vector<bool> used(positions_.size(), false);
    for (Index f = 0; f < triangles_.size(); ++f) {
      if (!census_.usable[f]) continue;
      for (const Index v : triangles_[f]) used[v] = true;
    }
    const Coincidences found = find_coincidences(positions_, used, near);
    if (found.same.empty() && found.near.empty()) return;
    DisjointSets connected(positions_.size());
    edges_.for_each_edge([&](std::span<const EdgeSide> sides) {
      if (length_of(sides) <= near) connected.join(sides[0].low, sides[0].high);
    });
    const auto report_pairs = [&](DefectKind kind,
                                  const std::vector<std::pair<Index, Index>>& pairs,
                                  const std::string& where) {
      std::size_t count = 0;
      std::string example;
      for (const auto& [a, b] : pairs) {
        if (connected.join(a, b) && count++ == 0) example = vertex(b) + where + vertex(a);
      }
      report(kind, count, std::move(example));
    };
    report_pairs(DefectKind::coincident_vertex, found.same, " at the place of ");
    report_pairs(DefectKind::nearly_coincident_vertex, found.near, " near ");
  }

  template <class IsFound>
  void report_vertices(DefectKind kind, IsFound is_found) {
    report_all(kind, positions_.size(), is_found, [&](Index v) { return vertex(v); });
  }

  void report_flat_faces() {
    report_all(
        DefectKind::zero_area_face, triangles_.size(),
        [&](Index f) { return census_.usable[f] && has_zero_area(positions_, triangles_[f]); },
        [&](Index f) { return face_with_vertices(f); });
  }

  void report_components() {
    const std::vector<Index> first_of_each =
        first_faces(triangles_, census_.usable, positions_.size());
    if (first_of_each.size() < 2) return;
    report(DefectKind::several_components, first_of_each.size(),
           "the second holds " + face(first_of_each[1]));
  }

  const TriangleSoup& soup_;
  std::span<const Vec3> positions_;
  std::span<const Triangle> triangles_;
  const FileLines& lines_;
  FaceCensus census_;
  EdgeTable edges_;
  double sum_of_lengths_ = 0;
  std::size_t edge_count_ = 0;
  DefectReport report_;
};

}  // namespace

DefectReport find_defects(const TriangleSoup& soup, const FileLines& lines) {
  return Finder(soup, lines).find();
}

const DefectType& type_of(DefectKind kind) { return kTypes[static_cast<std::size_t>(kind)]; }

std::string Defect::text() const {
  const DefectType& type = type_of(kind);
  return std::to_string(count) + " " + std::string(count == 1 ? type.singular : type.plural) +
         " (first: " + example + ")";
}

std::size_t DefectReport::count(DefectKind kind) const {
  const auto found = std::ranges::find(defects, kind, &Defect::kind);
  return found == defects.end() ? 0 : found->count;
}

bool DefectReport::has_errors() const {
  return std::any_of(defects.begin(), defects.end(), [](const Defect& defect) {
    return type_of(defect.kind).severity == Severity::error;
  });
}

bool has_zero_area(std::span<const Vec3> positions, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 ab = subtract(positions[b], positions[a]);
  const Vec3 ac = subtract(positions[c], positions[a]);
  const Vec3 bc = subtract(positions[c], positions[b]);
  const double square = std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)});
  const Vec3 normal = cross(ab, ac);
  // Accepts clear cases, if no product leaves the range of a double.
  constexpr double kFar = 100 * kFlatHeight * kFlatHeight;
  if (square > 1e-70 && square < 1e70 && dot(normal, normal) > kFar * square * square) return false;
  const double longest = std::max({norm(ab), norm(ac), norm(bc)});
  // The division comes first: a product of tiny sides would underflow.
  const auto over_longest = [&](const Vec3& v) {
    return Vec3{v[0] / longest, v[1] / longest, v[2] / longest};
  };
  return longest == 0 || norm(cross(over_longest(ab), over_longest(ac))) <= kFlatHeight;
}

FaceCensus take_census(const TriangleSoup& soup) {
  FaceCensus census = take_census_of_faces(soup);
  complete(census, soup);
  return census;
}

}  // namespace geodesic
