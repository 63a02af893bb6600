#include "solvers/straight_graph/last_links.h"

#include <algorithm>
#include <ranges>
#include <vector>

#include "solvers/core/last_segments.h"
#include "solvers/straight_graph/fan.h"
#include "solvers/straight_graph/unfold.h"

namespace geodesic::straight_graph {
namespace {

/// Least angle of a wedge that looks for the root of a link, in radians. At the end of a link, its
/// wedge may be far narrower than where it began.
constexpr double kLookBack = 1e-5;

/// A line may be longer than its link by this, relative to the distance: more than rounding, less
/// than paths may be longer than distances.
constexpr double kSameLine = 5e-13;

/// The origin of the plane in which a line was unfolded, in the frame of the half-edge through
/// which it reaches an apex. Differences of places in the plane would lose digits where the line is
/// far longer than the edges.
/// @param apex, side as Unfolder::follow passes them
Point2 origin_from(const Mesh& mesh, Index h, const Point2& apex, const Point2& side) {
  const FaceFrame face = face_frame(mesh, h);
  const Point2 along = turned(side, {face.left_x, -face.left_y});
  return {face.apex_x - dot(along, apex), std::min(face.apex_y - cross(along, apex), 0.0)};
}

class LastLinks {
 public:
  LastLinks(const Mesh& mesh, const InternalQuery& query, double angle,
            std::span<const double> distances, std::span<const Index> roots)
      : mesh_(mesh),
        query_(query),
        distances_(distances),
        roots_(roots),
        back_(mesh, kLookBack, 0),
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

  void run(Recording& recording) {
    for (Index i = 0; i < query_.sources.size(); ++i) leave_source(i);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (roots_[v] == kNone || roots_[v] == v) continue;
      if (lines_[v].half_edge == kNone) look_from_end(v);
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

  /// The line from a vertex's root to it.
  struct Line {
    Index half_edge = kNone;  ///< whose apex is the vertex
    double length = 0;
    Point2 from = {0, 0};  ///< the root in the frame of that half-edge
  };

  /// A point beyond a half-edge in its frame.
  /// @param p in the frame of the twin
  Point2 from_beyond(Index h, const Point2& p) const {
    return {mesh_.half_edge(h).length - p.x, std::min(-p.y, 0.0)};
  }

  /// Most that the line to a vertex can measure. It is shorter than its link by the rounding of
  /// that, or by more if the root came nearer later.
  double most(Index v) const {
    const Index root = roots_[v], vertices = mesh_.vertex_count();
    const double before =
        root < vertices ? distances_[root] : query_.sources[root - vertices].distance;
    return distances_[v] - before + kSameLine * distances_[v];
  }

  /// Notes a line to a vertex from its root, unless it is longer than the link. Of several the
  /// longest is the link; shorter ones came in wedges too narrow for links.
  void offer(Index v, const Line& line) {
    if (line.length <= most(v) && line.length >= lines_[v].length) lines_[v] = line;
  }

  /// Finds the lines that a source sent out.
  void leave_source(Index i) {
    const InternalPoint& at = query_.sources[i].at;
    const Index root = at.is_vertex() ? at.vertex : mesh_.vertex_count() + i;
    const auto reach = [&](Index h, const Point2& apex, const Point2& side) {
      const Index v = mesh_.apex(h);
      if (roots_[v] == root) offer(v, {h, norm(apex), origin_from(mesh_, h, apex, side)});
    };
    if (at.is_vertex()) {
      for (const Index h : mesh_.outgoing(at.vertex)) source_fan_.follow_from_vertex(h, reach);
      return;
    }
    const auto reach_corner = [&](Index h, const Point2& from, double distance, bool /*next*/) {
      if (roots_[mesh_.apex(h)] == root) offer(mesh_.apex(h), {h, distance, from});
    };
    spread_from(mesh_, at, reach_corner, [&](Index h, const Point2& from) {
      source_fan_.follow_from_point(h, from, reach);
    });
  }

  /// Finds the link to a vertex from a vertex.
  void look_from_end(Index v) {
    const Index root = roots_[v];
    for (const Index h : mesh_.outgoing(v)) {
      const Index opposite = Mesh::next(h);
      const double length = mesh_.half_edge(opposite).length;
      if (mesh_.head(h) == root) offer(v, {opposite, mesh_.half_edge(h).length, {0, 0}});
      if (mesh_.apex(h) == root) {
        offer(v, {opposite, mesh_.half_edge(Mesh::previous(h)).length, {length, 0}});
      }
    }
    if (lines_[v].half_edge != kNone || root >= mesh_.vertex_count()) return;
    const double longest = most(v);
    const auto may_lead = [&](const Unfolder::Wedge& wedge) {
      return least_length(wedge, mesh_.position(root)) <= longest;
    };
    for (const Index h : mesh_.outgoing(v)) {
      const FaceFrame face = face_frame(mesh_, h);
      const Index opposite = Mesh::next(h);
      const auto reach = [&](Index g, const Point2& at, const Point2& /*side*/) {
        if (mesh_.apex(g) != root) return;
        offer(v, {opposite, norm(at), from_beyond(opposite, face.to_right(at.x, at.y))});
      };
      back_.follow_from_vertex(h, reach, may_lead);
    }
  }

  /// A lower bound of the lengths of lines through a wedge to a point in space.
  double least_length(const Unfolder::Wedge& wedge, const Vec3& place) const {
    const double length = mesh_.half_edge(wedge.enter).length;
    const double t = std::clamp(-dot(wedge.left, wedge.along), 0.0, length);
    const double to_edge =
        norm(Point2{wedge.left.x + t * wedge.along.x, wedge.left.y + t * wedge.along.y});
    const Vec3 &left = mesh_.position(mesh_.origin(wedge.enter)),
               &right = mesh_.position(mesh_.head(wedge.enter));
    const Vec3 side = subtract(right, left), to_place = subtract(place, left);
    const double along = length > 0 ? geodesic::dot(side, to_place) / (length * length) : 0;
    return to_edge + geodesic::norm(subtract(to_place, scale(std::clamp(along, 0.0, 1.0), side)));
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
  Unfolder back_, source_fan_, target_fan_;
  LastSegments segments_;
  std::vector<Line> lines_;           // by vertex
  std::vector<SourceImage> sources_;  // by face
};

}  // namespace

void record_last_links(const Mesh& mesh, const InternalQuery& query, double angle,
                       std::span<const double> distances, std::span<const Index> roots,
                       Recording& recording) {
  LastLinks(mesh, query, angle, distances, roots).run(recording);
}

}  // namespace geodesic::straight_graph
