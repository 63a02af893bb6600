// A measurable mesh from a raw scan: oriented, manifold, every face with an area.
//
// Each step works in place, keeps the order of what it keeps, and returns what it did: nothing, or
// counts of 0, for a mesh that it finds in order.
#include <algorithm>
#include <array>
#include <queue>
#include <span>
#include <tuple>

#include "meshes/connectivity.h"
#include "meshes/defects.h"
#include "meshes/generators/families.h"
#include "meshes/mesh_file.h"
#include "meshes/repair.h"

namespace geodesic {
namespace {

/// One flag a face: it names three different vertices that exist.
std::vector<bool> find_usable(const TriangleSoup& soup) {
  std::vector<bool> usable;
  for (const auto& [a, b, c] : soup.triangles) {
    usable.push_back(std::max({a, b, c}) < soup.positions.size() && a != b && b != c && c != a);
  }
  return usable;
}

/// One flag a face: it is one of an opposite pair.
std::vector<bool> find_pairs(const TriangleSoup& soup, const std::vector<bool>& usable) {
  std::vector<bool> paired(soup.triangles.size(), false);
  const std::vector<SortedFace> faces = sort_faces(soup.triangles, usable);
  std::array<std::vector<Index>, 2> runs;  // faces of the same vertices, by direction
  for (std::size_t i = 0; i < faces.size();) {
    const std::size_t first = i;
    for (std::vector<Index>& run : runs) run.clear();
    for (; i < faces.size() && faces[i].vertices == faces[first].vertices; ++i) {
      runs[faces[i].even ? 1 : 0].push_back(faces[i].face);
    }
    for (std::size_t k = 0; k < std::min(runs[0].size(), runs[1].size()); ++k) {
      paired[runs[0][k]] = paired[runs[1][k]] = true;
    }
  }
  return paired;
}

/// Clears the flags of connected faces that are all flagged.
void spare_whole_groups(const TriangleSoup& soup, const std::vector<bool>& usable,
                        std::vector<bool>& paired) {
  DisjointSets groups = join_vertices(soup.triangles, usable, soup.positions.size());
  std::vector<bool> keeps_a_face(soup.positions.size(), false);
  for (std::size_t f = 0; f < usable.size(); ++f) {
    if (usable[f] && !paired[f]) keeps_a_face[groups.find(soup.triangles[f][0])] = true;
  }
  for (std::size_t f = 0; f < usable.size(); ++f) {
    if (usable[f] && !keeps_a_face[groups.find(soup.triangles[f][0])]) paired[f] = false;
  }
}

/// Removes pairs of faces that have the same three vertices and run opposite ways, the flaps that
/// collapsed edges leave: the edges around a pair get back the two faces they had without it. Where
/// nothing would be left of a connected group of faces, a surface stored twice, the pairs stay.
/// Faces that name a vertex twice or one that does not exist are left alone.
std::vector<RepairAction> cancel_opposite_faces(TriangleSoup& soup) {
  const std::vector<bool> usable = find_usable(soup);
  std::vector<bool> paired = find_pairs(soup, usable);
  spare_whole_groups(soup, usable, paired);
  return {{"cancelled_faces", "faces removed that lay back to back on the same three vertices",
           drop_faces(soup, paired)}};
}

/// Of side k.
double side_length(const TriangleSoup& soup, const Triangle& face, std::size_t k) {
  return norm(subtract(soup.positions[face[(k + 1) % 3]], soup.positions[face[k]]));
}

/// Joins the ends of the face's sides that have no length to speak of.
/// @return the number of vertices that disappear
std::size_t join_short_sides(const TriangleSoup& soup, const Triangle& face, DisjointSets& joined) {
  std::array<double, 3> lengths;
  for (std::size_t k = 0; k < 3; ++k) lengths[k] = side_length(soup, face, k);
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (lengths[k] > kFlatHeight * longest) continue;
    count += joined.join(face[k], face[(k + 1) % 3]) ? 1U : 0U;
  }
  return count;
}

/// Joins vertices that an edge of length zero connects to the one of least id, and the ends of an
/// edge that is shorter than the rounding of its face's longest, then drops the faces that are left
/// with two corners.
std::vector<RepairAction> weld_edges(TriangleSoup& soup) {
  DisjointSets joined(soup.positions.size());
  std::size_t count = 0;
  for (const Triangle& face : soup.triangles) count += join_short_sides(soup, face, joined);
  if (count == 0) return {};
  for (Triangle& face : soup.triangles) {
    for (Index& v : face) v = joined.find(v);
  }
  std::erase_if(soup.triangles, [](const Triangle& face) {
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
  });
  return {{"welded_vertices", "vertices joined to another along an edge without length", count}};
}

/// Gives each fan of faces at a vertex a vertex of its own, so that every edge has one face, or two
/// that run along it in opposite directions. The first fan keeps the vertex, copies follow all
/// others. Faces at an edge of three or more stay connected when they are in the same fans at both
/// of its ends: two tubes that touch along an edge come apart, a fin comes off.
///
/// One pass is enough. The faces of a fan run the same way round, in a row whose two ends alone
/// lack a neighbour. All faces at an edge (a, b) of the result are in the one fan of a: they are
/// two at most, the ends of the row, and run along the edge in opposite directions.
std::vector<RepairAction> separate_sheets(TriangleSoup& soup) {
  DisjointSets fans = join_fans(pair_half_edges(soup.triangles, EdgeTable(soup)));
  const std::size_t before = soup.positions.size();
  std::vector<bool> has_fan(before, false);
  for (Index h = 0; h < 3 * soup.triangles.size(); ++h) {
    const Index first = fans.find(h);  // the least corner of the fan: settled before h
    Index& v = soup.triangles[h / 3][h % 3];
    if (first != h) {
      v = origin_of(soup.triangles, first);
    } else if (has_fan[v]) {
      const Vec3 position = soup.positions[v];
      v = static_cast<Index>(soup.positions.size());
      soup.positions.push_back(position);
    } else {
      has_fan[v] = true;
    }
  }
  return {{"copied_vertices", "copies made of vertices at which separate sheets of the surface met",
           soup.positions.size() - before}};
}

/// True when a solver, or the report of defects, sees no area or an edge of length zero.
bool is_flat_face(std::span<const Vec3> positions, const Triangle& face) {
  if (has_zero_area(positions, face)) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = positions[face[k]];
    const Vec3 along = subtract(positions[face[(k + 1) % 3]], corner);
    const Vec3 across = subtract(positions[face[(k + 2) % 3]], corner);
    // Solvers divide the one by the other and need a height above 0.
    const double height = norm(cross(along, across)) / norm(along);
    if (!(height > 0)) return true;
  }
  return false;
}

/// Flips first the longest edge of all flat faces: the face beyond it, when flat too, then has no
/// longer one, so that the new edge is shorter and flipping among flat faces ends.
class FlatFaceRemover {
 public:
  explicit FlatFaceRemover(TriangleSoup& soup) : soup_(soup) {
    for (Index f = 0; f < soup.triangles.size(); ++f) enqueue_if_flat(f);
    if (queue_.empty()) return;
    twins_ = pair_half_edges(soup.triangles, EdgeTable(soup));
    removed_.assign(soup.triangles.size(), false);
    // A flip that turns a face with area into a flat one, by rounding, could be undone by the next.
    flips_left_ = 64 + 16 * queue_.size();
  }

  std::vector<RepairAction> remove() {
    while (!queue_.empty()) {
      const FlatFace next = queue_.top();
      queue_.pop();
      const bool is_up_to_date = !removed_[next.side / 3] && is_flat(next.side / 3) &&
                                 longest_side(next.side / 3) == next.side;
      if (is_up_to_date) remove(next.side);
    }
    if (drops_ > 0) drop_faces(soup_, removed_);
    return {{"flipped_edges", "edges flipped to the vertex that a face without area had on them",
             flips_},
            {"dropped_flat_faces", "faces without area dropped", drops_}};
  }

 private:
  struct FlatFace {
    double length;
    Index side;  // the face's longest

    bool operator<(const FlatFace& other) const {  // later in the queue
      return std::tie(length, other.side) < std::tie(other.length, side);
    }
  };

  Index origin(Index h) const { return origin_of(soup_.triangles, h); }
  Index apex(Index h) const { return origin(previous_in_face(h)); }
  bool is_flat(Index f) const { return is_flat_face(soup_.positions, soup_.triangles[f]); }

  double length(Index h) const {
    return norm(subtract(soup_.positions[origin(next_in_face(h))], soup_.positions[origin(h)]));
  }

  Index longest_side(Index f) const {
    Index longest = 3 * f;
    for (const Index h : {3 * f + 1, 3 * f + 2}) {
      if (length(h) > length(longest)) longest = h;
    }
    return longest;
  }

  void enqueue_if_flat(Index f) {
    if (is_flat(f)) queue_.push({length(longest_side(f)), longest_side(f)});
  }

  void remove(Index side) {
    if (twins_[side] == kNone || flips_left_ == 0) {
      drop(side / 3);
    } else if (apex(side) != apex(twins_[side])) {
      flip(side);
    }  // else a flip laid the two back to back, and the next round cancels them
  }

  void link(Index h, Index twin) {
    if (h != kNone) twins_[h] = twin;
    if (twin != kNone) twins_[twin] = h;
  }

  void drop(Index f) {
    for (const Index h : {3 * f, 3 * f + 1, 3 * f + 2}) link(kNone, twins_[h]);
    removed_[f] = true;
    ++drops_;
  }

  /// From the faces (a, b, c) and (b, a, d) of side a -> b to (d, b, c) and (c, a, d).
  void flip(Index side) {
    const Index beyond = twins_[side];
    const Index f = side / 3, g = beyond / 3;
    const Index a = origin(side), b = origin(beyond), c = apex(side), d = apex(beyond);
    const Index bc = twins_[next_in_face(side)], ca = twins_[previous_in_face(side)];
    const Index ad = twins_[next_in_face(beyond)], db = twins_[previous_in_face(beyond)];
    soup_.triangles[f] = {d, b, c};
    soup_.triangles[g] = {c, a, d};
    link(3 * f, db);
    link(3 * f + 1, bc);
    link(3 * g, ca);
    link(3 * g + 1, ad);
    link(3 * f + 2, 3 * g + 2);
    ++flips_;
    --flips_left_;
    enqueue_if_flat(f);
    enqueue_if_flat(g);
  }

  TriangleSoup& soup_;
  std::vector<Index> twins_;
  std::vector<bool> removed_;
  std::priority_queue<FlatFace> queue_;
  std::size_t flips_left_ = 0;
  std::size_t flips_ = 0, drops_ = 0;
};

/// Removes faces without area whose longest edge has the third vertex on it: the edge is flipped,
/// which cuts the face beyond it in two at that vertex and leaves the surface as it is. Where no
/// face lies beyond, the face is dropped.
std::vector<RepairAction> remove_flat_faces(TriangleSoup& soup) {
  return FlatFaceRemover(soup).remove();
}

/// Keeps the group of connected faces that has the most, of equal ones the first.
std::vector<RepairAction> keep_largest_component(TriangleSoup& soup) {
  DisjointSets components = join_vertices(
      soup.triangles, std::vector<bool>(soup.triangles.size(), true), soup.positions.size());
  std::vector<std::size_t> sizes(soup.positions.size(), 0);
  for (const Triangle& face : soup.triangles) ++sizes[components.find(face[0])];
  Index largest = soup.triangles.empty() ? 0 : components.find(soup.triangles[0][0]);
  for (const Triangle& face : soup.triangles) {
    const Index component = components.find(face[0]);
    if (sizes[component] > sizes[largest]) largest = component;
  }
  const auto groups =
      soup.positions.size() - static_cast<std::size_t>(std::ranges::count(sizes, 0));
  std::erase_if(soup.triangles,
                [&](const Triangle& face) { return components.find(face[0]) != largest; });
  return {{"dropped_components", "smaller components dropped", groups > 0 ? groups - 1 : 0}};
}

using CleaningStep = std::vector<RepairAction> (*)(TriangleSoup& soup);

// Welding and flips can make faces meet that did not before, which the next round separates.
constexpr CleaningStep kCleaningSteps[] = {cancel_opposite_faces, repair, weld_edges,
                                           separate_sheets, remove_flat_faces};

/// Far more than any scan takes; each round but the last removes something.
constexpr int kMostRounds = 100;

/// What was done in all rounds together, in the order in which it was first done.
class Log {
 public:
  /// @return whether anything changed
  bool add(const std::vector<RepairAction>& actions) {
    bool changed = false;
    for (const RepairAction& action : actions) {
      if (!action.changed || action.count == 0) continue;
      changed = true;
      const auto known =
          std::find_if(actions_.begin(), actions_.end(),
                       [&](const RepairAction& other) { return other.key == action.key; });
      if (known == actions_.end()) {
        actions_.push_back(action);
      } else {
        known->count += action.count;
      }
    }
    return changed;
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    std::transform(actions_.begin(), actions_.end(), std::back_inserter(lines),
                   [](const RepairAction& action) { return action.summary(); });
    return lines;
  }

 private:
  std::vector<RepairAction> actions_;
};

/// Takes the steps until a round changes nothing.
void take_steps(TriangleSoup& soup, const std::string& file, Log& log) {
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (const CleaningStep step : kCleaningSteps) changed |= log.add(step(soup));
    if (!changed) return;
  }
  throw MeshError(file + ": still not a measurable mesh after " + std::to_string(kMostRounds) +
                  " rounds of cleaning");
}

GeneratedMesh make_clean(const CheckedParameters& parameters) {
  const std::string& file = parameters.text("input");
  TriangleSoup soup = read_mesh(file).soup;
  Log log;
  take_steps(soup, file, log);
  if (parameters.text("parts") == "largest") log.add(keep_largest_component(soup));
  const std::size_t vertices = soup.positions.size();
  drop_isolated_vertices(soup);
  log.add(
      {{"dropped_vertices", "vertices without a face dropped", vertices - soup.positions.size()}});
  if (soup.triangles.empty()) {
    throw MeshError(file + ": no face with an area is left; is it the right file?");
  }
  return {std::move(soup), log.lines()};
}

}  // namespace

Family clean() {
  return {{.name = "clean",
           .description = "a mesh made measurable for every solver: oriented, manifold, without "
                          "repeated faces, zero-length edges, faces without area and isolated "
                          "vertices; what was in order stays as it was",
           .parameters = {input_parameter(),
                          choice_parameter(
                              "parts", {"all", "largest"},
                              "connected components to keep; largest by number of faces")}},
          make_clean};
}

}  // namespace geodesic
