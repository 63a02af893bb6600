#include "solvers/paths/sleeve.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace geodesic {
namespace {

/// The half-edge to cross next around the vertex on the left or right of the last crossing.
Index next_round(Index entered, bool left) {
  return left ? Mesh::previous(entered) : Mesh::next(entered);
}

struct Turn {
  Crossings crossings;
  double angle = 0;  ///< of the faces between the first and the last one
};

/// Goes round a vertex, which lies on the left or right, from one face to another.
/// @return nothing when there is a boundary or a face less on the way
std::optional<Turn> turn_round(const Mesh& mesh, Index v, Index from, Index to, bool left) {
  const auto corners = mesh.outgoing(v);
  const auto corner = std::ranges::find(corners, from, [](Index h) { return h / 3; });
  if (corner == corners.end()) return std::nullopt;
  Turn turn;
  Index crossing = left ? Mesh::previous(*corner) : *corner;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index entered = mesh.twin(crossing);
    if (entered == kNone) return std::nullopt;
    turn.crossings.push_back(crossing);
    if (entered / 3 == to) return turn;
    crossing = next_round(entered, left);
    turn.angle += angle_before(mesh, crossing, left);
  }
  return std::nullopt;
}

/// The crossings at a point between two faces; nothing when the curve cannot leave that point.
std::optional<Crossings> crossings_at(const Mesh& mesh, const InternalPoint& point, Index from,
                                      Index to) {
  if (from == to) return Crossings{};
  if (point.is_vertex()) {
    auto left = turn_round(mesh, point.vertex, from, to, true);
    auto right = turn_round(mesh, point.vertex, from, to, false);
    if (left && (!right || left->angle <= right->angle)) return std::move(left->crossings);
    if (right) return std::move(right->crossings);
    const bool is_shared = std::ranges::count(mesh.triangle(from), point.vertex) == 1 &&
                           std::ranges::count(mesh.triangle(to), point.vertex) == 1;
    if (is_shared) return std::nullopt;
  } else if (const Index under = edge_under(point); under != kNone) {
    for (const Index h : {under, mesh.twin(under)}) {
      if (h == kNone || h / 3 != from) continue;
      if (mesh.twin(h) != kNone && mesh.twin(h) / 3 == to) return Crossings{h};
    }
  }
  throw std::invalid_argument("the curve jumps from face " +
                              std::to_string(mesh.numbers().external_face(from)) + " to face " +
                              std::to_string(mesh.numbers().external_face(to)));
}

void append(Crossings& crossings, const Crossings& more) {
  crossings.insert(crossings.end(), more.begin(), more.end());
}

Index last_face(const Mesh& mesh, const Sleeve& sleeve) {
  return sleeve.crossings.empty() ? sleeve.face : mesh.twin(sleeve.crossings.back()) / 3;
}

bool touches(const Mesh& mesh, Index crossing, const InternalPoint& point) {
  if (point.is_vertex()) {
    return mesh.origin(crossing) == point.vertex || mesh.head(crossing) == point.vertex;
  }
  const Index under = edge_under(point);
  return under != kNone && (crossing == under || crossing == mesh.twin(under));
}

}  // namespace

std::vector<Sleeve> sleeves_of(const Mesh& mesh, std::span<const PathPoint> points) {
  std::vector<Sleeve> sleeves;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i].face == kNone) throw std::invalid_argument("the curve leaves the surface");
    const Sleeve step{in_internal_numbers(mesh, points[i].at),
                      in_internal_numbers(mesh, points[i + 1].at),
                      mesh.numbers().internal_face(points[i].face),
                      {}};
    if (sleeves.empty() || !join(mesh, sleeves.back(), step)) sleeves.push_back(step);
  }
  return sleeves;
}

bool join(const Mesh& mesh, Sleeve& sleeve, const Sleeve& next) {
  const auto between = crossings_at(mesh, sleeve.end, last_face(mesh, sleeve), next.face);
  if (!between) return false;
  append(sleeve.crossings, *between);
  append(sleeve.crossings, next.crossings);
  sleeve.end = next.end;
  return true;
}

std::optional<Crossings> closed(const Mesh& mesh, const Sleeve& sleeve) {
  auto all = crossings_at(mesh, sleeve.end, last_face(mesh, sleeve), sleeve.face);
  if (!all) return std::nullopt;
  append(*all, sleeve.crossings);
  cancel_returns(mesh, *all, true);
  return all;
}

void cancel_returns(const Mesh& mesh, Crossings& crossings, bool is_cyclic) {
  Crossings kept;
  for (const Index h : crossings) {
    if (!kept.empty() && mesh.twin(kept.back()) == h) {
      kept.pop_back();
    } else {
      kept.push_back(h);
    }
  }
  std::size_t ends = 0;  // crossings to remove at each end
  while (is_cyclic && 2 * ends + 1 < kept.size() &&
         mesh.twin(kept[ends]) == kept[kept.size() - 1 - ends]) {
    ++ends;
  }
  const auto gap = static_cast<std::ptrdiff_t>(ends);
  crossings.assign(kept.begin() + gap, kept.end() - gap);
}

void trim(const Mesh& mesh, Sleeve& sleeve) {
  Crossings& all = sleeve.crossings;
  cancel_returns(mesh, all, false);
  const auto first =
      std::ranges::find_if(all, [&](Index h) { return !touches(mesh, h, sleeve.begin); });
  if (first != all.begin()) sleeve.face = mesh.twin(*std::prev(first)) / 3;
  all.erase(all.begin(), first);
  while (!all.empty() && touches(mesh, all.back(), sleeve.end)) all.pop_back();
}

double angle_before(const Mesh& mesh, Index crossing, bool left) {
  const HalfEdge& leaving = mesh.half_edge(left ? Mesh::next(crossing) : crossing);
  return std::atan2(leaving.apex_y, leaving.apex_x);
}

bool is_passable(const Mesh& mesh, Index v) {
  const auto corners = mesh.outgoing(v);
  std::size_t faces = 0;
  Index h = corners.front();
  do {
    h = mesh.twin(Mesh::previous(h));
    ++faces;
  } while (h != kNone && h != corners.front());
  return h != kNone && faces == corners.size();
}

Crossings round_other_side(const Mesh& mesh, std::span<const Index> run, bool left) {
  const std::size_t faces = mesh.outgoing(vertex_beside(mesh, run.front(), left)).size();
  if (run.size() >= faces) {  // more than once around the vertex
    return {run.begin(), run.end() - static_cast<std::ptrdiff_t>(faces)};
  }
  Crossings crossings;
  Index crossing = left ? Mesh::next(run.front()) : Mesh::previous(run.front());
  while (crossings.size() < faces - run.size()) {
    crossings.push_back(crossing);
    crossing = next_round(mesh.twin(crossing), !left);
  }
  return crossings;
}

}  // namespace geodesic
