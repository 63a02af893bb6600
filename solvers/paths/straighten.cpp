#include "solvers/paths/straighten.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "solvers/core/tolerance.h"
#include "solvers/paths/funnel.h"
#include "solvers/paths/path_points.h"

namespace geodesic {
namespace {

constexpr double kPi = std::numbers::pi;

/// Rounds for each crossing of the sleeve that may leave the length as it is, up to rounding. Each
/// passes at least one vertex, and a vertex that the line only touches is passed once.
constexpr std::size_t kIdleRounds = 10;

/// Whether an angle at a bend is so small that the line becomes shorter on that side.
bool is_below_pi(double angle, const Bend& bend, double length) {
  const double by = kPi - angle, off = by * std::min(bend.before, bend.behind);
  return by > kStraightenAngle &&
         off > kStraightenOffset * (bend.before + bend.behind) + kStraightenRounding * length;
}

/// Whether the line becomes shorter, by more than this, on the other side of the vertex.
bool is_to_pass(const Mesh& mesh, const Bend& bend, double length, double least_saving) {
  if (!is_passable(mesh, bend.vertex)) return false;
  const double outside = mesh.total_angle(bend.vertex) - bend.inside;
  // By the line between two points that are equally far from the vertex.
  const double half_chord = std::sin(std::max(outside, 0.0) / 2);
  const double saving = 2 * std::min(bend.before, bend.behind) * (1 - half_chord);
  return is_below_pi(outside, bend, length) && saving >= least_saving;
}

/// Leads a sleeve round the other side of vertices.
/// @param bends whose crossings are in order; those that share crossings with others stay
void pass(const Mesh& mesh, Crossings& crossings, const std::vector<Bend>& bends) {
  Crossings changed;
  std::size_t kept_to = 0;
  const auto keep_to = [&](std::size_t end) {
    for (; kept_to < end; ++kept_to) changed.push_back(crossings[kept_to]);
  };
  for (const Bend& bend : bends) {
    if (bend.first < kept_to) continue;
    keep_to(bend.first);
    const std::span run(crossings.begin() + static_cast<std::ptrdiff_t>(bend.first),
                        crossings.begin() + static_cast<std::ptrdiff_t>(bend.end));
    const Crossings other = round_other_side(mesh, run, bend.left);
    changed.insert(changed.end(), other.begin(), other.end());
    kept_to = bend.end;
  }
  keep_to(crossings.size());
  crossings = std::move(changed);
}

/// Adds the points where a straight line crosses edges of the sleeve.
class LineTracer {
 public:
  LineTracer(const Mesh& mesh, const Crossings& crossings, const std::vector<Gate>& gates)
      : mesh_(mesh), crossings_(crossings), gates_(gates), points_(mesh) {}

  void begin(const Point2& at, const InternalPoint& point) {
    points_.add(point, kNone, 0);
    last_ = at;
  }
  void begin_on(std::size_t crossing, const Point2& from, const Point2& to) {
    cross(crossing, from, to, true);
  }
  /// Crosses edges up to one of them.
  void cross_to(std::size_t end, const Point2& from, const Point2& to) {
    for (; next_ < end; ++next_) cross(next_, from, to, false);
  }
  /// @param face the one that the line came through
  void arrive(const Point2& at, const InternalPoint& point, Index face) {
    points_.add(point, face, length_between(last_, at));
    last_ = at;
  }
  void skip_to(std::size_t crossing) { next_ = std::max(next_, crossing); }

  Path path() { return {.source = 0, .points = points_.from_begin()}; }

 private:
  void cross(std::size_t i, const Point2& from, const Point2& to, bool is_begin) {
    const Gate& gate = gates_[i];
    const double left = std::max(turn(from, to, gate.left), 0.0);
    const double right = std::max(-turn(from, to, gate.right), 0.0);
    const double share = left + right > 0 ? left / (left + right) : 0.5;  // from the left end
    const Point2 at = {gate.left.x + share * (gate.right.x - gate.left.x),
                       gate.left.y + share * (gate.right.y - gate.left.y)};
    const double step = is_begin ? 0 : length_between(last_, at);
    points_.add_edge_point(crossings_[i], share * mesh_.half_edge(crossings_[i]).length, step);
    last_ = at;
  }

  const Mesh& mesh_;
  const Crossings& crossings_;
  const std::vector<Gate>& gates_;
  PathPoints points_;
  Point2 last_ = {0, 0};
  std::size_t next_ = 0;  ///< crossing
};

Path trace(const Mesh& mesh, const Sleeve& sleeve, const SleeveLine& line) {
  LineTracer tracer(mesh, sleeve.crossings, line.gates);
  const auto face_before = [&](std::size_t crossing) {
    if (crossing < sleeve.crossings.size()) return sleeve.crossings[crossing] / 3;
    return crossing == 0 ? sleeve.face : mesh.twin(sleeve.crossings[crossing - 1]) / 3;
  };
  tracer.begin(line.begin, sleeve.begin);
  Point2 from = line.begin;
  for (const Bend& bend : line.bends) {
    tracer.cross_to(bend.first, from, bend.at);
    tracer.arrive(bend.at, InternalPoint(bend.vertex), face_before(bend.first));
    tracer.skip_to(bend.end);
    from = bend.at;
  }
  tracer.cross_to(sleeve.crossings.size(), from, line.end);
  tracer.arrive(line.end, sleeve.end, face_before(sleeve.crossings.size()));
  return tracer.path();
}

/// Checks that rounds have an end. Among needles, rounding may move a line over a vertex and back.
class Rounds {
 public:
  /// @return how much a further round must save
  double count(double length, const Crossings& crossings) {
    const std::size_t most = kIdleRounds * (crossings.size() + 10);
    if (length < least_ * (1 - kStraightenRounding)) {
      least_ = length;
      idle_ = 0;
    } else if (++idle_ > 2 * most) {
      throw std::runtime_error("the straightened curve has no end; please report this mesh");
    }
    return idle_ > most ? 2 * kStraightenRounding * length : 0;
  }

 private:
  double least_ = kInfinity;
  std::size_t idle_ = 0;
};

/// Moves a sleeve to that of a locally shortest line between its ends.
void straighten(const Mesh& mesh, Sleeve& sleeve) {
  for (Rounds rounds;;) {
    trim(mesh, sleeve);
    SleeveLine line = shortest_line(mesh, sleeve);
    const double least_saving = rounds.count(line.length, sleeve.crossings);
    std::erase_if(line.bends, [&](const Bend& bend) {
      return !is_to_pass(mesh, bend, line.length, least_saving);
    });
    if (line.bends.empty()) return;
    pass(mesh, sleeve.crossings, line.bends);
  }
}

/// The shortest closed line in a closed sleeve.
class Loop {
 public:
  Loop(const Mesh& mesh, const Crossings& crossings) : mesh_(mesh), crossings_(crossings) {
    lay_out_once();
  }

  /// The line without a bend, if there is one.
  std::optional<Path> straight_line() const {
    const Point2 along = {copy_.right.x - gates_[0].right.x, copy_.right.y - gates_[0].right.y};
    const double length = norm(along);
    if (std::abs(turned_) > kStraightSleeve || length == 0) return std::nullopt;
    const auto across = [&](const Point2& p) { return (along.x * p.y - along.y * p.x) / length; };
    double low = -kInfinity, high = kInfinity;  // where all edges are crossed
    for (const Gate& gate : gates_) {
      low = std::max(low, across(gate.right));
      high = std::min(high, across(gate.left));
    }
    if (!(high - low > kStraightenOffset * length)) return std::nullopt;
    const double middle = low + (high - low) / 2;
    const Point2 from = {-along.y / length * middle, along.x / length * middle};
    const Point2 to = {from.x + along.x, from.y + along.y};
    Crossings once = crossings_;
    once.push_back(once.front());
    std::vector<Gate> gates = gates_;
    gates.push_back(copy_);
    LineTracer tracer(mesh_, once, gates);
    tracer.begin_on(0, from, to);
    tracer.skip_to(1);
    tracer.cross_to(once.size(), from, to);
    Path path = tracer.path();
    path.points.back().at = path.points.front().at;  // the same up to rounding
    path.points.back().position = path.points.front().position;
    return path;
  }

  /// Finds the shortest line, which has a bend: the loop through a vertex, then that through a bend
  /// of this loop, which is no longer, until the vertex is a bend too.
  void find_bends() {
    std::set<std::pair<Index, std::size_t>> seen;
    for (anchor_ = run_of(0, true); seen.emplace(anchor_.vertex, anchor_.first).second;) {
      open();
      const bool bends = !is_below_pi(anchor_.inside, anchor_, line_.length);
      if (bends) return;
      anchor_ =
          line_.bends.empty() ? protruding_most() : cyclic(line_.bends[line_.bends.size() / 2]);
    }
    open();
  }

  /// The crossings from those at the first of some bends on, and the bends that may be passed.
  std::pair<Crossings, std::vector<Bend>> to_pass(double least_saving) const {
    std::vector<Bend> bends = {anchor_};
    for (const Bend& bend : line_.bends) bends.push_back(cyclic(bend));
    std::erase_if(bends,
                  [&](const Bend& b) { return !is_to_pass(mesh_, b, line_.length, least_saving); });
    Crossings crossings = crossings_;
    if (bends.empty()) return {crossings, bends};
    const std::size_t first = bends.front().first, count = crossings.size();
    std::ranges::rotate(crossings, crossings.begin() + static_cast<std::ptrdiff_t>(first));
    for (Bend& bend : bends) {
      const std::size_t size = bend.end - bend.first;
      bend.first = (bend.first + count - first) % count;
      bend.end = bend.first + size;
    }
    std::erase_if(bends, [&](const Bend& b) { return b.end > count; });
    return {crossings, bends};
  }

  double length() const { return line_.length; }
  Path path() const { return trace(mesh_, opened_, line_); }

 private:
  void lay_out_once() {
    // The longest edge gives the best direction.
    const auto longest = std::ranges::max_element(
        crossings_, {}, [&](Index h) { return mesh_.half_edge(h).length; });
    std::ranges::rotate(crossings_, longest);
    LaidFace laid = lay_out(mesh_, crossings_.front() / 3);
    for (const Index h : crossings_) {
      gates_.push_back(gate_of(laid, h));
      laid = lay_out_beyond(mesh_, laid, h);
    }
    copy_ = gate_of(laid, crossings_.front());
    const Gate& gate = gates_.front();
    const Point2 a = {gate.left.x - gate.right.x, gate.left.y - gate.right.y};
    const Point2 b = {copy_.left.x - copy_.right.x, copy_.left.y - copy_.right.y};
    turned_ = std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }

  std::size_t wrapped(std::size_t i) const { return i % crossings_.size(); }

  /// All crossings around crossing i of edges at its vertex on this side.
  Bend run_of(std::size_t i, bool left) const {
    const std::size_t count = crossings_.size();
    const Index v = vertex_beside(mesh_, crossings_[i], left);
    const auto is_at = [&](std::size_t k) {
      return vertex_beside(mesh_, crossings_[wrapped(k)], left) == v;
    };
    std::size_t first = i + count, end = i + count + 1;
    while (first > i + 1 && is_at(first - 1)) --first;
    while (end < first + count && is_at(end)) ++end;
    const std::size_t size = end - first;
    return {.vertex = v, .left = left, .first = wrapped(first), .end = wrapped(first) + size};
  }

  /// A bend of the opened sleeve, with its crossings of the closed one.
  Bend cyclic(const Bend& bend) const {
    Bend run = run_of(wrapped(anchor_.end + bend.first), bend.left);
    run.at = bend.at;
    run.inside = bend.inside;
    run.before = bend.before;
    run.behind = bend.behind;
    return run;
  }

  /// Opens the sleeve at the anchor and finds the shortest line from there back to it.
  void open() {
    const std::size_t count = crossings_.size();
    const InternalPoint at(anchor_.vertex);
    const Index last = crossings_[wrapped(anchor_.end - 1)];
    opened_ = {at, at, mesh_.twin(last) / 3, {}};
    for (std::size_t i = anchor_.end; i < anchor_.first + count; ++i) {
      opened_.crossings.push_back(crossings_[wrapped(i)]);
    }
    line_ = shortest_line(mesh_, opened_);
    const bool left = anchor_.left;
    // The edges at the anchor behind and before the opened sleeve.
    const LaidFace first_face = lay_out(mesh_, opened_.face);
    LaidFace last_face = first_face;
    for (const Index h : opened_.crossings) last_face = lay_out_beyond(mesh_, last_face, h);
    const Gate out = gate_of(first_face, mesh_.twin(last)),
               in = gate_of(last_face, crossings_[anchor_.first]);
    const Point2 to = line_.bends.empty() ? line_.end : line_.bends.front().at;
    const Point2 from = line_.bends.empty() ? line_.begin : line_.bends.back().at;
    anchor_.at = line_.begin;
    anchor_.before = length_between(from, line_.end);
    anchor_.behind = length_between(line_.begin, to);
    anchor_.inside = angle_inside(line_.end, from, in.end(!left), left) +
                     angle_inside(line_.begin, out.end(left), to, left);
    for (std::size_t k = anchor_.first + 1; k < anchor_.end; ++k) {
      anchor_.inside += angle_before(mesh_, crossings_[wrapped(k)], left);
    }
  }

  /// The vertex farthest from the centre of the closed sleeve's turn, on the inner side, which is
  /// that across from the anchor. A line between two points of a circle lies inside it, so no
  /// shortest line passes beyond this vertex.
  Bend protruding_most() const {
    // With c from the centre to the anchor, its image after one turn R is off by d = R c - c. So
    // c = d / (R - 1), and for a turn near 0 both |c| and the centre are far away: c is scaled by
    // 2 sin(turn / 2).
    const bool left = !anchor_.left;
    const Point2 anchor = gates_[wrapped(anchor_.first)].end(anchor_.left);
    const Point2 image = image_of(anchor), d = {image.x - anchor.x, image.y - anchor.y};
    const double sine = std::sin(turned_ / 2), cosine = std::cos(turned_ / 2);
    const Point2 c = {cosine * d.y - sine * d.x, -cosine * d.x - sine * d.y};
    std::size_t best = 0;
    double farthest = -kInfinity;
    for (std::size_t i = 0; i < gates_.size(); ++i) {
      const Point2 p = gates_[i].end(left), w = {p.x - anchor.x, p.y - anchor.y};
      // The difference between the squared distances of p and the anchor from the centre.
      const double farther = w.x * c.x + w.y * c.y + sine * (w.x * w.x + w.y * w.y);
      const double by = sine < 0 ? -farther : farther;
      if (by > farthest) {
        farthest = by;
        best = i;
      }
    }
    return run_of(best, left);
  }

  /// A point of the closed sleeve, laid out one turn later.
  Point2 image_of(const Point2& p) const {
    const Point2 w = {p.x - gates_[0].right.x, p.y - gates_[0].right.y};
    const double sine = std::sin(turned_), cosine = std::cos(turned_);
    return {copy_.right.x + cosine * w.x - sine * w.y, copy_.right.y + sine * w.x + cosine * w.y};
  }

  const Mesh& mesh_;
  Crossings crossings_;
  std::vector<Gate> gates_;  ///< laid out once around
  Gate copy_ = {};           ///< the first gate again, after one turn
  double turned_ = 0;        ///< angle between both, in radians
  Bend anchor_;
  Sleeve opened_;
  SleeveLine line_;
};

[[noreturn]] void refuse_contractible() {
  throw std::invalid_argument("the loop shrinks to a point: it can be contracted on this surface");
}

/// Whether a closed sleeve only leads around one vertex.
bool is_around_vertex(const Mesh& mesh, const Crossings& crossings) {
  for (const bool left : {false, true}) {
    const Index v = vertex_beside(mesh, crossings.front(), left);
    if (std::ranges::all_of(crossings,
                            [&](Index h) { return vertex_beside(mesh, h, left) == v; })) {
      return true;
    }
  }
  return false;
}

Path straightened_loop(const Mesh& mesh, Crossings crossings) {
  for (Rounds rounds;;) {
    if (crossings.empty() || is_around_vertex(mesh, crossings)) refuse_contractible();
    Loop loop(mesh, crossings);
    if (std::optional<Path> line = loop.straight_line()) return *line;
    loop.find_bends();
    auto [from_bend, to_pass] = loop.to_pass(rounds.count(loop.length(), crossings));
    if (to_pass.empty()) return loop.path();
    crossings = std::move(from_bend);
    pass(mesh, crossings, to_pass);
    cancel_returns(mesh, crossings, true);
  }
}

/// Straightens a sleeve between its ends and adds it to those before. If nothing is left of it, or
/// of others before, it may leave the vertex where it began.
void add_straightened(const Mesh& mesh, std::vector<Sleeve>& sleeves, Sleeve next) {
  for (;;) {
    straighten(mesh, next);
    const bool is_point = next.crossings.empty() && next.begin == next.end;
    if (is_point && next.begin.is_vertex()) return;
    if (sleeves.empty() || !join(mesh, sleeves.back(), next)) break;
    next = std::move(sleeves.back());
    sleeves.pop_back();
  }
  sleeves.push_back(std::move(next));
}

PathPoint last_of(const Path& curve) {
  PathPoint point = curve.points.back();
  point.travelled = 0;
  return point;
}

}  // namespace

Path straightened(const Mesh& mesh, const Path& curve, bool closed) {
  if (mesh.crosses_non_manifold_edges()) {
    throw std::invalid_argument(
        "a curve cannot be straightened on a mesh whose paths cross non-manifold edges");
  }
  if (mesh.has_degenerate_faces()) {
    throw std::invalid_argument(
        "a curve cannot be straightened on a mesh that has faces without area: repair the mesh");
  }
  if (curve.points.size() < 2) {
    if (closed) refuse_contractible();
    return curve;
  }
  std::vector<Sleeve> sleeves;
  for (const Sleeve& each : sleeves_of(mesh, curve.points)) add_straightened(mesh, sleeves, each);
  while (closed && sleeves.size() > 1 && join(mesh, sleeves.back(), sleeves.front())) {
    const Sleeve joined = std::move(sleeves.back());
    sleeves.pop_back();
    sleeves.erase(sleeves.begin());
    add_straightened(mesh, sleeves, joined);
  }
  if (closed && sleeves.empty()) refuse_contractible();
  if (closed && sleeves.size() == 1) {
    if (auto crossings = geodesic::closed(mesh, sleeves[0])) {
      return straightened_loop(mesh, std::move(*crossings));
    }
  }
  if (sleeves.empty()) return {.source = 0, .points = {last_of(curve)}};
  Path path = trace(mesh, sleeves[0], shortest_line(mesh, sleeves[0]));
  for (std::size_t i = 1; i < sleeves.size(); ++i) {
    append(path, trace(mesh, sleeves[i], shortest_line(mesh, sleeves[i])));
  }
  return path;
}

}  // namespace geodesic
