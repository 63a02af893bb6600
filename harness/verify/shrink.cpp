#include "harness/verify/shrink.h"

#include <algorithm>
#include <numeric>
#include <queue>

#include "harness/base/clock.h"
#include "meshes/connectivity.h"

namespace geodesic::harness {
namespace {

std::vector<bool> vertices_of_sources(const Case& given) {
  std::vector<bool> is_source(given.soup.positions.size());
  for (const Query& query : given.queries) {
    for (const Source& source : query.sources) is_source[source.at.vertex] = true;
  }
  return is_source;
}

// Removes the vertices that have no face and are no source.
Case compact(const Case& given) {
  const std::vector<bool> is_source = vertices_of_sources(given);
  const std::vector<bool> has_face = used_vertices(given.soup.triangles, is_source.size());
  std::vector<Index> number(is_source.size(), kNone);
  Case small{.mesh = given.mesh,
             .soup = {{}, given.soup.triangles},
             .queries = given.queries,
             .tolerance = given.tolerance};
  for (Index v = 0; v < number.size(); ++v) {
    if (!is_source[v] && !has_face[v]) continue;
    number[v] = static_cast<Index>(small.soup.positions.size());
    small.soup.positions.push_back(given.soup.positions[v]);
  }
  for (Triangle& t : small.soup.triangles) {
    for (Index& v : t) v = number[v];
  }
  for (Query& query : small.queries) {
    for (Source& source : query.sources) source.at.vertex = number[source.at.vertex];
  }
  return small;
}

// Numbers of faces, ordered by the number of faces between them and a source. Faces of components
// without a source come last.
std::vector<Index> faces_by_distance(const Case& given) {
  const Mesh mesh(given.soup);
  std::vector<Index> order;
  std::vector<bool> face_taken(mesh.face_count()), vertex_taken(mesh.vertex_count());
  std::queue<Index> front;
  const auto reach = [&](Index v) {
    if (vertex_taken[v]) return;
    vertex_taken[v] = true;
    front.push(v);
  };
  const std::vector<bool> is_source = vertices_of_sources(given);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (is_source[v]) reach(v);
  }
  const auto take = [&](Index face) {
    if (face_taken[face]) return;
    face_taken[face] = true;
    order.push_back(face);
    for (const Index v : mesh.triangle(face)) reach(v);
  };
  while (!front.empty()) {
    const Index v = front.front();
    front.pop();
    for (const Index h : mesh.outgoing(v)) take(h / 3);
  }
  for (Index face = 0; face < mesh.face_count(); ++face) take(face);
  return order;
}

Case with_faces(const Case& given, std::vector<Index> faces) {
  std::ranges::sort(faces);
  Case smaller = given;
  smaller.soup.triangles.clear();
  for (const Index f : faces) smaller.soup.triangles.push_back(given.soup.triangles[f]);
  return smaller;
}

class Shrinking {
 public:
  Shrinking(const Case& given, const std::function<bool(const Case&)>& still_fails, double seconds)
      : smallest_(given), still_fails_(still_fails), seconds_(seconds) {
    smallest_.known = nullptr;  // not those of a smaller mesh
  }

  Case shrink(const Query& suspect) {
    Case alone = smallest_;
    if (!suspect.sources.empty()) alone.queries = {suspect};
    if (!start_near_the_sources(alone) && smallest_.queries.size() > 1) accept_if_it_fails(alone);
    drop(smallest_.queries, [&](const auto& queries) {
      Case smaller = smallest_;
      smaller.queries = queries;
      return smaller;
    });
    for (std::size_t q = 0; q < smallest_.queries.size(); ++q) {
      drop(smallest_.queries[q].sources, [&](const auto& sources) {
        Case smaller = smallest_;
        smaller.queries[q].sources = sources;
        return smaller;
      });
    }
    const Case whole = smallest_;
    // If the failure needs a vertex without faces, all such vertices stay.
    const bool compacting = accept_if_it_fails(compact(whole));
    drop(faces_by_distance(whole), [&](const std::vector<Index>& faces) {
      const Case smaller = with_faces(whole, faces);
      return compacting ? compact(smaller) : smaller;
    });
    return smallest_;
  }

 private:
  bool out_of_time() const { return watch_.real_seconds() > seconds_; }

  // Attempts on a large mesh take long. A failure near the sources is found without them.
  bool start_near_the_sources(const Case& given) {
    constexpr std::size_t kFewFaces = 32;
    const std::vector<Index> order = faces_by_distance(given);
    for (std::size_t few = kFewFaces; few < order.size() && !out_of_time(); few *= 2) {
      const std::vector<Index> near(order.begin(),
                                    order.begin() + static_cast<std::ptrdiff_t>(few));
      if (accept_if_it_fails(compact(with_faces(given, near)))) return true;
    }
    return false;
  }

  bool accept_if_it_fails(const Case& smaller) {
    if (out_of_time() || !still_fails_(smaller)) return false;
    smallest_ = smaller;
    return true;
  }

  // Tries to remove runs of items, the last ones first. One item stays.
  // @param with makes the case that has these items only
  template <class Item, class With>
  void drop(std::vector<Item> items, const With& with) {
    for (std::size_t run = items.size() / 2; run > 0 && !out_of_time();) {
      const std::size_t before = items.size();
      for (std::size_t end = items.size(); end > 0 && !out_of_time();) {
        const std::size_t begin = end > run ? end - run : 0;
        std::vector<Item> fewer(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(begin));
        fewer.insert(fewer.end(), items.begin() + static_cast<std::ptrdiff_t>(end), items.end());
        if (!fewer.empty() && accept_if_it_fails(with(fewer))) items = fewer;
        end = begin;
      }
      const bool again = run == 1 && items.size() < before;
      if (!again) run /= 2;
    }
  }

  Case smallest_;
  const std::function<bool(const Case&)>& still_fails_;
  double seconds_;
  Stopwatch watch_;
};

}  // namespace

Case shrink(const Case& given, const Query& suspect,
            const std::function<bool(const Case&)>& still_fails, double seconds) {
  return Shrinking(given, still_fails, seconds).shrink(suspect);
}

}  // namespace geodesic::harness
