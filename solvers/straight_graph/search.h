// A query: Dijkstra's algorithm over the links that go straight on.
//
// A vertex has a label: its distance, and the sector in which the path to it arrives. When it is
// popped, the path goes on along all edges of the mesh, and into the links that leave nearly
// straight ahead. The edges alone make no distance longer than that of Dijkstra's algorithm on the
// mesh, and reach vertices that no nearly straight chain of links reaches.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

#include "solvers/core/query.h"
#include "solvers/straight_graph/front.h"
#include "solvers/straight_graph/graph.h"
#include "solvers/straight_graph/unfold.h"

namespace geodesic::straight_graph {

class Search {
 public:
  /// @param graph of the mesh; both must outlive this object
  /// @param angle the graph's
  Search(const Mesh& mesh, const Graph& graph, double angle);

  /// As Solver::run.
  /// @param roots unless empty, filled by vertex: where the line that reaches it begins, as
  ///        LastSegment::root
  void run(const InternalQuery& query, std::span<double> distances, std::span<Index> roots = {});

 private:
  /// A distance, rounded up by less than 2^-45 of it, whose last bits are the sector of arrival and
  /// whether the path has gone on.
  class Label {
   public:
    Label(double distance, unsigned sector)
        : bits_(((std::bit_cast<std::uint64_t>(distance) + kLastBits) & ~kLastBits) | sector) {}
    explicit Label(double stored) : bits_(std::bit_cast<std::uint64_t>(stored)) {}

    double distance() const { return std::bit_cast<double>(bits_ & ~kLastBits); }
    unsigned sector() const { return static_cast<unsigned>(bits_ & kSectorBits); }
    bool has_left() const { return (bits_ & kLeft) != 0; }
    void set_left() { bits_ |= kLeft; }
    double stored() const { return std::bit_cast<double>(bits_); }

   private:
    static constexpr std::uint64_t kSectorBits = 63, kLeft = 64, kLastBits = kSectorBits | kLeft;
    std::uint64_t bits_;
  };

  /// Reaches all vertices that a source in a face sees, and its corners.
  void leave_point(const InternalSource& source, Unfolder& fan);
  /// The same from a vertex.
  void leave_vertex(const InternalSource& source, Unfolder& fan);
  void improve(Index v, double distance, unsigned sector) {
    if (distance < labels_[v]) set_label(v, distance, sector);
  }
  void set_label(Index v, double distance, unsigned sector);
  void prefetch(const std::vector<Index>& bucket, std::size_t at) const;
  void leave(Index v);

  const Mesh& mesh_;
  const Graph& graph_;
  double angle_;
  Front front_;
  std::span<double> labels_;  // by vertex: Label::stored
  std::span<Index> roots_;    // as in run
  Index leaving_ = kNone;     // what paths leave at present, as in roots_
};

}  // namespace geodesic::straight_graph
