#include "meshes/oracles/path.h"

#include <algorithm>
#include <cmath>

#include "meshes/oracles/view.h"

namespace geodesic {
namespace {

// Relative difference of lengths below which paths are equally short.
constexpr Real kTie = 1e-14L;

// Relative error above which a distance belongs to no path.
constexpr Real kNoPath = 1e-9L;

// Finds the piece that ends at the target and gives it the least distance.
class LastPiece {
 public:
  LastPiece(const Mesh& mesh, std::span<const double> distances, Index target)
      : mesh_(mesh), distances_(distances), target_(target) {}

  StraightPiece find() {
    for (const Index h : mesh_.outgoing(target_)) {
      consider_edge(mesh_.head(h));
      consider_edge(mesh_.apex(h));
    }
    view_from(mesh_, target_, distances_[target_], [&](const Sight& sight) {
      if (improves(sight.vertex, sight.length)) piece_.crossings = crossings_of(sight);
    });
    return piece_;
  }

  /// Length of the path with this piece.
  Real distance() const { return distance_; }

 private:
  void consider_edge(Index from) {
    if (improves(from, straight_distance(mesh_, from, target_))) piece_.crossings.clear();
  }

  // Of equally short pieces, the longest is taken: its path bends least often.
  bool improves(Index from, Real length) {
    if (!(distances_[from] < distances_[target_])) return false;
    const Real through = distances_[from] + length, slack = kTie * through;
    const bool shorter = through < distance_ - slack;
    const bool longer_tie = through < distance_ + slack && length > piece_.length;
    if (!shorter && !longer_tie) return false;
    distance_ = through;
    piece_ = {.from = from,
              .to = target_,
              .length = static_cast<double>(length),
              .crossings = std::move(piece_.crossings)};
    return true;
  }

  // The view is from the target to the origin of the piece, against the direction of travel.
  std::vector<EdgeCrossing> crossings_of(const Sight& sight) const {
    const PlanePoint& p = sight.at;
    std::vector<EdgeCrossing> crossings;
    for (const EdgeInView& edge : sight.strip) {
      const Real left = turn({}, p, edge.origin), right = turn({}, p, edge.head);
      const Real share = right / (right - left);  // part of the edge from its head
      const Real length = geodesic::distance(edge.origin, edge.head);
      const Real x = edge.head.x + share * (edge.origin.x - edge.head.x);
      const Real y = edge.head.y + share * (edge.origin.y - edge.head.y);
      crossings.push_back({.half_edge = mesh_.twin(edge.half_edge),
                           .position = static_cast<double>(share * length),
                           .travelled = static_cast<double>(sight.length - std::hypot(x, y))});
    }
    std::ranges::reverse(crossings);
    return crossings;
  }

  const Mesh& mesh_;
  std::span<const double> distances_;
  Index target_;
  Real distance_ = kInfinity;
  StraightPiece piece_ = {.from = kNone, .to = kNone, .length = 0, .crossings = {}};
};

}  // namespace

std::vector<StraightPiece> shortest_path(const Mesh& mesh, std::span<const InternalSource> sources,
                                         std::span<const double> distances, Index target) {
  const auto starts_here = [&](Index v) {
    return std::ranges::any_of(sources, [&](const InternalSource& source) {
      return source.at.vertex == v && source.distance <= distances[v];
    });
  };
  std::vector<StraightPiece> path;
  for (Index v = target; !starts_here(v) && std::isfinite(distances[v]);) {
    LastPiece last(mesh, distances, v);
    path.push_back(last.find());
    v = path.back().from;
    const Real wanted = distances[path.back().to];
    if (v == kNone || std::abs(last.distance() - wanted) > kNoPath * wanted) return {};
  }
  std::ranges::reverse(path);
  return path;
}

}  // namespace geodesic
