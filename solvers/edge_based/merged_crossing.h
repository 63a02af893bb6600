// The crossing of the approximate solver: takes the few windows that are left on an edge after
// neighbours are merged (merged_lists.h), one or two on average, across a face. Comparisons at
// points of the edge and of the face beyond decide how they trim each other.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "solvers/core/recorders.h"
#include "solvers/core/window_bound.h"
#include "solvers/edge_based/merged_lists.h"
#include "solvers/edge_based/split.h"
#include "solvers/edge_based/trim.h"

namespace geodesic::edge_based {

/// Implements a Crossing (wavefront.h).
class MergedCrossing {
 public:
  /// @param tolerance largest relative error of distances
  MergedCrossing(const Mesh& mesh, double tolerance)
      : mesh_(mesh),
        tolerance_(tolerance),
        parameters_(tolerance >= kCoarse ? kForCoarse : kForFine),
        rounding_(coordinate_rounding(mesh)),
        lists_(mesh,
               {parameters_.room * tolerance * (1 - kShortfallRounding), parameters_.share_of_rest},
               rounding_),
        budget_(mesh) {}

  void start(std::span<double> distances) {
    distances_ = distances;
    lists_.start(distances);
    budget_.start();
  }
  void follow_edge(Index from, Index to) {
    lists_.shortfalls().set(to, lists_.shortfalls().of(from));
  }
  double rounding() const { return rounding_; }
  std::uint64_t window_count() const { return lists_.window_count(); }

  /// The truth lies from D to D + s, and s is at most room * tolerance * D with room at most 2: the
  /// result differs from it by at most tolerance * D in either direction.
  void finish() {
    for (Index v = 0; v < distances_.size(); ++v) {
      const double s = lists_.shortfalls().of(v);
      if (s > 0) distances_[v] += std::max(parameters_.given * s, s - tolerance_ * distances_[v]);
    }
  }

  template <class Visit>
  void for_each_window(Index h, const Visit& visit) const {
    lists_.for_each_window(h, visit);
  }

  template <class Wavefront>
  void emit(Index side, const Point2& from, double distance, Index root, Wavefront& wavefront) {
    const HalfEdge& e = mesh_.half_edge(side);
    if (e.twin == kNone || !(e.length > 0)) return;
    const float missing = root < mesh_.vertex_count() ? lists_.shortfalls().of(root) : 0;
    land(side, {0, e.length, from.x, from.y, distance}, missing, {1, true, 0}, wavefront);
  }

  template <class Wavefront>
  void emit_from_apex(bool wanted, Index side, Wavefront& wavefront) {
    const HalfEdge& e = mesh_.half_edge(side);
    if (e.twin == kNone || !(e.length > 0)) return;
    if (mesh_.crosses_non_manifold_edges()) [[unlikely]] {
      const Index v = mesh_.apex(side);
      if (wanted) emit(side, apex_from_beyond(e), distances_[v], v, wavefront);
      return;
    }
    lists_.send(e.twin, wanted);
    wavefront.land(e.twin, wanted);
  }

  template <class Wavefront>
  void cross(Index h, Wavefront& wavefront) {
    auto& recorder = wavefront.recorder();
    const HalfEdge& edge = mesh_.half_edge(h);
    const EndpointBounds bounds(edge.length, distances_[edge.origin], distances_[mesh_.head(h)]);
    if (Line line; lists_.take_only(h, line)) {
      recorder.created(1);
      if (!lists_.is_useless(line.merged.window, line.strip, bounds)) {
        cross_alone(h, line, wavefront);
      }
      return;
    }
    lists_.gather(h, bounds, recorder);
    Stack<Line>& lines = lists_.lines();
    if (lines.size() == 1) {
      cross_alone(h, lines.back(), wavefront);
    } else if (!lines.empty()) {
      cross_together(h, lines, wavefront);
    }
  }

 private:
  /// Use of the tolerance; values measured on scans and terrain.
  struct Parameters {
    double room;           ///< greatest shortfall divided by the tolerance, at most 2
    double given;          ///< share of a vertex's shortfall that is added to its distance
    double share_of_rest;  ///< MergeRule::share
  };
  static constexpr double kCoarse = 3e-3;
  static constexpr Parameters kForCoarse = {1.4, 0.2, 0.2}, kForFine = {2, 0.3, 0.3};

  /// Finds the sides on which the lines of a window pass the apex, and the path to the apex.
  static void find_sides(Line& line, const FaceFrame& face) {
    const Window& w = line.merged.window;
    const WindowSight sight(w, {face.apex_x, face.apex_y});
    line.seen = sight.sides();
    line.to_apex = sight.reaches() ? distance_to_apex(w, line.seen, face) : kInfinity;
  }

  /// One window crosses a face: as cross_together, without the comparison of windows.
  template <class Wavefront>
  void cross_alone(Index h, Line& line, Wavefront& wavefront) {
    budget_.spend(1);
    const FaceFrame face = face_frame(mesh_, h);
    find_sides(line, face);
    count(line, wavefront.recorder());
    const Index left = Mesh::previous(h), right = Mesh::next(h);
    reach_apex(h, line, wavefront);
    if (line.seen.left && mesh_.twin(left) != kNone) go_left(left, face, line, false, wavefront);
    if (line.seen.right && mesh_.twin(right) != kNone) {
      go_right(right, face, line, false, wavefront);
    }
  }

  /// The windows of a list cross a face; drops those that cross the shortest path to the apex.
  template <class Wavefront>
  [[gnu::noinline]] void cross_together(Index h, Stack<Line>& lines, Wavefront& wavefront) {
    budget_.spend(lines.size());
    const FaceFrame face = face_frame(mesh_, h);
    const Line* best = nullptr;  // with the shortest path to the apex
    for (Line& line : lines) {
      find_sides(line, face);
      if (line.to_apex < (best == nullptr ? kInfinity : best->to_apex)) best = &line;
    }
    if (best != nullptr) {
      reach_apex(h, *best, wavefront);
      drop_crossing(lines, *best, face);
    }
    for (const Line& line : lines) count(line, wavefront.recorder());
    const Index left = Mesh::previous(h), right = Mesh::next(h);
    if (mesh_.twin(left) != kNone) {
      for (std::size_t i = lines.size(); i-- > 0;) {  // the last one must come first
        if (!lines[i].seen.left) continue;
        go_left(left, face, lines[i], i > 0 && lines[i - 1].seen.left, wavefront);
      }
    }
    if (mesh_.twin(right) != kNone) {
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!lines[i].seen.right) continue;
        go_right(right, face, lines[i], i > 0 && lines[i - 1].seen.right, wavefront);
      }
    }
  }

  template <class Wavefront>
  void reach_apex(Index h, const Line& line, Wavefront& wavefront) {
    const Index apex = mesh_.apex(h);
    if (!(line.to_apex < distances_[apex])) return;
    wavefront.set_distance(apex, line.to_apex);
    lists_.shortfalls().set(apex, line.merged.shortfall);
  }

  template <class Recorder>
  static void count(const Line& line, Recorder& recorder) {
    recorder.propagated(1, StripDepth{std::uint32_t{line.strip.depth} + 1});
    recorder.valid(line.seen.left || line.seen.right);
  }

  /// Drops lines that cross the shortest path to the apex.
  void drop_crossing(Stack<Line>& lines, const Line& best, const FaceFrame& face) const {
    const double position = apex_line_in(best.merged.window, face);
    for (Line& line : lines) {
      const Window& w = line.merged.window;
      const Sides kept = sides_not_crossing(line.seen, w.begin, w.end, position);
      if (&line == &best || kept == line.seen) continue;
      if (is_shorter(best.to_apex, distance_to_apex(w, line.seen, face), rounding_)) {
        line.seen = kept;
      }
    }
  }

  /// The ends of an edge are visible as such if neither the source nor the apex lies on it.
  static bool sees_ends(const Window& w, const FaceFrame& face) {
    return std::max(w.y, -face.apex_y) < -kFlatFace * face.length;
  }

  /// @param behind_another the line before it goes there, too
  template <class Wavefront>
  [[gnu::always_inline]] void go_left(Index side, const FaceFrame& face, const Line& line,
                                      bool behind_another, Wavefront& wavefront) {
    const Window& w = line.merged.window;
    const Point2 from = face.to_left(w.x, w.y);
    const double begin = w.begin > 0 || !sees_ends(w, face) ? face.on_left(w, w.begin) : 0;
    const double end = line.seen.right ? face.left : face.on_left(w, w.end);
    const Window child = {begin, end, from.x, std::min(from.y, 0.0), w.sigma};
    if (is_void(child, face.left)) return;
    land(side, child, line.merged.shortfall, strip_of(line, behind_another, false), wavefront);
  }

  template <class Wavefront>
  [[gnu::always_inline]] void go_right(Index side, const FaceFrame& face, const Line& line,
                                       bool behind_another, Wavefront& wavefront) {
    const Window& w = line.merged.window;
    const Point2 from = face.to_right(w.x, w.y);
    const double begin = line.seen.left ? 0 : face.on_right(w, w.begin);
    const bool to_head = w.end >= face.length && sees_ends(w, face);
    const double end = to_head ? face.right : face.on_right(w, w.end);
    const Window child = {begin, end, from.x, std::min(from.y, 0.0), w.sigma};
    if (is_void(child, face.right)) return;
    land(side, child, line.merged.shortfall, strip_of(line, behind_another, true), wavefront);
  }

  static Strip strip_of(const Line& line, bool behind_another, bool from_right) {
    const std::uint32_t apart = line.strip.apart;
    return {(line.strip.depth + 1) & kMostDepth, from_right,
            behind_another && apart > 0 ? (apart - 1) & kApart : 0};
  }

  /// @param side the half-edge through which the window leaves a face
  template <class Wavefront>
  [[gnu::always_inline]] void land(Index side, Window w, float shortfall, Strip strip,
                                   Wavefront& wavefront) {
    if (mesh_.crosses_non_manifold_edges()) [[unlikely]] {
      return land_on_sheets(side, w, shortfall, strip, wavefront);
    }
    put(mesh_.twin(side), w, shortfall, strip, wavefront);
  }

  template <class Wavefront>
  [[gnu::cold, gnu::noinline]] void land_on_sheets(Index side, Window w, float shortfall,
                                                   Strip strip, Wavefront& wavefront) {
    mesh_.for_each_sheet(side,
                         [&](Index g) { put(mesh_.twin(g), w, shortfall, strip, wavefront); });
  }

  template <class Wavefront>
  [[gnu::always_inline]] void put(Index h, Window w, float shortfall, Strip strip,
                                  Wavefront& wavefront) {
    lists_.put(h, w, shortfall, strip);
    wavefront.land(h);
  }

  const Mesh& mesh_;
  double tolerance_;
  Parameters parameters_;
  double rounding_;  // of coordinates
  std::span<double> distances_;
  MergedLists lists_;
  WindowBudget budget_;
};

}  // namespace geodesic::edge_based
