// Cuts the longest edge of a mesh in its middle, again and again.
#include <algorithm>
#include <array>
#include <queue>
#include <span>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "meshes/connectivity.h"
#include "meshes/generators/families.h"

namespace geodesic {
namespace {

class Refiner {
 public:
  explicit Refiner(TriangleSoup& soup) : soup_(soup) { find_edges(); }

  void refine_to(std::size_t vertices) {
    check_face_count(2.0 * static_cast<double>(vertices) +
                     static_cast<double>(soup_.triangles.size()));
    soup_.positions.reserve(vertices);
    while (soup_.positions.size() < vertices) split(longest_.top());
  }

 private:
  /// An undirected edge while it is in the queue.
  struct Edge {
    double squared_length;
    Index low;  // the end of smaller id
    Index high;
    Index id;

    /// Of shorter length or, of the same length, of greater ids: later in the queue.
    bool operator<(const Edge& other) const {
      return std::tie(squared_length, other.low, other.high) <
             std::tie(other.squared_length, low, high);
    }
  };

  void find_edges() {
    const EdgeTable edges(soup_);
    next_side_.resize(3 * soup_.triangles.size());
    edge_of_.resize(next_side_.size());
    std::vector<Edge> queue;
    edges.for_each_edge([&](std::span<const EdgeSide> sides) {
      for (std::size_t i = 0; i < sides.size(); ++i) {
        next_side_[sides[i].half_edge] = sides[(i + 1) % sides.size()].half_edge;
        edge_of_[sides[i].half_edge] = static_cast<Index>(a_side_.size());
      }
      queue.push_back(new_edge(sides[0].half_edge));
    });
    longest_ = std::priority_queue<Edge>({}, std::move(queue));
  }

  Index origin(Index h) const { return origin_of(soup_.triangles, h); }

  /// Numbers the edge that `side` is a side of.
  Edge new_edge(Index side) {
    const auto [low, high] = std::minmax({origin(side), origin(next_in_face(side))});
    const Vec3 along = subtract(soup_.positions[high], soup_.positions[low]);
    a_side_.push_back(side);
    return {dot(along, along), low, high, static_cast<Index>(a_side_.size() - 1)};
  }

  /// Links sides to one edge and puts it into the queue.
  void add_edge(std::span<const Index> sides) {
    for (std::size_t i = 0; i < sides.size(); ++i) {
      next_side_[sides[i]] = sides[(i + 1) % sides.size()];
      edge_of_[sides[i]] = static_cast<Index>(a_side_.size());
    }
    longest_.push(new_edge(sides[0]));
  }

  void split(const Edge edge) {
    longest_.pop();
    const auto middle = static_cast<Index>(soup_.positions.size());
    soup_.positions.push_back(
        scale(0.5, add(soup_.positions[edge.low], soup_.positions[edge.high])));
    sides_.clear();
    for (Index h = a_side_[edge.id]; sides_.empty() || h != sides_.front(); h = next_side_[h]) {
      sides_.push_back(h);
    }
    sides_at_low_.clear();
    sides_at_high_.clear();
    for (const Index h : sides_) {
      const bool starts_low = origin(h) == edge.low;
      const Index second = split_face(h, middle);
      (starts_low ? sides_at_low_ : sides_at_high_).push_back(h);
      (starts_low ? sides_at_high_ : sides_at_low_).push_back(second);
    }
    add_edge(sides_at_low_);
    add_edge(sides_at_high_);
  }

  /// Cuts the face of half-edge h from x to y in two: h stays, from x to the middle, and a new face
  /// takes the half-edge from the middle to y, which is returned, and the side that follows.
  Index split_face(Index h, Index middle) {
    const Index next = next_in_face(h);
    const Index y = origin(next), apex = origin(previous_in_face(h));
    const auto second = static_cast<Index>(3 * soup_.triangles.size());
    soup_.triangles.push_back({middle, y, apex});
    soup_.triangles[h / 3][next % 3] = middle;
    next_side_.resize(next_side_.size() + 3);
    edge_of_.resize(edge_of_.size() + 3);
    replace_side(next, second + 1);
    add_edge(std::array<Index, 2>{next, second + 2});
    return second;
  }

  /// The edge of side `old` gets the side `replacement` in its place.
  void replace_side(Index old, Index replacement) {
    const Index edge = edge_of_[old];
    edge_of_[replacement] = edge;
    if (a_side_[edge] == old) a_side_[edge] = replacement;
    if (next_side_[old] == old) {
      next_side_[replacement] = replacement;
      return;
    }
    Index before = old;
    while (next_side_[before] != old) before = next_side_[before];
    next_side_[before] = replacement;
    next_side_[replacement] = next_side_[old];
  }

  TriangleSoup& soup_;
  std::vector<Index> next_side_;  // a half-edge a side: round all sides of its edge
  std::vector<Index> edge_of_;
  std::vector<Index> a_side_;  // an edge's
  std::priority_queue<Edge> longest_;
  std::vector<Index> sides_, sides_at_low_, sides_at_high_;  // of the edge that is being split
};

TriangleSoup make_refine(const CheckedParameters& parameters) {
  TriangleSoup soup = read_input(parameters);
  drop_isolated_vertices(soup);
  const Index vertices = parameters.integer("vertices");
  if (vertices < soup.positions.size()) {
    throw std::invalid_argument("refine: parameter vertices is " + ParameterValue(vertices).text() +
                                ", but the mesh of " + parameters.text("input") + " has " +
                                ParameterValue(soup.positions.size()).text() +
                                " without the isolated ones; choose more");
  }
  Refiner(soup).refine_to(vertices);
  return soup;
}

}  // namespace

Family refine() {
  return {{.name = "refine",
           .description = "a mesh without its isolated vertices whose longest edge is cut in the "
                          "middle until there are `vertices`; the surface stays the same",
           .parameters = {input_parameter(), integer_parameter("vertices", 100000, 3, 500000000,
                                                               "of the refined mesh")}},
          make_refine};
}

}  // namespace geodesic
