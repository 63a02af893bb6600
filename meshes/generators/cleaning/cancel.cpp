#include <algorithm>
#include <array>

#include "meshes/disjoint_sets.h"
#include "meshes/generators/cleaning/steps.h"

namespace geodesic {
namespace {

/// A face by its vertices in ascending order, and which way it runs through them.
struct SortedFace {
  Triangle vertices;
  bool ascends;  // the order is an even permutation of the face's
  Index face;
};

bool is_usable(const TriangleSoup& soup, const Triangle& face) {
  const auto& [a, b, c] = face;
  return std::max({a, b, c}) < soup.positions.size() && a != b && b != c && c != a;
}

std::vector<SortedFace> sorted_faces(const TriangleSoup& soup) {
  std::vector<SortedFace> faces;
  faces.reserve(soup.triangles.size());
  for (Index f = 0; f < soup.triangles.size(); ++f) {
    Triangle face = soup.triangles[f];
    if (!is_usable(soup, face)) continue;
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    const bool ascends = face[1] < face[2];
    if (!ascends) std::swap(face[1], face[2]);
    faces.push_back({face, ascends, f});
  }
  std::sort(faces.begin(), faces.end(), [](const SortedFace& a, const SortedFace& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.face < b.face;
  });
  return faces;
}

/// One flag a face: it is one of an opposite pair.
std::vector<bool> find_pairs(const TriangleSoup& soup) {
  std::vector<bool> paired(soup.triangles.size(), false);
  const std::vector<SortedFace> faces = sorted_faces(soup);
  std::array<std::vector<Index>, 2> runs;  // faces of the same vertices, by direction
  for (std::size_t i = 0; i < faces.size();) {
    const std::size_t first = i;
    for (std::vector<Index>& run : runs) run.clear();
    for (; i < faces.size() && faces[i].vertices == faces[first].vertices; ++i) {
      runs[faces[i].ascends ? 1 : 0].push_back(faces[i].face);
    }
    for (std::size_t k = 0; k < std::min(runs[0].size(), runs[1].size()); ++k) {
      paired[runs[0][k]] = paired[runs[1][k]] = true;
    }
  }
  return paired;
}

/// Takes back the flags of connected faces that are all flagged.
void spare_whole_groups(const TriangleSoup& soup, std::vector<bool>& paired) {
  DisjointSets groups(soup.positions.size());
  std::vector<bool> keeps_a_face(soup.positions.size(), false);
  const auto for_each_usable = [&](auto&& visit) {
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      if (is_usable(soup, soup.triangles[f])) visit(f, soup.triangles[f]);
    }
  };
  for_each_usable([&](std::size_t, const Triangle& face) {
    groups.join(face[0], face[1]);
    groups.join(face[0], face[2]);
  });
  for_each_usable([&](std::size_t f, const Triangle& face) {
    if (!paired[f]) keeps_a_face[groups.find(face[0])] = true;
  });
  for_each_usable([&](std::size_t f, const Triangle& face) {
    if (!keeps_a_face[groups.find(face[0])]) paired[f] = false;
  });
}

}  // namespace

std::vector<RepairAction> cancel_opposite_faces(TriangleSoup& soup) {
  std::vector<bool> paired = find_pairs(soup);
  spare_whole_groups(soup, paired);
  std::size_t kept = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    if (!paired[f]) soup.triangles[kept++] = soup.triangles[f];
  }
  const std::size_t removed = soup.triangles.size() - kept;
  soup.triangles.resize(kept);
  if (removed == 0) return {};
  return {{"cancelled_faces", "faces removed that lay back to back on the same three vertices",
           removed}};
}

}  // namespace geodesic
