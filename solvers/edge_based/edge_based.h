// Edge-based propagation as a solver: the wavefront (wavefront.h) of exact lists (list_crossing.h).
#pragma once

#include <span>

#include "solvers/core/queues/vertex_calendar.h"
#include "solvers/core/registry.h"
#include "solvers/edge_based/list_crossing.h"
#include "solvers/edge_based/wavefront.h"

namespace geodesic::edge_based {

/// Least distance first, up to a sixteenth of the mean edge.
struct ByDistance {
  using Queue = VertexCalendar;
  static Queue make_queue(const Mesh& mesh) {
    return Queue(mesh.vertex_count(), mesh.mean_edge_length() / 16);
  }
};

/// @tparam Order in which vertices leave the queue, as ByDistance
template <class Order>
class EdgeBased final : public Solver {
 public:
  EdgeBased(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        instruction_set_(compiled_for(geodesic::instruction_set())),
        timed_(make_wavefront(mesh, instruction_set_, Carried::nothing, NoRecorder())) {}

  InstructionSet instruction_set() const override { return instruction_set_; }

  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    solve_within_bound(distances, [&](bool drops_long_strips) {
      const Carried carried = carried_by(recording, drops_long_strips);
      if (recording != nullptr) {
        solve_recorded(mesh(), instruction_set_, carried, query, distances, *recording);
      } else if (carried == Carried::nothing) {
        timed_.run(query, distances);
      } else {
        make_wavefront(mesh(), instruction_set_, carried, NoRecorder()).run(query, distances);
      }
    });
  }

 private:
  template <class Recorder>
  static auto make_wavefront(const Mesh& mesh, InstructionSet set, Carried carried,
                             const Recorder& recorder) {
    return Wavefront<ListCrossing, typename Order::Queue, Recorder>(
        mesh, Order::make_queue(mesh), ListCrossing(mesh, set, carried), recorder);
  }

  static Carried carried_by(const Recording* recording, bool drops_long_strips) {
    if (recording != nullptr && recording->kind == RecordingKind::paths) return Carried::root;
    const bool counts = recording != nullptr && recording->kind != RecordingKind::phase_times;
    return counts || drops_long_strips ? Carried::depth : Carried::nothing;
  }

  /// A recorded solve; defined in recorded.h.
  static void solve_recorded(const Mesh& mesh, InstructionSet set, Carried carried,
                             const Query& query, std::span<double> distances, Recording& recording);

  InstructionSet instruction_set_;
  Wavefront<ListCrossing, typename Order::Queue, NoRecorder> timed_;
};

}  // namespace geodesic::edge_based
