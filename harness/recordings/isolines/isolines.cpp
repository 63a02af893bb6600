#include "harness/recordings/isolines/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "harness/recordings/isolines/arcs.h"
#include "harness/recordings/isolines/crossings.h"
#include "harness/recordings/isolines/lines.h"
#include "solvers/core/registry.h"
#include "solvers/core/tolerance.h"

namespace geodesic::harness {
namespace {

Vec3 mix(const Vec3& a, const Vec3& b, double share_of_b) {
  Vec3 p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = (1 - share_of_b) * a[k] + share_of_b * b[k];
  return p;
}

// An edge of the face that is being looked at. Positions on it are those of its own half-edge, the
// smaller of the twins, so that both faces compute the same.
struct Side {
  Index own = kNone;    // half-edge
  bool turned = false;  // whether the face is that of the twin
  EdgeDistance distance = {};
  Point2 origin = {}, direction = {};  // of the own half-edge, in the face's frame
  std::vector<Window> windows;

  Point2 at(double t) const { return origin + t * direction; }
};

class Tracer {
 public:
  Tracer(const Mesh& mesh, const FinalWindows& windows, std::span<const Source> sources,
         std::span<const double> distances)
      : mesh_(mesh),
        windows_(windows),
        distances_(distances),
        bends_(mesh.vertex_count()),
        chord_error_(kIsolineError * mesh.mean_edge_length()) {
    for (Index v = 0; v < mesh.vertex_count(); ++v) bends_[v] = mesh.is_pseudo_source(v);
    for (const Source& source : sources) bends_[mesh.numbers().own_vertex(source.at.vertex)] = true;
  }

  Isolines trace(std::span<const double> levels) {
    for (Index face = 0; face < mesh_.face_count(); ++face) {
      const auto [begin, end] = levels_in(face, levels);
      if (begin == end) continue;
      set_face(face);
      for (auto level = begin; level != end; ++level) trace_level(*level);
    }
    return std::move(result_);
  }

 private:
  using Levels = std::span<const double>;

  double distance(Index v) const { return distances_[mesh_.numbers().given_vertex(v)]; }

  // Along any path the distance changes by no more than the path's length.
  std::pair<Levels::iterator, Levels::iterator> levels_in(Index face, Levels levels) const {
    double least = kInfinity, greatest = 0, longest = 0, lowest = kInfinity;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      least = std::min(least, distance(mesh_.origin(h)));
      greatest = std::max(greatest, distance(mesh_.origin(h)));
      longest = std::max(longest, mesh_.half_edge(h).length);
      lowest = std::min(lowest, mesh_.half_edge(h).apex_y);
    }
    // A face without area shows no line.
    if (!(lowest > kFlatFace * longest) || greatest == kInfinity) {
      return {levels.end(), levels.end()};
    }
    return {std::ranges::lower_bound(levels, greatest - longest),
            std::ranges::upper_bound(levels, least + longest)};
  }

  void set_face(Index face) {
    face_ = face;
    const Index h = 3 * face;
    frame_ = face_frame(mesh_, h);
    corners_ = {{{0, 0}, {frame_.length, 0}, {frame_.apex_x, frame_.apex_y}}};
    const std::array<Point2, 3> directions = {
        {{1, 0}, {-frame_.right_x, -frame_.right_y}, {-frame_.left_x, -frame_.left_y}}};
    wedges_.clear();
    for (Index k = 0; k < 3; ++k) {
      set_side(sides_[k], h + k, corners_[k], corners_[(k + 1) % 3], directions[k]);
      add_wedges(sides_[k]);
      const Index corner = mesh_.origin(h + k);
      if (!bends_[corner]) continue;
      wedges_.push_back({.centre = corners_[k],
                         .sigma = distance(corner),
                         .first = corners_[(k + 2) % 3],
                         .last = corners_[(k + 1) % 3]});
    }
    arc_finder_.set_face(corners_, wedges_);
  }

  void set_side(Side& side, Index h, const Point2& from, const Point2& to,
                const Point2& direction) {
    side.own = std::min(h, mesh_.twin(h));
    side.turned = side.own != h;
    windows_(side.own, side.windows);
    side.distance = {.windows = side.windows,
                     .length = mesh_.half_edge(h).length,
                     .at_origin = distance(mesh_.origin(side.own)),
                     .at_head = distance(mesh_.head(side.own))};
    side.origin = side.turned ? to : from;
    side.direction = side.turned ? -1 * direction : direction;
  }

  // The rays that enter the face through a side.
  void add_wedges(const Side& side) {
    for (const Window& w : side.windows) {
      const bool enters = side.turned ? w.y > 0 : w.y < 0;
      if (!enters) continue;
      const Point2 begin = side.at(w.begin), end = side.at(w.end);
      wedges_.push_back({.centre = side.at(w.x) + w.y * left_of(side.direction),
                         .sigma = w.sigma,
                         .first = side.turned ? end : begin,
                         .last = side.turned ? begin : end});
    }
  }

  void trace_level(double level) {
    crossings_.clear();
    places_.clear();
    for (const Side& side : sides_) {
      find_crossings(side.distance, level, on_side_);
      for (const Crossing& crossing : on_side_) {
        crossings_.push_back({side.at(crossing.at), crossing.falls != side.turned});
        places_.push_back(mix(mesh_.position(mesh_.origin(side.own)),
                              mesh_.position(mesh_.head(side.own)),
                              crossing.at / side.distance.length));
      }
    }
    const bool all_beyond = crossings_.empty() && !(sides_[0].distance.at_origin < level);
    if (all_beyond) return;
    arc_finder_.find(level, arcs_);
    join_arcs(arcs_, crossings_, std::max({frame_.length, frame_.left, frame_.right}), chord_error_,
              lines_);
    for (const Line& line : lines_) add_piece(line, level);
  }

  void add_piece(const Line& line, double level) {
    const std::size_t first = result_.points.size();
    for (const LinePoint& p : line) {
      result_.points.push_back(p.crossing == kNone ? in_space(p.at) : places_[p.crossing]);
    }
    // An isoline through a corner touches the faces beyond.
    const bool is_point = line.size() == 2 && result_.points[first] == result_.points.back();
    if (is_point) {
      result_.points.resize(first);
    } else {
      result_.pieces.push_back({mesh_.numbers().given_face(face_), level, first});
    }
  }

  // A point of the face's plane.
  Vec3 in_space(const Point2& p) const {
    const Triangle corners = mesh_.triangle(face_);
    const double of_apex = p.y / frame_.apex_y;
    const double of_head = (p.x - of_apex * frame_.apex_x) / frame_.length;
    Vec3 sum;
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] = (1 - of_head - of_apex) * mesh_.position(corners[0])[k] +
               of_head * mesh_.position(corners[1])[k] + of_apex * mesh_.position(corners[2])[k];
    }
    return sum;
  }

  const Mesh& mesh_;
  const FinalWindows& windows_;
  std::span<const double> distances_;
  std::vector<bool> bends_;  // by vertex: paths may come from it in any direction
  double chord_error_;
  Isolines result_;

  // Of one face:
  Index face_ = kNone;
  FaceFrame frame_ = {};
  std::array<Point2, 3> corners_ = {};
  std::array<Side, 3> sides_;
  std::vector<Wedge> wedges_;
  ArcFinder arc_finder_;

  // Of one level in it:
  std::vector<Crossing> on_side_;
  std::vector<BorderCrossing> crossings_;
  std::vector<Vec3> places_;  // of the crossings in space
  std::vector<Arc> arcs_;
  std::vector<Line> lines_;
};

}  // namespace

std::vector<double> isoline_levels(std::span<const double> distances,
                                   std::span<const double> shares) {
  std::vector<double> finite;
  std::ranges::copy_if(distances, std::back_inserter(finite),
                       [](double d) { return d < kInfinity; });
  std::ranges::sort(finite);
  if (finite.size() < 2 || !(finite.back() > 0)) return {};

  std::vector<double> levels;
  for (int k = 1; k < kIsolineSteps; ++k) levels.push_back(finite.back() * k / kIsolineSteps);
  for (const double share : shares) {
    const double count = std::ceil(share * static_cast<double>(finite.size()));
    const std::size_t next = std::min(static_cast<std::size_t>(count), finite.size() - 1);
    const double between = (finite[next - 1] + finite[next]) / 2;
    if (between > 0) levels.push_back(between);
  }
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

Isolines trace_isolines(const Mesh& mesh, const FinalWindows& windows,
                        std::span<const Source> sources, std::span<const double> distances,
                        std::span<const double> levels) {
  return Tracer(mesh, windows, sources, distances).trace(levels);
}

Isolines solve_isolines(const std::string& solver, const Mesh& mesh, const Query& query,
                        std::span<const double> levels, std::span<double> distances) {
  const std::vector<double> known(distances.begin(), distances.end());
  Isolines isolines;
  const ReadWindows read = [&](const FinalWindows& windows) {
    isolines = trace_isolines(mesh, windows, query.sources, known, levels);
  };
  Recording recording;
  recording.what = Record::windows;
  recording.read_windows = &read;
  make_solver(solver, mesh)->solve(query, distances, &recording);
  return isolines;
}

}  // namespace geodesic::harness
