#include "meshes/coincidence.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "meshes/connectivity.h"

namespace geodesic {
namespace {

// Numbers different places from 0, in the order in which they are added: a hash table with linear
// probing.
class PlaceTable {
 public:
  explicit PlaceTable(std::size_t most) : slots_(std::bit_ceil(2 * most + 1)) {
    places_.reserve(most);
  }

  Index add(const Vec3& place) {
    const std::uint64_t hash = hash_of(place);
    Slot& slot = slots_[slot_of(place, hash)];
    if (slot.number == kNone) {
      slot = {tag_of(hash), static_cast<Index>(places_.size())};
      places_.push_back(place);
    }
    return slot.number;
  }

  // kNone if the place was not added.
  Index find(const Vec3& place) const { return slots_[slot_of(place, hash_of(place))].number; }

  std::span<const Vec3> places() const { return places_; }

 private:
  struct Slot {
    std::uint32_t tag = 0;
    Index number = kNone;
  };

  static std::uint32_t tag_of(std::uint64_t hash) { return static_cast<std::uint32_t>(hash); }

  static std::uint64_t hash_of(const Vec3& place) {
    std::uint64_t hash = 0x9e3779b97f4a7c15;
    for (const double c : place) {
      hash ^= std::bit_cast<std::uint64_t>(c + 0.0);  // -0 + 0 is 0
      hash *= 0xff51afd7ed558ccd;
      hash ^= hash >> 32;
    }
    return hash * 0xc4ceb9fe1a85ec53;
  }

  // The slot of the place, or the free one where it would be.
  std::size_t slot_of(const Vec3& place, std::uint64_t hash) const {
    std::size_t at = hash >> 32 & (slots_.size() - 1);
    for (;; at = (at + 1) & (slots_.size() - 1)) {
      const Slot& slot = slots_[at];
      if (slot.number == kNone) return at;
      if (slot.tag == tag_of(hash) && places_[slot.number] == place) return at;
    }
  }

  std::vector<Slot> slots_;
  std::vector<Vec3> places_;
};

Vec3 rounded_down(const Vec3& p) { return {std::floor(p[0]), std::floor(p[1]), std::floor(p[2])}; }

// Returns those vertices that share a cell of 256 times the distance with another one, or lie so
// near its sides that one in the cell beyond may be near: few, if the distance is small.
std::vector<Index> crowded(std::span<const Vec3> positions, std::span<const Index> vertices,
                           double distance) {
  constexpr double kSide = 256, kNear = 1.01 / kSide;
  const double scaling = 1 / (kSide * distance);
  const auto scaled = [&](Index v) { return scale(scaling, positions[v]); };
  PlaceTable cells(vertices.size());
  std::vector<Index> cell_of;
  std::vector<std::uint8_t> is_shared;
  cell_of.reserve(vertices.size());
  for (const Index v : vertices) {
    cell_of.push_back(cells.add(rounded_down(scaled(v))));
    if (cell_of.back() < is_shared.size()) {
      is_shared[cell_of.back()] = 1;
    } else {
      is_shared.push_back(0);
    }
  }
  const auto is_crowded = [&](std::size_t i) {
    if (is_shared[cell_of[i]] != 0) return true;
    const Vec3 at = scaled(vertices[i]), cell = rounded_down(at);
    Vec3 step{};
    unsigned axes = 0;  // one bit for each axis along which another cell is near
    for (unsigned k = 0; k < 3; ++k) {
      const double inside = at[k] - cell[k];
      if (inside > kNear && inside < 1 - kNear) continue;
      step[k] = inside > 0.5 ? 1 : -1;
      axes |= 1U << k;
    }
    for (unsigned some = 1; some < 8; ++some) {
      if ((some & ~axes) != 0) continue;
      Vec3 beyond = cell;
      for (unsigned k = 0; k < 3; ++k) beyond[k] += (some >> k & 1U) != 0 ? step[k] : 0;
      if (cells.find(beyond) != kNone) return true;
    }
    return false;
  };
  std::vector<Index> found;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (is_crowded(i)) found.push_back(vertices[i]);
  }
  return found;
}

// Pairs among vertices at different places. Those of one cell are near each other; those of two
// cells are joined by the first near pair, if there is one.
std::vector<std::pair<Index, Index>> near_pairs(std::span<const Vec3> positions,
                                                std::span<const Index> vertices, double distance) {
  constexpr double kSide = 0.51;  // its diagonal is below 1, twice its length above 1
  std::vector<std::pair<Index, Index>> pairs;
  DisjointSets sets(vertices.size());
  const auto join_if_near = [&](Index i, Index j) {
    const Index a = vertices[i], b = vertices[j];
    if (norm(subtract(positions[a], positions[b])) > distance) return false;
    if (sets.join(i, j)) pairs.emplace_back(std::min(a, b), std::max(a, b));
    return true;
  };
  PlaceTable cells(vertices.size());
  std::vector<std::vector<Index>> members;
  for (Index i = 0; i < vertices.size(); ++i) {
    const Index cell =
        cells.add(rounded_down(scale(1 / (kSide * distance), positions[vertices[i]])));
    if (cell == members.size()) members.emplace_back();
    members[cell].push_back(i);
    join_if_near(members[cell].front(), i);
  }
  const auto join_cells = [&](Index a, Index b) {
    for (const Index i : members[a]) {
      for (const Index j : members[b]) {
        if (sets.find(i) == sets.find(j) || join_if_near(i, j)) return;
      }
    }
  };
  for (Index cell = 0; cell < members.size(); ++cell) {
    for (int code = 63; code < 125; ++code) {  // half of the 124 cells around it
      const Vec3 step = {code / 25 - 2.0, code / 5 % 5 - 2.0, code % 5 - 2.0};
      const Index other = cells.find(add(cells.places()[cell], step));
      if (other != kNone && other != cell) join_cells(cell, other);
    }
  }
  std::ranges::sort(pairs, {}, &std::pair<Index, Index>::second);
  return pairs;
}

}  // namespace

Coincidences find_coincidences(std::span<const Vec3> positions, const std::vector<bool>& used,
                               double distance) {
  if (!(1 / distance < 1e300)) distance = 0;  // as good as 0, and cells would have no number
  std::vector<Index> vertices;
  for (Index v = 0; v < positions.size(); ++v) {
    if (used[v]) vertices.push_back(v);
  }
  if (distance > 0) vertices = crowded(positions, vertices, distance);
  Coincidences found;
  PlaceTable places(vertices.size());
  std::vector<Index> first;  // at each place
  for (const Index v : vertices) {
    const Index place = places.add(positions[v]);
    if (place == first.size()) {
      first.push_back(v);
    } else {
      found.same.emplace_back(first[place], v);
    }
  }
  if (distance > 0) found.near = near_pairs(positions, first, distance);
  return found;
}

}  // namespace geodesic
