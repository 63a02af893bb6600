#include "solvers/edge_based/parallel/regional_wavefront.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <utility>

#include "solvers/core/recorders.h"
#include "solvers/core/thread_team.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/edge_based.h"
#include "solvers/edge_based/list_crossing.h"
#include "solvers/edge_based/wavefront.h"

namespace geodesic::edge_based {

namespace {

/// Distance from the least waiting key to a step's threshold, in mean edge lengths.
constexpr double kStep = 0.5;

/// The messages of one region to another in a step.
struct Mail {
  struct Distance {
    Index vertex;  // of the receiver
    double distance;
    bool always_emits;
  };
  struct Windows {
    Index half_edge;  // of the receiver
    Place place;
    std::uint32_t count;
  };
  std::vector<Distance> distances;
  std::vector<Windows> windows;
  std::vector<double> numbers;  // of the windows: begins, ends and so on, list by list

  bool empty() const { return distances.empty() && windows.empty(); }
  void clear() {
    distances.clear();
    windows.clear();
    numbers.clear();
  }
  /// @param fields number of fields of a window
  void add(Index half_edge, const Segment& segment, unsigned fields) {
    windows.push_back({half_edge, segment.place, segment.count});
    for (unsigned f = 0; f < fields; ++f) {
      numbers.insert(numbers.end(), segment.array(f), segment.array(f) + segment.count);
    }
  }
};

}  // namespace

/// Selects the regions that have a turn. Data that is read of all regions between steps is stored
/// here and not in the regions.
class RegionalWavefront::Steps {
 public:
  /// @param width of a step
  Steps(std::size_t regions, double width) : width_(width), boards_(regions) {}

  /// The state that a region publishes.
  struct Board {
    double least_key = kInfinity;      ///< of its queue
    double least_sent = kInfinity;     ///< least distance sent in its last turn
    std::uint64_t cost = 0;            ///< windows that crossed faces in its last turn
    std::atomic<unsigned> thread = 0;  ///< the thread of its last turn
    std::array<std::atomic<bool>, 2> has_mail = {};  ///< of even and odd steps
  };
  Board& operator[](std::size_t region) { return boards_[region]; }

  /// Regions that have a turn in this step.
  std::span<const Index> due() const { return due_; }
  double threshold() const { return threshold_; }
  /// Index of the step's outgoing mail. The mail of the step before has the other index.
  unsigned parity() const { return parity_; }

  /// Goes on to the next step. After the last step no region is due.
  void plan() {
    double least = kInfinity;
    for (const Board& board : boards_) {
      least = std::min({least, board.least_key, board.least_sent});
    }
    threshold_ = least + width_;
    parity_ ^= 1;
    due_.clear();
    for (Index r = 0; r < boards_.size(); ++r) {
      Board& board = boards_[r];
      board.least_sent = kInfinity;
      std::atomic<bool>& has_mail = board.has_mail[parity_ ^ 1];
      const bool is_asked = has_mail.load(std::memory_order_relaxed);
      has_mail.store(false, std::memory_order_relaxed);
      if (is_asked || (least < kInfinity && board.least_key <= threshold_)) due_.push_back(r);
    }
    // Expensive regions go first, so that no thread works alone at the end.
    std::ranges::stable_sort(due_, std::ranges::greater{},
                             [&](Index r) { return boards_[r].cost; });
  }

 private:
  double width_;
  std::vector<Board> boards_;
  std::vector<Index> due_;
  double threshold_ = 0;
  unsigned parity_ = 0;
};

class RegionalWavefront::RegionAtWork {
 public:
  RegionAtWork(const Region& region, InstructionSet set, Carried carried, double rounding,
               const WindowBudget& budget, Steps& steps)
      : region_(region),
        steps_(steps),
        fields_(fields_with(carried)),
        wavefront_(region.mesh, ByDistance::make_queue(region.mesh),
                   ListCrossing(region.mesh, set, carried, rounding, budget), NoRecorder()),
        distances_(region.mesh.vertex_count()),
        known_(region.vertices.size() - region.first_shared),
        mail_(region.neighbours.size()) {}

  /// Finds the mail for this region.
  /// @param own its number; @param all regions by number
  void open_boxes(Index own, std::span<const std::unique_ptr<RegionAtWork>> all) {
    for (const Index r : region_.neighbours) boxes_.push_back(&all[r]->mail_for(own));
  }

  void start(Steps::Board& board) {
    std::ranges::fill(distances_, kInfinity);
    std::ranges::fill(known_, kInfinity);
    for (auto& both : mail_) {
      for (Mail& mail : both) mail.clear();
    }
    wavefront_.forget(distances_);
    board.least_key = board.least_sent = kInfinity;
    board.cost = 0;
    for (auto& has_mail : board.has_mail) has_mail.store(false, std::memory_order_relaxed);
  }

  auto& wavefront() { return wavefront_; }
  double least_key() { return wavefront_.is_empty() ? kInfinity : wavefront_.first_key(); }

  void take_turn(Steps::Board& board) {
    const std::uint64_t before = wavefront_.crossing().budget().spent();
    receive();
    wavefront_.cross_entered_faces();
    while (!wavefront_.is_empty() && least_key() <= steps_.threshold()) wavefront_.advance();
    board.least_sent = send_distances();
    send_windows();
    board.least_key = least_key();
    board.cost = wavefront_.crossing().budget().spent() - before;
    // Most regions contain no window most of the time.
    WindowLists& lists = wavefront_.crossing().lists();
    if (lists.window_count() == 0) lists.release_memory();
  }

  /// @param has_first_copy whether the region has the first copy of a vertex
  template <class HasFirstCopy>
  void hand_over(std::span<double> distances, const HasFirstCopy& has_first_copy) const {
    for (Index i = 0; i < distances_.size(); ++i) {
      const Index v = region_.vertices[i];
      if (i < region_.first_shared || has_first_copy(v)) distances[v] = distances_[i];
    }
  }

 private:
  using BothMails = std::array<Mail, 2>;  // of even and odd steps

  BothMails& mail_for(Index region) {
    const auto at = std::ranges::lower_bound(region_.neighbours, region);
    return mail_[static_cast<std::size_t>(at - region_.neighbours.begin())];
  }

  Mail& mail_of_step(Index region) {
    steps_[region].has_mail[steps_.parity()].store(true, std::memory_order_relaxed);
    return mail_for(region)[steps_.parity()];
  }

  void receive() {
    for (BothMails* const box : boxes_) {
      Mail& mail = (*box)[steps_.parity() ^ 1];
      if (mail.empty()) continue;
      for (const Mail::Distance& news : mail.distances) {
        if (!(news.distance < distances_[news.vertex])) continue;
        known_[news.vertex - region_.first_shared] = news.distance;
        wavefront_.set_distance(news.vertex, news.distance);
        if (news.always_emits) wavefront_.set_always_emits(news.vertex);
      }
      const double* numbers = mail.numbers.data();
      WindowLists& lists = wavefront_.crossing().lists();
      for (const Mail::Windows& windows : mail.windows) {
        Segment* segment = lists.allocate(windows.count);
        segment->count = windows.count;
        for (unsigned f = 0; f < fields_; ++f, numbers += windows.count) {
          std::copy_n(numbers, windows.count, segment->array(f));
        }
        lists.add(windows.half_edge, segment, windows.place);
        wavefront_.land(windows.half_edge);
      }
      mail.clear();
    }
  }

  /// @return the least distance sent
  double send_distances() {
    double least = kInfinity;
    for (Index i = 0; i < known_.size(); ++i) {
      const Index v = region_.first_shared + i;
      if (!(distances_[v] < known_[i])) continue;
      known_[i] = distances_[v];
      least = std::min(least, distances_[v]);
      for (Index k = region_.first_copy[i]; k < region_.first_copy[i + 1]; ++k) {
        const InRegion& copy = region_.copies[k];
        mail_of_step(copy.region)
            .distances.push_back({copy.number, distances_[v], wavefront_.always_emits(v)});
      }
    }
    return least;
  }

  void send_windows() {
    WindowLists& lists = wavefront_.crossing().lists();
    const Index first = region_.first_portal_face;
    wavefront_.take_landings(first, [&](Index portal) {
      const InRegion& beyond = region_.beyond[portal - 3 * first];
      Mail& mail = mail_of_step(beyond.region);
      landed_.clear();
      lists.for_each_segment(portal, [&](const Segment& segment) { landed_.push_back(&segment); });
      // Segments at the front go in reverse: the receiver, whose list may hold windows, restores
      // the order.
      std::reverse(landed_.begin(), std::ranges::find(landed_, Place::back, &Segment::place));
      for (const Segment* segment : landed_) mail.add(beyond.number, *segment, fields_);
      lists.consume(portal, [](const Segment&) {});
    });
  }

  const Region& region_;
  Steps& steps_;
  unsigned fields_;  // of a window
  Wavefront<ListCrossing, ByDistance::Queue, NoRecorder> wavefront_;
  std::vector<double> distances_;
  std::vector<double> known_;           // distance of each shared vertex that all copies know
  std::vector<BothMails> mail_;         // to each neighbour
  std::vector<BothMails*> boxes_;       // from each neighbour
  std::vector<const Segment*> landed_;  // scratch
};

RegionalWavefront::RegionalWavefront(const Mesh& mesh, InstructionSet set, unsigned threads,
                                     Index region_size)
    : mesh_(mesh), regions_(mesh, region_size, threads), threads_(threads) {
  const double rounding = coordinate_rounding(mesh);
  const WindowBudget budget(mesh);
  steps_ = std::make_unique<Steps>(regions_.size(), kStep * mesh.mean_edge_length());
  at_work_.resize(regions_.size());
  ThreadTeam::run(threads, regions_.size(), [&](ThreadTeam& team, unsigned thread) {
    team.share(
        thread, regions_.size(), team.in_equal_parts(regions_.size()),
        [&](std::size_t r) {
          at_work_[r] = std::make_unique<RegionAtWork>(regions_[r], set, carried_on(mesh), rounding,
                                                       budget, *steps_);
        },
        [] {});
  });
  for (Index r = 0; r < regions_.size(); ++r) at_work_[r]->open_boxes(r, at_work_);
}

RegionalWavefront::~RegionalWavefront() = default;

void RegionalWavefront::run(const Start& start, std::span<double> distances, TurnTimes* times) {
  using Clock = std::chrono::steady_clock;
  Steps& steps = *steps_;
  const auto plan = [&] {
    steps.plan();
    if (times != nullptr) times->emplace_back();
  };
  const auto begin_all = [&] {
    begin(start);
    for (Index r = 0; r < regions_.size(); ++r) steps[r].least_key = at_work_[r]->least_key();
    plan();
  };
  const auto take_turn = [&](Index r, unsigned thread) {
    steps[r].thread.store(thread, std::memory_order_relaxed);
    const auto before = times != nullptr ? Clock::now() : Clock::time_point();
    at_work_[r]->take_turn(steps[r]);
    if (times != nullptr) {
      times->back().push_back(std::chrono::duration<double>(Clock::now() - before).count());
    }
  };
  const auto hand_over = [&](std::size_t r) {
    at_work_[r]->hand_over(distances, [&](Index v) { return regions_.first_copy(v).region == r; });
  };
  const auto last_thread = [&](Index r) { return steps[r].thread.load(std::memory_order_relaxed); };
  ThreadTeam::run(threads_, regions_.size(), [&](ThreadTeam& team, unsigned thread) {
    team.share(
        thread, regions_.size(), team.in_equal_parts(regions_.size()),
        [&](std::size_t r) { at_work_[r]->start(steps[r]); }, begin_all);
    while (!steps.due().empty() && !team.has_stopped()) {
      const std::span<const Index> due = steps.due();
      team.share(
          thread, due.size(), [&](std::size_t i) { return last_thread(due[i]); },
          [&](std::size_t i) { take_turn(due[i], thread); }, plan);
    }
    team.share(thread, regions_.size(), team.in_equal_parts(regions_.size()), hand_over, [] {});
  });
}

void RegionalWavefront::begin(const Start& start) {
  for (StartVertex each : start.vertices) {
    regions_.for_each_copy(each.vertex, [&](const InRegion& copy) {
      each.vertex = copy.number;
      at_work_[copy.region]->wavefront().begin_at(each);
    });
  }
  for (StartWindow each : start.windows) {
    const InRegion face = regions_.face(each.side / 3);
    each.side = 3 * face.number + each.side % 3;
    at_work_[face.region]->wavefront().begin_across(each);
  }
}

}  // namespace geodesic::edge_based
