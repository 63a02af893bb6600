// The wavefront loop. Included once per instruction set; see edge_based.cpp for the algorithm.
// Needs Google Highway.
#if defined(GEODESIC_EDGE_BASED_PROPAGATION) == defined(HWY_TARGET_TOGGLE)
#ifdef GEODESIC_EDGE_BASED_PROPAGATION
#undef GEODESIC_EDGE_BASED_PROPAGATION
#else
#define GEODESIC_EDGE_BASED_PROPAGATION
#endif

#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include "solvers/core/prefetch.h"
#include "solvers/core/queues/concepts.h"
#include "solvers/core/recorders.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/kernels-inl.h"
#include "solvers/edge_based/pencils.h"
#include "solvers/edge_based/propagation.h"

HWY_BEFORE_NAMESPACE();
namespace geodesic::edge_based::HWY_NAMESPACE {

/// @tparam Policy as in propagation.h
template <class Policy, class Recorder>
class Propagation final : public Propagator<Recorder> {
  static_assert(VertexQueue<typename Policy::Queue>,
                "the policy's Queue lacks a member of VertexQueue (core/queues/concepts.h)");

 public:
  Propagation(const Mesh& mesh, const Policy& policy)
      : mesh_(mesh),
        policy_(policy),
        lists_(mesh.half_edge_count()),
        front_(Policy::make_queue(mesh)),
        vertex_state_(mesh.vertex_count()),
        queued_(mesh.half_edge_count()),
        budget_(mesh) {
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      longest_edge_ = std::max(longest_edge_, mesh.half_edge(h).length);
    }
    rounding_ = coordinate_rounding(longest_edge_);
  }

  void run(const Query& query, std::span<double> distances, Recorder recorder) override {
    const auto timed = recorder.enter(Phase::propagation);
    start(distances);
    if constexpr (Recorder::kRecords) {
      recorder.recording.window_bytes = sizeof(Window);
      progress_.start(mesh_, query.source_vertices(mesh_));
    }
    for (Index i = 0; i < query.sources.size(); ++i) begin_at(query.sources[i], i, recorder);
    Ending ending(mesh_, query, distances_);
    while (!front_.empty() && !ending.is_over(front_.least_key())) {
      enter_faces_around(pop(recorder), recorder);
      for (std::size_t i = 0; i < fifo_.size(); ++i) cross_with_list(fifo_[i], recorder);
      fifo_.clear();
      if constexpr (Recorder::kRecords) {
        if (progress_.made_step()) sample(recorder);
      }
    }
    if (!front_.empty()) finish(ending.farthest(), recorder);
    if constexpr (Policy::kMerges) {
      for (std::size_t v = 0; v < distances_.size(); ++v) {
        distances_[v] += policy_.share() * double{shortfalls_[v]};
      }
    }
  }

 private:
  static constexpr Note kNoted = Policy::kMerges        ? Note::shortfall
                                 : Recorder::kRecords   ? Note::depth
                                 : Recorder::kRemembers ? Note::root
                                                        : Note::none;
  static constexpr std::uint8_t kPassed = 1;  // popped at least once
  static constexpr std::uint8_t kSource = 2;  // sends windows even where no path bends
  using Lists = WindowLists<kNoted>;

  bool crosses_sheets() const {
    return Recorder::kCrossesSheets && mesh_.crosses_non_manifold_edges();
  }

  /// Forgets the last solve, however it ended.
  void start(std::span<double> distances) {
    distances_ = distances;
    std::fill(vertex_state_.begin(), vertex_state_.end(), std::uint8_t{0});
    std::fill(queued_.begin(), queued_.end(), std::uint8_t{0});
    fifo_.clear();
    front_.clear();
    lists_.clear();
    budget_.start();
    if constexpr (Policy::kMerges) shortfalls_.assign(distances.size(), 0);
  }

  /// @param number of the source in the query
  void begin_at(const Source& source, Index number, Recorder& recorder) {
    if (!source.at.is_vertex()) return spread(source, mesh_.vertex_count() + number, recorder);
    begin_at(source.at.vertex, source.distance, {kNone, source.at.vertex, {0, 0}}, recorder);
    vertex_state_[source.at.vertex] |= kSource;
  }

  // Out of line, so that `reach` is inlined into the loop.
  [[gnu::cold, gnu::noinline]] void begin_at(Index v, double distance,
                                             const ArrivalOf<Recorder>& arrival,
                                             Recorder& recorder) {
    if (!(distance < distances_[v])) return;
    reach(v, distance, recorder);
    if constexpr (Policy::kMerges) shortfalls_[v] = 0;
    if constexpr (Recorder::kRemembers) recorder.arrived(v, arrival);
  }

  /// Starts from a point that is no vertex.
  ///
  /// Next to a corner, the lines to both sides of it are turned by the rounding of coordinates, and
  /// what lies behind the corner may be between them: the corner sends windows too, as a source
  /// does. They are as long or longer, and soon beaten. Where the point is a window's width from
  /// the corner, its own lines have no direction, and there are only the corner's.
  [[gnu::cold, gnu::noinline]] void spread(const Source& source, Index root, Recorder& recorder) {
    bool at_corner = false;
    const auto reach_corner = [&](Index h, const Point2& from, double to_apex) {
      const Index apex = mesh_.apex(h);
      begin_at(apex, source.distance + to_apex, {h, root, from}, recorder);
      const HalfEdge& e = mesh_.half_edge(h);
      if (is_next_to_apex(e, to_apex)) vertex_state_[apex] |= kSource;
      at_corner |= to_apex < kWindowWidth * e.length;
    };
    const auto cross_side = [&](Index h, const Point2& from) {
      emit_over(h, from, source.distance, root);
    };
    spread_from(mesh_, source.at, reach_corner, [](Index, const Point2&) {});
    if (at_corner) return;
    spread_from(
        mesh_, source.at, [](Index, const Point2&, double) {}, cross_side);
  }

  /// Ends a propagation that has come to `end`: the vertices that wait are farther, but windows
  /// that wait may be nearer, on long edges whose ends are not. They go on until none is left; then
  /// no path is that is shorter than `end`.
  ///
  /// All windows that wait are looked at. A list waits where no vertex of the face beyond has
  /// passed. It came through the face below, whose third vertex has passed and has reached both
  /// ends of the edge, or from a source in that face, which has: they are in the queue. It is
  /// looked at when one of them is popped, and so is what lands later, when it lands. Nothing of
  /// this depends on how long edges are.
  /// @param end at least the distance of all that is asked for
  [[gnu::cold, gnu::noinline]] void finish(double end, Recorder& recorder) {
    const auto enqueue_nearer = [&](Index h) {
      if (has_nearer(h, end)) enqueue(h);
    };
    const auto enqueue_nearer_beyond = [&](Index h) {
      mesh_.for_each_sheet(h, [&](Index g) { enqueue_nearer(mesh_.twin(g)); });
    };
    while (!front_.empty()) {
      const Index v = pop(recorder);
      if (distances_[v] <= end) enter_faces_around(v, recorder);
      for (const Index h : mesh_.outgoing(v)) {
        enqueue_nearer(h);
        enqueue_nearer(Mesh::previous(h));
        enqueue_nearer_beyond(Mesh::next(h));
      }
      for (std::size_t i = 0; i < fifo_.size(); ++i) {
        const Index h = fifo_[i];
        cross_with_list(h, recorder);
        enqueue_nearer_beyond(Mesh::previous(h));
        enqueue_nearer_beyond(Mesh::next(h));
      }
      fifo_.clear();
    }
  }

  /// True when a window nearer than `end` waits on h.
  [[gnu::cold, gnu::noinline]] bool has_nearer(Index h, double end) {
    bool nearer = false;
    lists_.for_each_segment(h, [&](const auto& segment) {
      for (std::size_t i = 0; i < segment.count && !nearer; ++i) {
        nearer = least_distance(window_of(segment, i)) <= end;
      }
    });
    return nearer;
  }

  Index pop(Recorder& recorder) {
    const auto timed = recorder.enter(Phase::queue);
    return front_.pop();
  }

  void reach(Index v, double distance, Recorder& recorder) {
    const auto timed = recorder.enter(Phase::queue);
    if constexpr (Recorder::kRecords) progress_.reach(distances_[v]);
    distances_[v] = distance;
    front_.push_or_decrease(v, distance);
  }

  bool is_entered(Index h) const {
    return ((vertex_state_[mesh_.origin(h)] | vertex_state_[mesh_.head(h)] |
             vertex_state_[mesh_.apex(h)]) &
            kPassed) != 0;
  }

  void enqueue(Index h) {
    if (lists_.empty(h) || queued_[h]) return;
    queued_[h] = 1;
    fifo_.push_back(h);
  }

  /// Starts to load what entering the faces around v reads, all at once, so that cache misses
  /// overlap.
  void prefetch_ahead(Index v) const {
    for (const Index h : mesh_.outgoing(v)) {
      const Index beyond = mesh_.twin(Mesh::next(h));
      if (beyond != kNone) prefetch(&mesh_.half_edge(beyond));
      lists_.prefetch(h - h % 3);
    }
  }

  void enter_faces_around(Index v, Recorder& recorder) {
    const bool emits = may_bend_at(v);
    vertex_state_[v] |= kPassed;
    prefetch_ahead(v);
    for (const Index h : mesh_.outgoing(v)) {
      const Index into = Mesh::previous(h);
      const double at_head = distances_[v] + mesh_.half_edge(h).length;
      if (at_head < distances_[mesh_.head(h)]) {
        if constexpr (Recorder::kRemembers) {
          const Point2 head = {mesh_.half_edge(into).length, 0};
          arrive_along_edge(mesh_.head(h), at_head, {into, v, head}, recorder);
        }
        reach(mesh_.head(h), at_head, recorder);
        if constexpr (Policy::kMerges) shortfalls_[mesh_.head(h)] = shortfalls_[v];
        if (emits && is_next_to_apex(mesh_.half_edge(into), mesh_.half_edge(h).length)) {
          vertex_state_[mesh_.head(h)] |= kSource;
        }
      }
      const double at_origin = distances_[v] + mesh_.half_edge(into).length;
      if (at_origin < distances_[mesh_.origin(into)]) {
        if constexpr (Recorder::kRemembers) {
          arrive_along_edge(mesh_.origin(into), at_origin, {h, v, {0, 0}}, recorder);
        }
        reach(mesh_.origin(into), at_origin, recorder);
        if constexpr (Policy::kMerges) shortfalls_[mesh_.origin(into)] = shortfalls_[v];
        if (emits && is_next_to_apex(mesh_.half_edge(h), mesh_.half_edge(into).length)) {
          vertex_state_[mesh_.origin(into)] |= kSource;
        }
      }
      if (emits && !is_beaten(v, h)) emit(v, Mesh::next(h));
    }
    const auto timed = recorder.enter(Phase::queue);
    for (const Index h : mesh_.outgoing(v)) {
      enqueue(h);
      enqueue(Mesh::next(h));
      enqueue(Mesh::previous(h));
    }
  }

  bool may_bend_at(Index v) const {
    return (vertex_state_[v] & kSource) != 0 || mesh_.is_pseudo_source(v);
  }

  /// Remembers that a path of this length comes along an edge. Where no path bends at the edge's
  /// other end, a window that is as short but for rounding arrives straight, and stays.
  void arrive_along_edge(Index v, double distance, const Arrival& arrival, Recorder& recorder) {
    if (may_bend_at(arrival.root) || is_shorter(distance, distances_[v], rounding_)) {
      recorder.arrived(v, arrival);
    }
  }

  /// Remembers a window that comes later, and is as short but for rounding.
  void arrive_straight(Index v, double distance, const Arrival& arrival, Recorder& recorder) {
    const Index root = recorder.record.arrival(v).root;
    const bool bends = root < mesh_.vertex_count() && !may_bend_at(root);
    if (bends && !is_shorter(distances_[v], distance, rounding_)) recorder.arrived(v, arrival);
  }

  /// True when a window from v over the opposite edge of the face of h would be dropped as soon as
  /// it is looked at, because a path along that edge is shorter (EndPaths). Distances only shrink:
  /// it is of no use later either.
  /// @param h from v
  bool is_beaten(Index v, Index h) const {
    const Index opposite = Mesh::next(h), back = Mesh::previous(h);
    const double along = mesh_.half_edge(opposite).length;
    const double to_head = distances_[v] + mesh_.half_edge(back).length;
    const double to_origin = distances_[v] + mesh_.half_edge(h).length;
    return distances_[mesh_.origin(opposite)] * (1 + kPathMargin) + along < to_head ||
           distances_[mesh_.head(opposite)] * (1 + kPathMargin) + along < to_origin;
  }

  /// Sends a window from the (pseudo-)source v over the whole of the opposite edge.
  void emit(Index v, Index opposite) {
    emit_over(opposite, apex_from_beyond(mesh_.half_edge(opposite)), distances_[v], v);
  }

  /// Sends a window over the whole of a side of a face.
  /// @param from the source in the frame of the side's twin
  HWY_INLINE void emit_over(Index side, const Point2& from, double distance, Index root) {
    const HalfEdge& e = mesh_.half_edge(side);
    if (e.twin == kNone || !(e.length > 0)) return;
    auto* segment = lists_.allocate(1);
    segment->count = 1;
    segment->array(kBegin)[0] = 0;
    segment->array(kEnd)[0] = e.length;
    segment->array(kX)[0] = from.x;
    segment->array(kY)[0] = from.y;
    segment->array(kSigma)[0] = distance;
    if constexpr (kNoted != Note::none) segment->array(kDepth)[0] = 1;
    if constexpr (kNoted == Note::root) segment->array(kRoot)[0] = root;
    if constexpr (kNoted == Note::shortfall) {
      segment->array(kShortfall)[0] = root < mesh_.vertex_count() ? double{shortfalls_[root]} : 0;
    }
    land(side, e.twin, segment, Place::back);
  }

  /// @param side through which the windows leave a face
  /// @param into its twin, on which they land
  void land(Index side, Index into, Lists::Segment* segment, Place place) {
    if (segment->count == 0) {
      lists_.release(segment);
      return;
    }
    if (crosses_sheets()) [[unlikely]] {
      land_on_other_sheets(side, *segment, place);
    }
    land_on(into, segment, place);
  }

  void land_on(Index h, Lists::Segment* segment, Place place) {
    lists_.add(h, segment, place);
    if (is_entered(h)) enqueue(h);
  }

  /// Windows that leave a face where it meets several others go on in each of them.
  [[gnu::cold, gnu::noinline]] void land_on_other_sheets(Index side, const Lists::Segment& segment,
                                                         Place place) {
    mesh_.for_each_sheet(side, [&](Index g) {
      if (g == side) return;
      auto* copy = lists_.allocate(segment.count + kLaneRoom - 1);
      copy->count = segment.count;
      for (unsigned field = 0; field < fields_with(kNoted); ++field) {
        std::copy_n(segment.array(field), segment.count, copy->array(field));
      }
      land_on(mesh_.twin(g), copy, place);
    });
  }

  void cross_with_list(Index h, Recorder& recorder) {
    queued_[h] = 0;
    if constexpr (Policy::kMerges) {
      cross_face_merged(h, recorder);
    } else {
      cross_face(h, recorder);
    }
    recorder.wavefront_size(lists_.size());
  }

  void cross_face(Index h, Recorder& recorder) {
    const HalfEdge& edge = mesh_.half_edge(h);
    const EndPaths ends(edge.length, distances_[edge.origin], distances_[mesh_.head(h)]);
    gather_and_trim(h, ends, recorder);
    if (batch_.count == 0) return;
    budget_.spend(batch_.count);
    if constexpr (Recorder::kRemembers) {
      for (std::size_t i = 0; i < batch_.count; ++i) {
        if (!batch_.is_struck_out(i)) recorder.crossing(h, batch_.window(i), root_of(i));
      }
    }

    const FaceFrame face = face_frame(mesh_, h);
    const Separator separator = classify(batch_, face, seen_left_.data(), seen_right_.data());
    const Index apex = mesh_.apex(h);
    if (separator.distance < distances_[apex]) {
      if constexpr (Recorder::kRemembers) recorder.arrived(apex, straight(h, separator));
      reach(apex, separator.distance, recorder);
    } else if constexpr (Recorder::kRemembers) {
      if (separator.window != SIZE_MAX) {
        arrive_straight(apex, separator.distance, straight(h, separator), recorder);
      }
    }
    choose_sides(separator, face, recorder);
    if constexpr (Recorder::kRecords) count(recorder);

    const Index left = mesh_.twin(Mesh::previous(h)), right = mesh_.twin(Mesh::next(h));
    if (left != kNone && separator.any_left) {
      auto* out = lists_.allocate(batch_.count + kLaneRoom - 1);
      unfold<LeftEdge, kNoted>(batch_, face, to_left_, seen_right_.data(), *out);
      land(Mesh::previous(h), left, out, Place::front);
    }
    if (right != kNone && separator.any_right) {
      auto* out = lists_.allocate(batch_.count + kLaneRoom - 1);
      unfold<RightEdge, kNoted>(batch_, face, to_right_, seen_left_.data(), *out);
      land(Mesh::next(h), right, out, Place::back);
    }
  }

  /// As cross_face, with neighbours of the list merged (merge.h).
  void cross_face_merged(Index h, Recorder& recorder) {
    const HalfEdge& edge = mesh_.half_edge(h);
    const EndPaths ends(edge.length, distances_[edge.origin], distances_[mesh_.head(h)]);
    gather_pencils(h, ends, recorder);
    if (pencils_.empty()) return;
    budget_.spend(pencils_.size());

    const FaceFrame face = face_frame(mesh_, h);
    const Index apex = mesh_.apex(h);
    double distance = kInfinity;
    const Pencil* best = pencils_.classify(face, distance);
    if (distance < distances_[apex]) {
      reach(apex, distance, recorder);
      shortfalls_[apex] = rounded_up(best->shortfall);
    }
    if (pencils_.size() > 1) pencils_.drop_crossing(face, distance, rounding_);
    if constexpr (Recorder::kRecords) {
      pencils_.for_each([&](const Pencil& pencil, bool goes_on) {
        recorder.propagated(1, {static_cast<std::uint32_t>(pencil.depth) + 1});
        if (goes_on) recorder.valid(1);
      });
    }

    const Index left = mesh_.twin(Mesh::previous(h)), right = mesh_.twin(Mesh::next(h));
    if (left != kNone) {
      auto* out = lists_.allocate(pencils_.size());
      pencils_.unfold_left(face, *out);
      land(Mesh::previous(h), left, out, Place::front);
    }
    if (right != kNone) {
      auto* out = lists_.allocate(pencils_.size());
      pencils_.unfold_right(face, *out);
      land(Mesh::next(h), right, out, Place::back);
    }
  }

  /// What is a float already stays as it is: nothing grows from vertex to vertex.
  static float rounded_up(double shortfall) {
    const auto near = static_cast<float>(shortfall);
    return near < shortfall ? std::nextafter(near, std::numeric_limits<float>::max()) : near;
  }

  /// As gather_and_trim, for windows that are merged.
  void gather_pencils(Index h, const EndPaths& ends, Recorder& recorder) {
    const auto timed = recorder.enter(Phase::trimming);
    pencils_.clear();
    lists_.consume(h, [&](auto& segment) {
      recorder.created(segment.count);
      for (std::size_t i = 0; i < segment.count; ++i) {
        const Window w = window_of(segment, i);
        const double depth = segment.array(kDepth)[i];
        const bool too_long = is_strip_too_long(mesh_, static_cast<std::uint64_t>(depth) + 1);
        if (!too_long && !ends.beat(w)) pencils_.add({w, segment.array(kShortfall)[i], depth});
      }
    });
    if (pencils_.size() > 1) pencils_.trim_and_merge(ends.length, rounding_, policy_.shortfall());
  }

  /// Moves the list of h into the batch, without what paths over the ends of h or other windows of
  /// the list beat.
  void gather_and_trim(Index h, const EndPaths& ends, Recorder& recorder) {
    const auto timed = recorder.enter(Phase::trimming);
    batch_.count = 0;
    lists_.consume(h, [&](auto& segment) {
      recorder.created(segment.count);
      gather<kNoted>(segment, ends, batch_);
    });
    reserve_masks();
    if (batch_.count > 1) trim(crossed_face(mesh_, h, rounding_));
    if constexpr (kNoted != Note::none) {
      for (std::size_t i = 0; i < batch_.count; ++i) {
        const auto depth = static_cast<std::uint64_t>(batch_.array(kDepth)[i]);
        if (is_strip_too_long(mesh_, depth + 1)) batch_.strike_out(i);
      }
    }
  }

  void reserve_masks() {
    const std::size_t groups = batch_.count / kLanes + 1;
    if (seen_left_.size() >= groups) return;
    for (auto* masks : {&seen_left_, &seen_right_, &kept_left_, &kept_right_, &suspects_}) {
      masks->resize(2 * groups);
    }
  }

  static bool bit(const std::uint8_t* masks, std::size_t i) {
    return ((masks[i / kLanes] >> (i % kLanes)) & 1) != 0;
  }
  static void clear_bit(std::uint8_t* masks, std::size_t i) {
    masks[i / kLanes] = static_cast<std::uint8_t>(masks[i / kLanes] & ~(1u << (i % kLanes)));
  }

  /// The first window from `i` on that `suspects_` marks, or the batch's count.
  std::size_t next_suspect(std::size_t i) const {
    if (i >= batch_.count) return batch_.count;
    std::size_t group = (i - 1) / kLanes;
    unsigned marks = suspects_[group] & (~0u << ((i - 1) % kLanes));
    const std::size_t groups = (batch_.count - 1 + kLanes - 1) / kLanes;
    while (marks == 0) {
      if (++group == groups) return batch_.count;
      marks = suspects_[group];
    }
    return group * kLanes + static_cast<std::size_t>(std::countr_zero(marks)) + 1;
  }

  /// Strategy I over the batch: suspicious pairs go through trim_pair, in order, and so does what
  /// follows a window that changed. What is beaten wholly is struck out (Batch::strike_out).
  void trim(const Crossed& face) {
    if (crosses_sheets()) [[unlikely]] {
      return trim_overlaps(face);
    }
    if (!find_suspects(batch_, suspects_.data())) return;
    std::size_t i = next_suspect(1);
    while (i < batch_.count) {
      const Window original = batch_.window(i);
      Window second = original;
      bool keep = true;
      for (std::size_t before = i; keep && before-- > 0;) {
        if (batch_.is_struck_out(before)) continue;
        Window first = batch_.window(before);
        trim_pair(first, second, face);
        keep = !is_void(second, face.length);
        if (!is_void(first, face.length)) {
          batch_.set_interval(before, first);
          break;
        }
        batch_.strike_out(before);
      }
      if (keep) {
        batch_.set_interval(i, second);
      } else {
        batch_.strike_out(i);
      }
      const bool changed = !keep || second.begin != original.begin || second.end != original.end;
      i = changed ? i + 1 : next_suspect(i + 1);
    }
  }

  /// Strategy I where windows of one edge may have come through different sheets: lines that cross
  /// in the unfolded picture need not do so on the surface, so that only points of the edge decide.
  [[gnu::cold, gnu::noinline]] void trim_overlaps(const Crossed& face) {
    for (std::size_t i = 1; i < batch_.count; ++i) {
      for (std::size_t before = 0; before < i && !batch_.is_struck_out(i); ++before) {
        if (batch_.is_struck_out(before)) continue;
        Window first = batch_.window(before), second = batch_.window(i);
        trim_overlap(first, second, face);
        put_back(before, first, face);
        put_back(i, second, face);
      }
    }
  }

  void put_back(std::size_t i, const Window& w, const Crossed& face) {
    if (is_void(w, face.length)) {
      batch_.strike_out(i);
    } else {
      batch_.set_interval(i, w);
    }
  }

  /// Strategy II: decides for each window to which edges it goes.
  void choose_sides(const Separator& separator, const FaceFrame& face, Recorder& recorder) {
    to_left_ = seen_left_.data();
    to_right_ = seen_right_.data();
    if (separator.window == SIZE_MAX || crosses_sheets()) return;
    const auto timed = recorder.enter(Phase::trimming);
    if (separator.rivals == 0 && !any_crosses(batch_, separator, to_left_, to_right_)) return;
    const std::size_t groups = batch_.count / kLanes + 1;
    std::copy_n(seen_left_.begin(), groups, kept_left_.begin());
    std::copy_n(seen_right_.begin(), groups, kept_right_.begin());
    const Window best = batch_.window(separator.window);
    for (std::size_t i = 0; i < batch_.count; ++i) {
      if (i == separator.window) continue;
      const bool left = bit(to_left_, i), right = bit(to_right_, i);
      if (!left && !right) continue;  // struck out
      const Side seen = left && right ? Side::both : left ? Side::left : Side::right;
      const Side side = sides_kept(batch_.window(i), seen, separator, best, face, rounding_);
      if (side == Side::none || side == Side::right) clear_bit(kept_left_.data(), i);
      if (side == Side::none || side == Side::left) clear_bit(kept_right_.data(), i);
    }
    to_left_ = kept_left_.data();
    to_right_ = kept_right_.data();
  }

  /// How the separating path arrives at the apex of h.
  Arrival straight(Index h, const Separator& separator) const {
    const Window best = batch_.window(separator.window);
    return {h, root_of(separator.window), {best.x, best.y}};
  }

  /// Of a window of the batch.
  Index root_of(std::size_t i) const { return static_cast<Index>(batch_.array(kRoot)[i]); }

  void count(Recorder& recorder) const {
    for (std::size_t i = 0; i < batch_.count; ++i) {
      if (batch_.is_struck_out(i)) continue;
      const auto depth = static_cast<std::uint32_t>(batch_.array(kDepth)[i]) + 1;
      recorder.propagated(1, {depth});
      if (bit(to_left_, i) || bit(to_right_, i)) recorder.valid(1);
    }
  }

  void sample(Recorder& recorder) {
    recorder.sample(progress_, [&](auto&& visit) {
      for (Index h = 0; h < mesh_.half_edge_count(); ++h) {
        lists_.for_each_segment(h, [&](auto& segment) {
          for (std::size_t i = 0; i < segment.count; ++i) {
            visit(h, window_of(segment, i));
          }
        });
      }
    });
  }

  const Mesh& mesh_;
  [[no_unique_address]] Policy policy_;
  std::span<double> distances_;
  std::vector<float> shortfalls_;  // of the distances, rounded up, where windows are merged
  Pencils pencils_;                // scratch of one list, where windows are merged
  Lists lists_;
  typename Policy::Queue front_;
  std::vector<std::uint8_t> vertex_state_;
  std::vector<std::uint8_t> queued_;  // half-edges in fifo_
  std::vector<Index> fifo_;
  double longest_edge_ = 0;
  double rounding_ = 0;  // of coordinates
  WindowBudget budget_;
  [[no_unique_address]] typename Recorder::Progress progress_;
  // Scratch of one list. Masks hold the bits of kLanes windows a byte.
  Batch batch_;
  std::vector<std::uint8_t> seen_left_, seen_right_, kept_left_, kept_right_, suspects_;
  const std::uint8_t* to_left_ = nullptr;
  const std::uint8_t* to_right_ = nullptr;
};

}  // namespace geodesic::edge_based::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
