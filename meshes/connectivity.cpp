#include "meshes/connectivity.h"

#include <algorithm>

namespace geodesic {
namespace {

// Returns, for each half-edge, that of the other face if its edge has exactly two; else kNone.
std::vector<Index> find_neighbours(std::size_t half_edges, const EdgeTable& edges) {
  std::vector<Index> across(half_edges, kNone);
  edges.for_each_edge([&](std::span<const EdgeSide> sides) {
    if (sides.size() != 2) return;
    across[sides[0].half_edge] = sides[1].half_edge;
    across[sides[1].half_edge] = sides[0].half_edge;
  });
  return across;
}

}  // namespace

EdgeTable::EdgeTable(std::span<const Triangle> triangles, const std::vector<bool>& usable,
                     std::size_t vertex_count) {
  const auto for_each_side = [&](auto&& visit) {
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      if (!usable[f]) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(triangles[f][k], triangles[f][(k + 1) % 3]);
        visit(EdgeSide{low, high, static_cast<Index>(3 * f + k)});
      }
    }
  };
  // Counting sort by the lower end, then a sort of the few edges of each end by the higher one.
  std::vector<std::size_t> first(vertex_count + 1, 0);
  for_each_side([&](const EdgeSide& side) { ++first[side.low + 1]; });
  for (std::size_t v = 0; v < vertex_count; ++v) first[v + 1] += first[v];
  sides_.resize(first[vertex_count]);
  std::vector<std::size_t> fill(first.begin(), first.end() - 1);
  for_each_side([&](const EdgeSide& side) { sides_[fill[side.low]++] = side; });
  const auto at = [&](std::size_t i) { return sides_.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::sort(at(first[v]), at(first[v + 1]), [](const EdgeSide& a, const EdgeSide& b) {
      return a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
    });
  }
}

EdgeTable::EdgeTable(const TriangleSoup& soup)
    : EdgeTable(soup.triangles, faces_of(soup), soup.positions.size()) {}

std::vector<SortedFace> sort_faces(std::span<const Triangle> triangles,
                                   const std::vector<bool>& usable) {
  std::vector<SortedFace> faces;
  faces.reserve(triangles.size());
  for (Index f = 0; f < triangles.size(); ++f) {
    if (!usable[f]) continue;
    Triangle t = triangles[f];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const bool even = t[1] < t[2];
    faces.push_back({even ? t : flip(t), even, f});
  }
  std::ranges::sort(faces, {},
                    [](const SortedFace& face) { return std::pair(face.vertices, face.face); });
  return faces;
}

std::vector<Index> pair_half_edges(std::span<const Triangle> triangles, const EdgeTable& edges) {
  std::vector<Index> twins = find_neighbours(3 * triangles.size(), edges);
  for (Index h = 0; h < twins.size(); ++h) {
    const Index g = twins[h];
    if (g != kNone && origin_of(triangles, h) == origin_of(triangles, g)) {
      twins[h] = twins[g] = kNone;
    }
  }
  return twins;
}

DisjointSets join_fans(std::span<const Index> twins) {
  DisjointSets fans(twins.size());
  for (Index h = 0; h < twins.size(); ++h) {
    if (twins[h] != kNone) fans.join(h, next_in_face(twins[h]));
  }
  return fans;
}

DisjointSets join_vertices(std::span<const Triangle> triangles, const std::vector<bool>& usable,
                           std::size_t vertex_count) {
  DisjointSets sets(vertex_count);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    if (!usable[f]) continue;
    sets.join(triangles[f][0], triangles[f][1]);
    sets.join(triangles[f][0], triangles[f][2]);
  }
  return sets;
}

std::vector<Index> first_faces(std::span<const Triangle> triangles, const std::vector<bool>& usable,
                               std::size_t vertex_count) {
  DisjointSets components = join_vertices(triangles, usable, vertex_count);
  std::vector<bool> seen(vertex_count, false);
  std::vector<Index> first;
  for (Index f = 0; f < triangles.size(); ++f) {
    if (!usable[f]) continue;
    const Index root = components.find(triangles[f][0]);
    if (!seen[root]) first.push_back(f);
    seen[root] = true;
  }
  return first;
}

std::vector<bool> used_vertices(std::span<const Triangle> triangles, std::size_t vertex_count) {
  std::vector<bool> used(vertex_count, false);
  for (const Triangle& face : triangles) {
    for (const Index v : face) used[v] = true;
  }
  return used;
}

std::vector<bool> boundary_vertices(const TriangleSoup& soup) {
  std::vector<std::pair<Index, Index>> sides;
  sides.reserve(3 * soup.triangles.size());
  for (const auto& [a, b, c] : soup.triangles) {
    sides.insert(sides.end(), {{a, b}, {b, c}, {c, a}});
  }
  std::ranges::sort(sides);
  std::vector<bool> boundary(soup.positions.size(), false);
  for (const auto& [from, to] : sides) {
    if (!std::ranges::binary_search(sides, std::pair(to, from))) {
      boundary[from] = boundary[to] = true;
    }
  }
  return boundary;
}

TriangleSoup soup_of(const Mesh& mesh) {
  const MeshNumbers& numbers = mesh.numbers();
  TriangleSoup soup{std::vector<Vec3>(mesh.vertex_count()),
                    std::vector<Triangle>(mesh.external_face_count())};
  std::vector<Index> joined_to(mesh.vertex_count());
  bool is_joined = false;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    soup.positions[numbers.external_vertex(v)] = mesh.position(v);
    joined_to[v] = numbers.external_vertex(numbers.internal_vertex(v));
    is_joined |= joined_to[v] != v;
  }
  if (is_joined) soup.joined_to = std::move(joined_to);
  if (mesh.given_face_count() < mesh.external_face_count()) {
    soup.left_out.assign(mesh.external_face_count(), true);
  }
  for (Index f = 0; f < mesh.given_face_count(); ++f) {
    if (!soup.left_out.empty()) soup.left_out[numbers.external_face(f)] = false;
    Triangle& given = soup.triangles[numbers.external_face(f)];
    given = mesh.triangle(f);
    for (Index& corner : given) corner = numbers.external_vertex(corner);
  }
  return soup;
}

TriangleSoup side_by_side(TriangleSoup first, const TriangleSoup& second) {
  const auto offset = static_cast<Index>(first.positions.size());
  first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
  for (const auto& [a, b, c] : second.triangles) {
    first.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return first;
}

std::vector<bool> faces_of(const TriangleSoup& soup) {
  if (soup.left_out.empty()) return std::vector<bool>(soup.triangles.size(), true);
  std::vector<bool> faces = soup.left_out;
  faces.flip();
  return faces;
}

std::vector<bool> avoided_vertices(const TriangleSoup& soup) {
  std::vector<bool> avoided(soup.positions.size(), false);
  for (Index f = 0; f < soup.left_out.size(); ++f) {
    if (soup.is_face(f) || names_a_vertex_twice(soup.triangles[f])) continue;
    for (const Index v : soup.triangles[f]) {
      if (v < avoided.size()) avoided[v] = true;
    }
  }
  return avoided;
}

TriangleSoup without_left_out(TriangleSoup soup) {
  const std::vector<bool> left_out = std::move(soup.left_out);
  soup.left_out.clear();
  if (!left_out.empty()) drop_faces(soup, left_out);
  return soup;
}

std::size_t drop_faces(TriangleSoup& soup, const std::vector<bool>& dropped) {
  std::size_t f = 0;
  std::erase_if(soup.left_out, [&](bool) { return dropped[f++]; });
  f = 0;
  return std::erase_if(soup.triangles, [&](const Triangle&) { return dropped[f++]; });
}

Orientation orient(std::span<const Triangle> triangles, const EdgeTable& edges) {
  const std::vector<Index> across = find_neighbours(3 * triangles.size(), edges);
  const auto agree = [&](Index h, Index g) {
    return origin_of(triangles, h) != origin_of(triangles, g);
  };
  Orientation result;
  result.flipped.assign(triangles.size(), false);
  std::vector<bool> reached(triangles.size(), false);
  std::vector<Index> queue;
  for (Index root = 0; root < triangles.size(); ++root) {
    if (reached[root]) continue;
    reached[root] = true;
    queue.assign(1, root);
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Index f = queue[next];
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        if (across[h] == kNone) continue;
        const Index g = across[h] / 3;
        const bool turned = result.flipped[f] == agree(h, across[h]);
        if (!reached[g]) {
          reached[g] = true;
          result.flipped[g] = turned;
          result.flips += turned ? 1 : 0;
          queue.push_back(g);
        } else if (result.flipped[g] != turned && h < across[h]) {
          ++result.one_sided_edges;
        }
      }
    }
  }
  return result;
}

}  // namespace geodesic
