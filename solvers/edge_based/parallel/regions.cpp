#include "solvers/edge_based/parallel/regions.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "solvers/core/numbering.h"
#include "solvers/core/thread_team.h"

namespace geodesic::edge_based {
namespace {

/// Assigns a region to each vertex.
class BoxCutter {
 public:
  BoxCutter(const Mesh& mesh, Index most) : most_(most), region_of_(mesh.vertex_count()) {
    std::vector<Index> corners;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (!mesh.outgoing(v).empty()) corners.push_back(v);
    }
    cut(cells_along_curve(mesh.positions(), corners), kCurveBits);
    count_ = std::max(count_, Index{1});
  }
  std::vector<Index> regions() && { return std::move(region_of_); }
  Index count() const { return count_; }

 private:
  /// @param vertices of one box, in order along the curve
  /// @param bits number of bits of cells in which they may differ; vertices of one cell are cut by
  ///        number
  void cut(std::span<const OnCurve> vertices, unsigned bits) {
    if (vertices.empty()) return;
    if (vertices.size() <= most_) {
      for (const OnCurve& v : vertices) region_of_[v.vertex] = count_;
      ++count_;
      return;
    }
    const auto in_first_half = [bits](const OnCurve& v) { return (v.cell >> (bits - 1) & 1) == 0; };
    const auto half = bits > 0 ? std::ranges::partition_point(vertices, in_first_half)
                               : vertices.begin() + std::ssize(vertices) / 2;
    const auto middle = static_cast<std::size_t>(half - vertices.begin());
    const unsigned left = bits > 0 ? bits - 1 : 0;
    cut(vertices.first(middle), left);
    cut(vertices.subspan(middle), left);
  }

  std::size_t most_;
  std::vector<Index> region_of_;  // isolated vertices are in the first region
  Index count_ = 0;
};

/// Cuts one region after the other out of a mesh.
class RegionBuilder {
 public:
  /// @param faces region and number of each face of the mesh; @param is_shared by vertex
  RegionBuilder(const Mesh& mesh, std::span<const InRegion> faces,
                std::span<const std::uint8_t> is_shared)
      : mesh_(mesh), faces_(faces), is_shared_(is_shared), number_(mesh.vertex_count(), kNone) {}

  /// @param own the faces of region r, in order; @param isolated its vertices without faces
  /// @return the region without copies and neighbours
  Region build(Index r, std::span<const Index> own, std::span<const Index> isolated) {
    std::vector<Index> vertices(isolated.begin(), isolated.end()), shared;
    for (const Index f : own) {
      for (const Index v : mesh_.triangle(f)) {
        if (number_[v] != kNone) continue;
        number_[v] = 0;
        (is_shared_[v] != 0 ? shared : vertices).push_back(v);
      }
    }
    std::ranges::sort(shared);
    const auto first_shared = static_cast<Index>(vertices.size());
    vertices.insert(vertices.end(), shared.begin(), shared.end());
    for (Index i = 0; i < vertices.size(); ++i) number_[vertices[i]] = i;
    std::vector<InRegion> beyond;
    Mesh::Part part = part_of(own, r, beyond);
    for (const Index v : vertices) {
      part.positions.push_back(mesh_.position(v));
      part.pseudo_source.push_back(mesh_.is_pseudo_source(v) ? 1 : 0);
      number_[v] = kNone;
    }
    return {.mesh = Mesh(std::move(part)),
            .vertices = std::move(vertices),
            .first_shared = first_shared,
            .first_portal_face = static_cast<Index>(own.size()),
            .beyond = std::move(beyond)};
  }

 private:
  /// Part without positions and pseudo-sources of vertices. Their numbers must be set.
  Mesh::Part part_of(std::span<const Index> own, Index r, std::vector<InRegion>& beyond) const {
    Mesh::Part part;
    part.faces = static_cast<Index>(own.size());
    part.mean_edge_length = mesh_.mean_edge_length();
    std::vector<HalfEdge>& half_edges = part.half_edges;
    std::vector<HalfEdge> portals;
    half_edges.reserve(3 * own.size());
    for (const Index f : own) {
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        HalfEdge e = mesh_.half_edge(h);
        e.origin = number_[e.origin];
        if (e.twin != kNone) {
          const InRegion face = faces_[e.twin / 3];
          const InRegion twin = {face.region, 3 * face.number + e.twin % 3};
          if (twin.region == r) {
            e.twin = twin.number;
          } else {
            HalfEdge portal = mesh_.half_edge(e.twin);
            portal.twin = static_cast<Index>(half_edges.size());
            portal.origin = kNone;
            e.twin = 3 * part.faces + static_cast<Index>(portals.size());
            portals.push_back(portal);
            beyond.push_back(twin);
          }
        }
        half_edges.push_back(e);
      }
    }
    portals.resize((portals.size() + 2) / 3 * 3, HalfEdge{0, 0, 0, kNone, kNone});
    half_edges.reserve(half_edges.size() + portals.size());  // no more than that
    half_edges.insert(half_edges.end(), portals.begin(), portals.end());
    return part;
  }

  const Mesh& mesh_;
  std::span<const InRegion> faces_;
  std::span<const std::uint8_t> is_shared_;
  std::vector<Index> number_;  // by vertex of the mesh: its number in the current region
};

void link_copies(std::vector<Region>& regions) {
  struct Copy {
    Index vertex;
    InRegion at;
  };
  std::vector<Copy> all;
  for (Index r = 0; r < regions.size(); ++r) {
    const std::vector<Index>& vertices = regions[r].vertices;
    for (Index i = regions[r].first_shared; i < vertices.size(); ++i) {
      all.push_back({vertices[i], {r, i}});
    }
  }
  std::ranges::stable_sort(all, {}, &Copy::vertex);
  // The vertices of a region occur in the order of their numbers in it.
  for (std::size_t first = 0; first < all.size();) {
    std::size_t end = first;
    while (end < all.size() && all[end].vertex == all[first].vertex) ++end;
    for (std::size_t i = first; i < end; ++i) {
      Region& region = regions[all[i].at.region];
      for (std::size_t k = first; k < end; ++k) {
        if (k == i) continue;
        region.copies.push_back(all[k].at);
        region.neighbours.push_back(all[k].at.region);
      }
      region.first_copy.push_back(static_cast<Index>(region.copies.size()));
    }
    first = end;
  }
  for (Region& region : regions) {
    std::vector<Index>& neighbours = region.neighbours;
    std::ranges::sort(neighbours);
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }
}

}  // namespace

Regions::Regions(const Mesh& mesh, Index most, unsigned threads)
    : faces_(mesh.face_count()), first_copies_(mesh.vertex_count(), {kNone, kNone}) {
  BoxCutter cutter(mesh, most);
  const Index count = cutter.count();
  const std::vector<Index> region_of = std::move(cutter).regions();
  std::vector<std::uint8_t> is_shared(mesh.vertex_count(), 0);
  std::vector<std::vector<Index>> faces_of(count), isolated(count);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Triangle corners = mesh.triangle(f);
    const Index r = std::min({region_of[corners[0]], region_of[corners[1]], region_of[corners[2]]});
    faces_[f] = {r, static_cast<Index>(faces_of[r].size())};
    faces_of[r].push_back(f);
    for (const Index v : corners) {
      Index& first = first_copies_[v].region;
      is_shared[v] |= static_cast<std::uint8_t>(first != kNone && first != r);
      first = std::min(first, r);
    }
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (first_copies_[v].region == kNone) isolated[region_of[v]].push_back(v);
  }
  std::vector<std::optional<Region>> built(count);
  ThreadTeam::run(threads, count, [&](ThreadTeam& team, unsigned thread) {
    RegionBuilder builder(mesh, faces_, is_shared);
    const auto build = [&](std::size_t i) {
      const auto r = static_cast<Index>(i);
      built[i] = builder.build(r, faces_of[r], isolated[r]);
    };
    team.share(thread, count, team.in_equal_parts(count), build, [] {});
  });
  for (std::optional<Region>& region : built) regions_.push_back(std::move(*region));
  link_copies(regions_);
  for (Index r = count; r-- > 0;) {
    const std::vector<Index>& vertices = regions_[r].vertices;
    for (Index i = 0; i < vertices.size(); ++i) first_copies_[vertices[i]] = {r, i};
  }
}

}  // namespace geodesic::edge_based
