#include "solvers/straight_graph/sectors.h"

#include "solvers/core/tolerance.h"

namespace geodesic::straight_graph {
namespace {

constexpr float kUnset = -1;

}  // namespace

Sectors::Sectors(const Mesh& mesh)
    : direction_(mesh.half_edge_count(), kUnset),
      per_radian_(mesh.vertex_count(), 0),
      is_uncertain_(mesh.vertex_count(), 0) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const std::span<const Index> around = mesh.outgoing(v);
    double total = 0;
    int fans = 0;
    bool has_border = false;
    const auto lay_out = [&](Index h) {
      if (direction_[h] != kUnset) return;
      total = lay_out_fan(mesh, h, total) + std::numbers::pi;
      ++fans;
    };
    // A fan with a boundary begins at its only half-edge without a twin; any other anywhere.
    for (const Index h : around) {
      if (mesh.twin(h) != kNone) continue;
      has_border = true;
      lay_out(h);
    }
    for (const Index h : around) lay_out(h);
    if (fans == 1 && !has_border) total -= std::numbers::pi;
    if (total > 0) per_radian_[v] = static_cast<float>(kSectors / total);
  }
  for (Index h = 0; h < mesh.half_edge_count(); ++h) {
    const HalfEdge& e = mesh.half_edge(h);
    if (e.apex_y > kFlatFace * e.length) continue;
    is_uncertain_[e.origin] = is_uncertain_[mesh.head(h)] = is_uncertain_[mesh.apex(h)] = 1;
  }
}

double Sectors::lay_out_fan(const Mesh& mesh, Index h, double from) {
  for (; h != kNone && direction_[h] == kUnset; h = mesh.twin(Mesh::previous(h))) {
    direction_[h] = static_cast<float>(from);
    from += corner_angle(mesh.half_edge(h));
  }
  return from;
}

void Sectors::set_straight_on(Index v, double slack, Block& block) const {
  block.shift = 0;
  block.width = kSectors;
  if (is_uncertain_[v] != 0 || !(per_radian_[v] > 0)) return;
  const double per = per_radian_[v];
  const double begin = std::floor((std::numbers::pi - slack) * per);
  // An arrival lies anywhere in its sector, hence one more.
  const double end = std::floor(kSectors - (std::numbers::pi - slack) * per) + 2;
  if (end - begin >= kSectors) return;
  block.shift = static_cast<std::uint8_t>(std::fmod(begin, kSectors));
  block.width = static_cast<std::uint8_t>(std::max(end - begin, 0.0));
}

}  // namespace geodesic::straight_graph
