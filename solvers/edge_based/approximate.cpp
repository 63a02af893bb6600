// `edge-based-approximate`: edge-based propagation that merges the windows of an edge as long as no
// distance is off by more than a tolerance. How, and why that holds: solvers/edge_based/merge.h.
#include "solvers/edge_based/edge_based.h"

namespace geodesic::edge_based {

/// Merges as long as a distance D is short of the truth by at most a shortfall s, and gives D +
/// share * s: off by no more than (1 - share) * s, which is what the tolerance limits.
class Merging : public ByDistance {
 public:
  static constexpr bool kMerges = true;

  explicit Merging(const Description& description) : tolerance_(description.real("tolerance")) {}

  double shortfall() const {
    return tolerance_ < kLeast ? 0 : tolerance_ / (1 - kShare) * (1 - kRoundedUp);
  }
  double share() const { return kShare; }

 private:
  /// Of the shortfall, of distances on scans: between 0.2 and 0.4, whatever the tolerance.
  static constexpr double kShare = 0.3;
  /// Vertices keep shortfalls in 32 bits, rounded up by less than this, relatively.
  static constexpr double kRoundedUp = 1e-6;
  /// What is less is not worth merging, and comes near to rounding.
  static constexpr double kLeast = 1e-9;

  double tolerance_;
};

namespace {

const RegisterSolver<EdgeBased<Merging>> approximate{{
    .name = "edge-based-approximate",
    .family = "edge-based",
    .paper = "thesis section 6.2.2",
    .data_structure = "list and priority queue",
    .time_complexity = "O(n log n)",
    .space_complexity = "O(n)",
    .propagation = "edge",
    .spatial_order = true,
    .exactness = Exactness::bounded,
    .error_bound = [](const Description& solver) { return solver.real("tolerance"); },
    .by_name_only = true,
    .abilities = {.non_manifold_edges = true, .surface_sources = true},
    .remarks = "tolerance=0 gives the distances of edge-based",
    .parameters = {real_parameter("tolerance", 0.01, 0, 1, "the largest relative error")},
}};

}  // namespace
}  // namespace geodesic::edge_based
