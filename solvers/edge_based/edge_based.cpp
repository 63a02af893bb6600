// Edge-based wavefront propagation: the algorithm of the thesis (chapter 5), whose published
// successor is Qin, Han, Yu, Yu, Zhang 2016, "Fast and memory-efficient Voronoi diagram / window
// propagation" (VTP).
//
// The wavefront is a set of half-edges that carry lists of windows. Vertices wait in a heap by
// distance. When one is popped, the faces around it are entered: every list on their edges is
// propagated across its face as a whole, trimmed by Strategy I (trim.h) and divided by Strategy II
// (split.h). Windows that land on an edge whose next face has been entered already go on at once,
// through a FIFO; all others wait. Any order is correct, since only beaten lines are ever dropped;
// this one keeps late arrivals rare.
#include <optional>

#include "solvers/core/queues/vertex_heap.h"
#include "solvers/core/tolerance.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"
#include "solvers/edge_based/window_lists.h"
#include "solvers/registry.h"

namespace geodesic {
namespace edge_based {
namespace {

template <class Recorder>
class Propagation {
 public:
  explicit Propagation(const Mesh& mesh)
      : mesh_(mesh),
        lists_(mesh.half_edge_count()),
        front_(mesh.vertex_count()),
        vertex_state_(mesh.vertex_count()),
        queued_(mesh.half_edge_count()) {
    for (Index h = 0; h < mesh.half_edge_count(); ++h) {
      longest_edge_ = std::max(longest_edge_, mesh.half_edge(h).length);
    }
  }

  void run(const Query& query, std::span<double> distances, Recorder recorder) {
    distances_ = distances;
    std::fill(vertex_state_.begin(), vertex_state_.end(), std::uint8_t{0});
    for (const Source& source : query.sources) {
      if (source.distance < distances_[source.vertex]) reach(source.vertex, source.distance);
      vertex_state_[source.vertex] |= kSource;
    }
    // The shortest path to a vertex within the limit crosses only edges that have an end nearer
    // than the limit plus half their length.
    const double stop = query.limit + longest_edge_ / 2;
    std::uint64_t passed = 0;
    const std::uint64_t step = std::max<std::uint64_t>(1, mesh_.vertex_count() / kSamples);
    while (!front_.empty() && front_.least_key() <= stop) {
      const Index v = front_.pop();
      enter_faces_around(v);
      while (taken_ < fifo_.size()) {
        const Index h = fifo_[taken_++];
        queued_[h] = 0;
        cross_face(h, recorder);
        recorder.wavefront_size(lists_.size());
      }
      fifo_.clear();
      taken_ = 0;
      if constexpr (Recorder::records) {
        if (++passed % step == 0) sample(recorder);
      }
    }
    front_.clear();
    lists_.clear();
  }

  static constexpr std::size_t kSamples = 64;  // of the wavefront, at equal steps of passed vertices

 private:
  static constexpr std::uint8_t kPassed = 1;  // popped at least once
  static constexpr std::uint8_t kSource = 2;

  struct ListWindow : Window {
    [[no_unique_address]] typename Recorder::Depth depth;
  };

  void reach(Index v, double distance) {
    distances_[v] = distance;
    front_.push_or_decrease(v, distance);
  }

  bool is_entered(Index h) const {
    return ((vertex_state_[mesh_.origin(h)] | vertex_state_[mesh_.head(h)] |
             vertex_state_[mesh_.apex(h)]) &
            kPassed) != 0;
  }

  void enqueue(Index h) {
    if (queued_[h] || lists_.empty(h)) return;
    queued_[h] = 1;
    fifo_.push_back(h);
  }

  void enter_faces_around(Index v) {
    const bool emits = (vertex_state_[v] & kSource) != 0 || mesh_.is_pseudo_source(v);
    vertex_state_[v] |= kPassed;
    for (const Index h : mesh_.outgoing(v)) {
      const Index into = Mesh::previous(h);
      const double at_head = distances_[v] + mesh_.half_edge(h).length;
      if (at_head < distances_[mesh_.head(h)]) reach(mesh_.head(h), at_head);
      const double at_origin = distances_[v] + mesh_.half_edge(into).length;
      if (at_origin < distances_[mesh_.origin(into)]) reach(mesh_.origin(into), at_origin);
      if (emits) emit(v, Mesh::next(h));
    }
    for (const Index h : mesh_.outgoing(v)) {
      enqueue(h);
      enqueue(Mesh::next(h));
      enqueue(Mesh::previous(h));
    }
  }

  /// Sends a window from the (pseudo-)source v over the whole of the opposite edge.
  void emit(Index v, Index opposite) {
    const HalfEdge& e = mesh_.half_edge(opposite);
    if (e.twin == kNone || !(e.length > 0)) return;
    ListWindow w;
    w.begin = 0;
    w.end = e.length;
    w.x = e.length - e.apex_x;
    w.y = -e.apex_y;
    w.sigma = distances_[v];
    w.depth = typename Recorder::Depth{}.next();
    lists_.add(e.twin, std::span(&w, 1), Place::back);
    if (is_entered(e.twin)) enqueue(e.twin);
  }

  void cross_face(Index h, Recorder& recorder) {
    gather(h);
    const FaceFrame face = face_frame(mesh_, h);
    const Separator separator = find_separator(face);
    const Index apex = mesh_.apex(h);
    if (separator.distance < distances_[apex]) reach(apex, separator.distance);
    split(h, face, separator, recorder);
  }

  /// Takes the list of h and leaves what Strategy I keeps of it in `windows_`.
  void gather(Index h) {
    taken_windows_.clear();
    lists_.take(h, taken_windows_);
    windows_.clear();
    const Crossed face = crossed_face(mesh_, h);
    const double at_origin = distances_[mesh_.origin(h)], at_head = distances_[mesh_.head(h)];
    for (ListWindow& w : taken_windows_) {
      if (beaten_by_ends(w, face.length, at_origin, at_head)) continue;
      bool keep = true;
      while (keep && !windows_.empty()) {
        trim_pair(windows_.back(), w, face);
        keep = !is_void(w, face.length);
        if (!is_void(windows_.back(), face.length)) break;
        windows_.pop_back();
      }
      if (keep) windows_.push_back(w);
    }
  }

  Separator find_separator(const FaceFrame& face) {
    seen_.clear();
    Separator best;
    for (std::size_t i = 0; i < windows_.size(); ++i) {
      seen_.push_back(sides_seen(windows_[i], face));
      if (seen_.back() != Side::both) continue;
      const double d = distance_through(windows_[i], face.apex_x, face.apex_y);
      if (d < best.distance) best = {i, d, 0};
    }
    if (best.window != SIZE_MAX) best.crossing = crossing(windows_[best.window], face);
    return best;
  }

  void split(Index h, const FaceFrame& face, const Separator& separator, Recorder& recorder) {
    to_left_.clear();
    to_right_.clear();
    const Index left = mesh_.twin(Mesh::previous(h)), right = mesh_.twin(Mesh::next(h));
    for (std::size_t i = 0; i < windows_.size(); ++i) {
      const ListWindow& w = windows_[i];
      const Side side = separator.window == SIZE_MAX || i == separator.window
                            ? seen_[i]
                            : sides_kept(w, seen_[i], separator, windows_[separator.window], face);
      recorder.propagated(1, w.depth.next());
      if (side == Side::none) continue;
      recorder.valid(1);
      if (side != Side::right && left != kNone) push_left(w, seen_[i], face);
      if (side != Side::left && right != kNone) push_right(w, seen_[i], face);
    }
    land(left, to_left_, Place::front);
    land(right, to_right_, Place::back);
  }

  void push_left(const ListWindow& w, Side seen, const FaceFrame& face) {
    const Point2 source = face.to_left(w.x, w.y);
    const double end = seen == Side::left ? face.on_left(w, w.end) : face.left;
    push(to_left_, w, face.on_left(w, w.begin), end, source, face.left);
  }

  void push_right(const ListWindow& w, Side seen, const FaceFrame& face) {
    const Point2 source = face.to_right(w.x, w.y);
    const double begin = seen == Side::right ? face.on_right(w, w.begin) : 0.0;
    push(to_right_, w, begin, face.on_right(w, w.end), source, face.right);
  }

  void push(std::vector<ListWindow>& batch, const ListWindow& parent, double begin, double end,
            const Point2& source, double length) {
    ListWindow w;
    w.begin = begin;
    w.end = end;
    if (is_void(w, length)) return;
    w.x = source.x;
    w.y = std::min(source.y, 0.0);
    w.sigma = parent.sigma;
    w.depth = parent.depth.next();
    batch.push_back(w);
  }

  void land(Index h, const std::vector<ListWindow>& batch, Place place) {
    if (batch.empty()) return;
    lists_.add(h, batch, place);
    if (is_entered(h)) enqueue(h);
  }

  void sample(Recorder& recorder) {
    double sum = 0, squares = 0;
    for (Index h = 0; h < mesh_.half_edge_count(); ++h) {
      lists_.for_each_segment(h, [&](std::span<const ListWindow> part) {
        for (const ListWindow& w : part) {
          const double d = least_distance(w);
          sum += d;
          squares += d * d;
        }
      });
    }
    recorder.wavefront_sample(sum, squares, lists_.size());
  }

  const Mesh& mesh_;
  std::span<double> distances_;
  WindowLists<ListWindow> lists_;
  VertexHeap front_;
  std::vector<std::uint8_t> vertex_state_;
  std::vector<std::uint8_t> queued_;  // half-edges in fifo_
  std::vector<Index> fifo_;
  std::size_t taken_ = 0;
  double longest_edge_ = 0;
  // Scratch of one list, kept for its memory.
  std::vector<ListWindow> taken_windows_, windows_, to_left_, to_right_;
  std::vector<Side> seen_;
};

class EdgeBased final : public Solver {
 public:
  EdgeBased(const Mesh& mesh, const Description& description)
      : Solver(mesh, description), propagation_(mesh) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    if (recording == nullptr) return propagation_.run(query, distances, NoRecorder{});
    recording->window_bytes = sizeof(Window);
    Propagation<CountingRecorder>(mesh()).run(query, distances, CountingRecorder(*recording));
  }

  Propagation<NoRecorder> propagation_;
};

const RegisterSolver<EdgeBased> registered{{
    .name = "edge-based",
    .family = "edge-based",
    .paper = "thesis chapter 5; Qin, Han, Yu, Yu, Zhang 2016",
    .data_structure = "list and priority queue",
    .time_complexity = "O(n log_b n + n log n)",
    .space_complexity = "O(n)",
    .propagation = "edge",
    .spatial_order = true,
}};

}  // namespace
}  // namespace edge_based
}  // namespace geodesic
