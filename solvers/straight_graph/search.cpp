#include "solvers/straight_graph/search.h"

#include <algorithm>

#include "solvers/straight_graph/fan.h"

namespace geodesic::straight_graph {
namespace {

/// Width of buckets in mean edge lengths.
constexpr double kBucketWidth = 1;

}  // namespace

Search::Search(const Mesh& mesh, const Graph& graph, double angle)
    : mesh_(mesh), graph_(graph), angle_(angle), front_(kBucketWidth * mesh.mean_edge_length()) {}

void Search::run(const InternalQuery& query, std::span<double> distances, std::span<Index> roots) {
  labels_ = distances;
  roots_ = roots;
  front_.clear();
  const double fan_angle = angle_of_fan(query, angle_);
  Unfolder fan(mesh_, fan_angle);
  for (Index i = 0; i < query.sources.size(); ++i) {
    const InternalSource& source = query.sources[i];
    if (!source.at.is_vertex()) {
      leaving_ = mesh_.vertex_count() + i;
      leave_point(source, fan);
      continue;
    }
    leaving_ = source.at.vertex;
    improve(source.at.vertex, source.distance, kAnySector);
    if (fan_angle < angle_) leave_vertex(source, fan);
  }
  StopRule stop_rule(mesh_, query, distances);
  while (front_.advance() && !stop_rule.is_over(front_.least_distance())) {
    const std::vector<Index>& bucket = front_.bucket();
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      prefetch(bucket, i);
      leave(bucket[i]);
    }
  }
  for (double& d : distances) d = Label(d).distance();
  for (const InternalSource& source : query.sources) {
    if (!source.at.is_vertex()) continue;
    double& own = distances[source.at.vertex];
    own = std::min(own, source.distance);
  }
}

void Search::leave_point(const InternalSource& source, Unfolder& fan) {
  const auto reach_corner = [&](Index h, const Point2& /*from*/, double distance, bool /*next*/) {
    improve(mesh_.apex(h), source.distance + distance, kAnySector);
  };
  spread_from(mesh_, source.at, reach_corner, [&](Index side, const Point2& from) {
    fan.follow_from_point(side, from, [&](Index h, const Point2& apex, const Point2& /*side*/) {
      improve(mesh_.apex(h), source.distance + norm(apex), kAnySector);
    });
  });
}

void Search::leave_vertex(const InternalSource& source, Unfolder& fan) {
  for (const Index h : mesh_.outgoing(source.at.vertex)) {
    const HalfEdge& e = mesh_.half_edge(h);
    improve(mesh_.head(h), source.distance + e.length, kAnySector);
    improve(mesh_.apex(h), source.distance + mesh_.half_edge(Mesh::previous(h)).length, kAnySector);
    fan.follow_from_vertex(h, [&](Index entered, const Point2& apex, const Point2& /*side*/) {
      improve(mesh_.apex(entered), source.distance + norm(apex), kAnySector);
    });
  }
}

void Search::set_label(Index v, double distance, unsigned sector) {
  const Label old(labels_[v]), label(distance, sector);
  // Edges without length form circles: an equal distance is no reason to go round again.
  if (!(distance < old.distance())) return;
  labels_[v] = label.stored();
  if (!roots_.empty()) roots_[v] = leaving_;
  const std::int64_t bucket = front_.bucket_of(label.distance());
  const bool waits_there = !old.has_left() && front_.bucket_of(old.distance()) == bucket;
  if (!waits_there) front_.push(v, bucket);
}

/// Starts to load what the next turns need.
void Search::prefetch(const std::vector<Index>& bucket, std::size_t at) const {
  constexpr std::size_t kBlockAhead = 12, kLinksAhead = 4;
  if (at + kBlockAhead < bucket.size()) graph_.prefetch_block(bucket[at + kBlockAhead]);
  if (at + kLinksAhead < bucket.size()) {
    const Index v = bucket[at + kLinksAhead];
    graph_.block(v).prefetch_for(Label(labels_[v]).sector());
  }
}

void Search::leave(Index v) {
  Label label(labels_[v]);
  if (label.has_left()) return;
  label.set_left();
  labels_[v] = label.stored();
  leaving_ = v;
  const Block& block = graph_.block(v);
  const auto scan = [&](std::span<const Link> links) {
    for (const Link& link : links) {
      improve(link.target(), label.distance() + link.length(), link.sector());
    }
  };
  scan(block.edges());
  if (label.sector() == kAnySector) return scan(block.links());
  block.for_straight_on(label.sector(), scan);
}

}  // namespace geodesic::straight_graph
