#include "solvers/straight_graph/last_links.h"

#include <algorithm>
#include <ranges>
#include <vector>

#include "solvers/core/last_segments.h"
#include "solvers/straight_graph/fan.h"
#include "solvers/straight_graph/unfold.h"

namespace geodesic::straight_graph {
namespace {

class LastLinks {
 public:
  LastLinks(const Mesh& mesh, const InternalQuery& query, double angle,
            std::span<const double> distances, std::span<const Index> roots)
      : mesh_(mesh),
        query_(query),
        distances_(distances),
        roots_(roots),
        source_fan_(mesh, angle_of_fan(query, angle)),
        target_fan_(mesh, kFanAngle),
        segments_(mesh, query),
        lines_(mesh.vertex_count()) {
    for (Index i = 0; i < query.sources.size(); ++i) {
      const InternalSource& source = query.sources[i];
      if (source.at.is_vertex()) continue;
      for (const InternalPoint& image : in_every_face(mesh, source.at)) {
        sources_.push_back({image, i});
      }
    }
    std::ranges::sort(sources_, {}, &SourceImage::face);
  }

  void run(const FollowLinks& follow_links, Recording& recording) {
    for (Index i = 0; i < query_.sources.size(); ++i) leave_source(i);
    std::vector<bool> is_root(mesh_.vertex_count());
    for (const Index root : roots_) {
      if (root < mesh_.vertex_count()) is_root[root] = true;
    }
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (!is_root[v]) continue;
      follow_edges(v);
      follow_links(v, [&](const Line& line) { offer(v, line); });
    }
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (roots_[v] == kNone || roots_[v] == v) continue;
      segments_.arrived(v, {lines_[v].half_edge, roots_[v], lines_[v].from});
    }
    for (Index i = 0; i < query_.targets.size(); ++i) {
      if (!query_.targets[i].is_vertex()) look_from_target(i);
    }
    segments_.finish(distances_, recording);
    recording.shortest_paths = false;
  }

 private:
  /// A source in a face that contains it.
  struct SourceImage {
    InternalPoint at;
    Index source;
    Index face() const { return at.face; }
  };

  /// A point beyond a half-edge in its frame.
  /// @param p in the frame of the twin
  Point2 from_beyond(Index h, const Point2& p) const {
    return {mesh_.half_edge(h).length - p.x, std::min(-p.y, 0.0)};
  }

  /// Notes a line from a root. The link is the shortest of those that were found.
  void offer(Index root, const Line& line) {
    const Index v = mesh_.apex(line.half_edge);
    if (roots_[v] == root && line.length < lines_[v].length) lines_[v] = line;
  }

  /// Finds the lines that a source sent out.
  void leave_source(Index i) {
    const InternalPoint& at = query_.sources[i].at;
    const Index root = at.is_vertex() ? at.vertex : mesh_.vertex_count() + i;
    const auto reach = [&](Index h, const Point2& apex, const Point2& side) {
      offer(root, line_of(mesh_, h, apex, side));
    };
    if (at.is_vertex()) {
      for (const Index h : mesh_.outgoing(at.vertex)) source_fan_.follow_from_vertex(h, reach);
      return;
    }
    const auto reach_corner = [&](Index h, const Point2& from, double distance, bool /*next*/) {
      offer(root, {h, distance, from});
    };
    spread_from(mesh_, at, reach_corner, [&](Index h, const Point2& from) {
      source_fan_.follow_from_point(h, from, reach);
    });
  }

  /// Finds the lines along the edges of a vertex.
  void follow_edges(Index v) {
    for (const Index h : mesh_.outgoing(v)) {
      const Index into = Mesh::previous(h);
      const HalfEdge &out = mesh_.half_edge(h), &in = mesh_.half_edge(into);
      offer(v, {into, out.length, {in.length, 0}});
      offer(v, {h, in.length, {0, 0}});
    }
  }

  /// Finds the lines to a target from vertices and sources beyond the faces that contain it.
  void look_from_target(Index i) {
    const auto skip_corner = [](Index, const Point2&, double, bool) {};
    spread_from(mesh_, query_.targets[i], skip_corner, [&](Index h, const Point2& target) {
      const auto offer = [&](Index root, double before, const Point2& at) {
        const Point2 from = from_beyond(h, {at.x + target.x, at.y + target.y});
        segments_.offer(i, before + norm(at), {h, root, from});
      };
      target_fan_.follow_from_point(
          h, target,
          [&](Index g, const Point2& apex, const Point2& /*side*/) {
            const Index v = mesh_.apex(g);
            offer(v, distances_[v], apex);
          },
          [&](const Unfolder::Wedge& wedge) {
            const auto here =
                std::ranges::equal_range(sources_, wedge.enter / 3, {}, &SourceImage::face);
            for (const SourceImage& each : here) {
              const Point2 at = wedge.in_plane(in_frame(mesh_, each.at, wedge.enter));
              if (cross(wedge.right_ray, at) < 0 || cross(at, wedge.left_ray) < 0) continue;
              offer(mesh_.vertex_count() + each.source, query_.sources[each.source].distance, at);
            }
            return true;
          });
    });
  }

  const Mesh& mesh_;
  const InternalQuery& query_;
  std::span<const double> distances_;
  std::span<const Index> roots_;
  Unfolder source_fan_, target_fan_;
  LastSegments segments_;
  std::vector<Line> lines_;           // by vertex
  std::vector<SourceImage> sources_;  // by face
};

}  // namespace

void record_last_links(const Mesh& mesh, const InternalQuery& query, double angle,
                       std::span<const double> distances, std::span<const Index> roots,
                       const FollowLinks& follow_links, Recording& recording) {
  LastLinks(mesh, query, angle, distances, roots).run(follow_links, recording);
}

}  // namespace geodesic::straight_graph
