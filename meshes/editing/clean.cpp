// Cleans a raw scan for solvers: oriented, manifold, every face with an area.
//
// Each step works in place, keeps the order of the remaining elements, and returns its changes:
// none, or counts of 0, for a mesh that needs none.
#include <algorithm>
#include <array>
#include <queue>
#include <span>
#include <tuple>

#include "meshes/connectivity.h"
#include "meshes/defects.h"
#include "meshes/editing/edit.h"
#include "meshes/mesh_file.h"

namespace geodesic {
namespace {

/// Returns one flag per face: whether it names three different vertices that exist.
std::vector<bool> find_usable(const TriangleSoup& soup) {
  std::vector<bool> usable;
  for (const Triangle& face : soup.triangles) {
    usable.push_back(std::ranges::max(face) < soup.positions.size() && !names_a_vertex_twice(face));
  }
  return usable;
}

/// Returns one flag per face: whether it is one of an opposite pair.
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

/// Clears the flags of each group of connected faces that are all flagged.
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

/// Removes pairs of faces with the same three vertices and opposite directions, which are the flaps
/// that collapsed edges leave: the edges around a pair then have their own two faces again. If
/// nothing would be left of a connected group of faces, a surface stored twice, its pairs stay.
/// Faces that name a vertex twice or one that does not exist stay, too.
std::vector<RepairAction> cancel_opposite_faces(TriangleSoup& soup) {
  const std::vector<bool> usable = find_usable(soup);
  std::vector<bool> paired = find_pairs(soup, usable);
  spare_whole_groups(soup, usable, paired);
  return {{"cancelled_faces", "faces removed that lay back to back on the same three vertices",
           drop_faces(soup, paired)}};
}

/// Length of side k.
double side_length(const TriangleSoup& soup, const Triangle& face, std::size_t k) {
  return norm(subtract(soup.positions[face[(k + 1) % 3]], soup.positions[face[k]]));
}

/// Joins the ends of the face's sides whose length is 0 or below rounding.
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

/// Joins vertices that an edge of length zero connects, to the one of least id, and the ends of an
/// edge that is shorter than the rounding of its face's longest edge. Then drops the faces with
/// only two corners.
std::vector<RepairAction> weld_edges(TriangleSoup& soup) {
  DisjointSets joined(soup.positions.size());
  std::size_t count = 0;
  for (const Triangle& face : soup.triangles) count += join_short_sides(soup, face, joined);
  if (count == 0) return {};
  for (Triangle& face : soup.triangles) {
    for (Index& v : face) v = joined.find(v);
  }
  std::erase_if(soup.triangles, names_a_vertex_twice);
  return {{"welded_vertices", "vertices joined to another along an edge without length", count}};
}

std::vector<RepairAction> separate(TriangleSoup& soup) {
  return {separated(separate_sheets(soup).size())};
}

/// Whether a solver, or the report of defects, sees no area or an edge of length zero.
bool is_flat_face(std::span<const Vec3> positions, const Triangle& face) {
  if (has_zero_area(positions, face)) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = positions[face[k]];
    const Vec3 along = subtract(positions[face[(k + 1) % 3]], corner);
    const Vec3 across = subtract(positions[face[(k + 2) % 3]], corner);
    // Solvers divide the first by the second and need a height above 0.
    const double height = norm(cross(along, across)) / norm(along);
    if (!(height > 0)) return true;
  }
  return false;
}

/// Flips the longest edge of all flat faces first. The face beyond it, if it is flat too, then has
/// no longer edge. Therefore the new edge is shorter, and flipping among flat faces ends.
class FlatFaceRemover {
 public:
  explicit FlatFaceRemover(const TriangleSoup& soup) : mesh_(edited(soup)) {
    for (const Face face : mesh_.faces()) enqueue_if_flat(face);
    // A bound: a flip that makes a face with area flat, by rounding, could be undone by the next.
    flips_left_ = 64 + 16 * queue_.size();
  }

  std::vector<RepairAction> remove_all() {
    while (!queue_.empty()) {
      const Side side = mesh_.halfedge_handle(static_cast<unsigned>(queue_.top().side));
      queue_.pop();
      const Face face = mesh_.face_handle(side);
      const bool is_up_to_date = face.is_valid() && is_flat(face) && longest_side(face) == side;
      if (is_up_to_date) remove(side);
    }
    return {{"flipped_edges", "edges flipped to the vertex that a face without area had on them",
             flips_},
            {"cut_edges", "edges cut where a face without area had a vertex on them", cuts_},
            {"dropped_flat_faces", "faces without area dropped", drops_}};
  }

  TriangleSoup soup() const { return soup_of(mesh_); }

 private:
  using Face = EditedMesh::FaceHandle;
  using Side = EditedMesh::HalfedgeHandle;

  struct FlatFace {
    double length;
    int side;  // the longest side of the face

    bool operator<(const FlatFace& other) const {  // later in the queue
      return std::tie(length, other.side) < std::tie(other.length, side);
    }
  };

  bool is_flat(Face face) const {
    std::array<Vec3, 3> corners;
    std::ranges::transform(mesh_.fv_range(face), corners.begin(),
                           [&](EditedMesh::VertexHandle v) { return to_vec3(mesh_.point(v)); });
    return is_flat_face(corners, {0, 1, 2});
  }

  Side longest_side(Face face) const {
    const auto sides = mesh_.fh_range(face);
    return *std::ranges::max_element(sides.begin(), sides.end(), {},
                                     [&](Side side) { return mesh_.calc_edge_length(side); });
  }

  void enqueue_if_flat(Face face) {
    if (!is_flat(face)) return;
    const Side side = longest_side(face);
    queue_.push({mesh_.calc_edge_length(side), side.idx()});
  }

  void remove(Side side) {
    const Face face = mesh_.face_handle(side);
    const Side beyond = mesh_.opposite_halfedge_handle(side);
    const auto edge = mesh_.edge_handle(side);
    if (mesh_.is_boundary(edge) || flips_left_ == 0) {
      mesh_.delete_face(face, false);
      ++drops_;
    } else if (mesh_.is_flip_ok(edge)) {
      const Face other = mesh_.face_handle(beyond);
      mesh_.flip(edge);
      ++flips_;
      --flips_left_;
      enqueue_if_flat(face);
      enqueue_if_flat(other);
    } else if (mesh_.opposite_vh(side) != mesh_.opposite_vh(beyond)) {
      // The edge that a flip would create exists. The next round joins the vertex to the new one.
      // The place is a copy: adding the vertex moves the others in memory.
      const auto place = mesh_.point(mesh_.opposite_vh(side));
      mesh_.split(edge, place);
      ++cuts_;
    }  // else the faces are an opposite pair, which the next round cancels
  }

  EditedMesh mesh_;
  std::priority_queue<FlatFace> queue_;
  std::size_t flips_left_ = 0;
  std::size_t flips_ = 0, cuts_ = 0, drops_ = 0;
};

/// Removes faces without area whose third vertex lies on the longest edge. The edge is flipped,
/// which splits the face beyond it at that vertex and does not change the surface. If no face lies
/// beyond, the face is dropped.
std::vector<RepairAction> remove_flat_faces(TriangleSoup& soup) {
  if (std::ranges::none_of(soup.triangles, [&](const Triangle& face) {
        return is_flat_face(soup.positions, face);
      })) {
    return {};
  }
  FlatFaceRemover remover(soup);
  std::vector<RepairAction> done = remover.remove_all();
  soup = remover.soup();
  return done;
}

/// Keeps the largest group of connected faces; of equal ones, the first.
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

// Welding and flips can make separate faces meet; the next round separates them.
constexpr CleaningStep kCleaningSteps[] = {cancel_opposite_faces,
                                           [](TriangleSoup& soup) { return repair(soup); },
                                           weld_edges, separate, remove_flat_faces};

/// Far more than any scan needs; each round but the last removes something.
constexpr int kMostRounds = 100;

/// The changes of all rounds together, in the order in which they first occurred.
class Log {
 public:
  /// @return whether anything changed
  bool add(const std::vector<RepairAction>& actions) {
    bool changed = false;
    for (const RepairAction& action : actions) {
      if (!action.changed || action.count == 0) continue;
      changed = true;
      const auto known = std::ranges::find(actions_, action.key, &RepairAction::key);
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
    for (const RepairAction& action : actions_) lines.push_back(action.summary());
    return lines;
  }

 private:
  std::vector<RepairAction> actions_;
};

/// Repeats the steps until a round changes nothing.
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
  TriangleSoup soup = read_mesh_file(file).soup;
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
