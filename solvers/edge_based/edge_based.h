// The exact edge-based solver: a wavefront (wavefront.h) with exact lists (list_crossing.h).
#pragma once

#include <algorithm>
#include <memory>
#include <span>

#include "solvers/core/queues/queue_of.h"
#include "solvers/core/queues/vertex_calendar.h"
#include "solvers/core/registry.h"
#include "solvers/edge_based/list_crossing.h"
#include "solvers/edge_based/parallel/regional_wavefront.h"
#include "solvers/edge_based/wavefront.h"

namespace geodesic::edge_based {

/// The policy of `edge-based`: least distance first, up to a sixteenth of the mean edge length;
/// whole lists of windows cross a face.
struct ByDistance {
  using Crossing = ListCrossing;
  using Queue = VertexCalendar;
  static Queue make_queue(const Mesh& mesh) {
    return Queue(mesh.vertex_count(), mesh.mean_edge_length() / 16);
  }
};

/// A policy has
///   Queue              of vertices, in the order in which the wavefront passes them (VertexQueue)
///   make_queue(mesh)   an empty one; with (mesh, description), it reads parameters (queue_of.h)
///   Crossing           what crosses a face (wavefront.h), made as ListCrossing(mesh, set, carried)
template <class Policy>
class EdgeBased final : public Solver {
 public:
  EdgeBased(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), instruction_set_(compiled_for(geodesic::instruction_set())) {
    const auto threads = static_cast<unsigned>(description.thread_count());
    if (threads == 1 || mesh.crosses_non_manifold_edges() ||
        mesh.vertex_count() <= region_size(description)) {
      serial_ = make_serial();
    } else {
      regional_ = std::make_unique<RegionalWavefront>(mesh, instruction_set_, threads,
                                                      region_size(description));
    }
  }

  InstructionSet instruction_set() const override { return instruction_set_; }

  void run(const Start& start, std::span<double> distances) override {
    const InternalQuery& query = start.query;
    const bool ends_early = query.stop_at_targets || query.limit < kInfinity;
    if (regional_ != nullptr && !ends_early) {
      regional_->run(start, distances);
    } else {
      if (serial_ == nullptr) serial_ = make_serial();
      serial_->run(start, distances);
    }
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    solve_recorded(carried_for(recording.kind), start, distances, recording);
  }

 private:
  using Serial = Wavefront<typename Policy::Crossing, typename Policy::Queue, NoRecorder>;

  Index region_size(const Description& description) const {
    const Index asked = description.integer("region-size");
    return asked > 0 ? asked : usual_region_size(mesh());
  }

  template <class Recorder>
  auto make_wavefront(Carried carried, const Recorder& recorder) const {
    return Wavefront<typename Policy::Crossing, typename Policy::Queue, Recorder>(
        mesh(), queue_of<Policy>(mesh(), description()),
        typename Policy::Crossing(mesh(), instruction_set_, carried), recorder);
  }
  std::unique_ptr<Serial> make_serial() const {
    return std::make_unique<Serial>(make_wavefront(carried_on(mesh()), NoRecorder()));
  }

  Carried carried_for(RecordingKind kind) const {
    if (kind == RecordingKind::counters || kind == RecordingKind::wavefront) return Carried::depth;
    const Carried least = kind == RecordingKind::paths ? Carried::root : Carried::nothing;
    return std::max(least, carried_on(mesh()));
  }

  /// A recorded solve; defined in recorded.h.
  void solve_recorded(Carried carried, const Start& start, std::span<double> distances,
                      Recording& recording) const;

  InstructionSet instruction_set_;
  std::unique_ptr<Serial> serial_;
  std::unique_ptr<RegionalWavefront> regional_;  // null with one thread
};

}  // namespace geodesic::edge_based
