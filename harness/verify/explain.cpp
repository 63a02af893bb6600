#include "harness/verify/explain.h"

#include <algorithm>
#include <cmath>

#include "harness/corpus/solvers.h"
#include "meshes/messages.h"
#include "meshes/oracles/path.h"

namespace geodesic::conformance {
namespace {

// Enough to tell windows apart; distances get all.
std::string rounded(double x) { return significant(x, 12); }

/// A window that contains the crossing, in the frame of the half-edge that the path enters.
struct WindowThere {
  Window window;
  double distance;  ///< of the crossing, through it
};

// The nearest window at each crossing of a path, by a solver that hands its windows over.
class WindowsAlong {
 public:
  WindowsAlong(const Description& solver, const Mesh& mesh, const Query& query,
               const std::vector<StraightPiece>& path)
      : name_(solver.name) {
    const ReadWindows read = [&](const FinalWindows& windows_on) {
      for (const StraightPiece& piece : path) {
        for (const EdgeCrossing& crossing : piece.crossings) {
          at_.push_back(nearest(mesh, windows_on, crossing));
        }
      }
    };
    Recording recording;
    recording.what = Record::windows;
    recording.read_windows = &read;
    ask(*make_solver(solver.name, mesh), mesh, query, &recording);
  }

  const std::string& name() const { return name_; }
  /// @param crossing counted from the source, over all pieces
  const std::optional<WindowThere>& at(std::size_t crossing) const { return at_.at(crossing); }

 private:
  static std::optional<WindowThere> nearest(const Mesh& mesh, const FinalWindows& windows_on,
                                            const EdgeCrossing& crossing) {
    const Index h = crossing.half_edge, own = std::min(h, mesh.twin(h));
    const double length = mesh.half_edge(h).length;
    const double slack = 1e-9 * length;  // of the ends of windows, as they are rounded
    std::vector<Window> windows;
    windows_on(own, windows);
    std::optional<WindowThere> best;
    for (Window w : windows) {
      if (own != h) w = {length - w.end, length - w.begin, length - w.x, -w.y, w.sigma};
      if (crossing.position < w.begin - slack || crossing.position > w.end + slack) continue;
      const double distance = distance_at(w, crossing.position);
      if (!best || distance < best->distance) best = {w, distance};
    }
    return best;
  }

  std::string name_;
  std::vector<std::optional<WindowThere>> at_;
};

const Description* another_with_windows(const Description& solver, const Mesh& mesh) {
  for (const Description* other : registered_solvers()) {
    const bool fits = other->final_windows && other->exactness == Exactness::exact &&
                      other->name != solver.name && harness::unsupported(*other, mesh).empty();
    if (fits) return other;
  }
  return nullptr;
}

class Explanation {
 public:
  Explanation(const Description& solver, const Case& given, const Failure& failure)
      : solver_(solver),
        mesh_(given.soup),
        query_(failure.query),
        got_(failure.got),
        reference_(solver, mesh_),
        right_(reference_.distances(query_)) {}

  std::vector<std::string> lines() {
    const Index first = first_wrong();
    if (first == kNone) {
      say("these distances equal those of " + reference_.name() +
          " up to rounding: the answer that they were compared with differs from them");
      return lines_;
    }
    const Vec3& p = mesh_.position(first);
    say("first wrong: vertex " + std::to_string(first) + " at (" + significant(p[0]) + ", " +
        significant(p[1]) + ", " + significant(p[2]) + "), " + role(first));
    say("  got       " + significant(got_[first]));
    const bool reached = std::isfinite(right_[first]);
    say("  expected  " + significant(right_[first]) + " (" + reference_.name() + "), " +
        (reached ? "relative error " + significant(relative_error(got_[first], right_[first]), 3)
                 : "no path leads there"));
    if (reached) explain_path(first);
    return lines_;
  }

 private:
  void say(const std::string& line) { lines_.push_back(line); }

  bool wrong(Index v) const {
    const double error = relative_error(got_[v], right_[v]);
    if (std::isinf(error)) return true;
    return solver_.exactness == Exactness::exact ? std::abs(error) > kExactTolerance
                                                 : -error > kExactTolerance;
  }

  Index first_wrong() const {
    Index first = kNone;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (wrong(v) && (first == kNone || right_[v] < right_[first])) first = v;
    }
    return first;
  }

  void explain_path(Index target) {
    const auto path = shortest_path(mesh_, query_.sources, right_, target);
    if (path.empty()) return;
    std::vector<WindowsAlong> windows;
    if (const Description* other = another_with_windows(solver_, mesh_)) {
      windows.emplace_back(*other, mesh_, query_, path);
    }
    if (solver_.final_windows) windows.emplace_back(solver_, mesh_, query_, path);
    say("the path that should have got there:");
    std::size_t crossing = 0;
    for (const StraightPiece& piece : path) {
      say("  from vertex " + std::to_string(piece.from) + " (" + role(piece.from) + ", distance " +
          rounded(right_[piece.from]) + ", " +
          (wrong(piece.from) ? "WRONG: got " + significant(got_[piece.from]) : "right") + ") " +
          (piece.crossings.empty() ? "along an edge" : "straight") + " for " +
          rounded(piece.length) + " to vertex " + std::to_string(piece.to));
      for (const EdgeCrossing& each : piece.crossings) {
        explain_crossing(each, right_[piece.from] + each.travelled, windows, crossing++);
      }
    }
  }

  // @param distance of the crossing, along the path
  void explain_crossing(const EdgeCrossing& crossing, double distance,
                        const std::vector<WindowsAlong>& windows, std::size_t number_of_it) {
    const Index h = crossing.half_edge;
    say("    across half-edge " + std::to_string(h) + " (" + std::to_string(mesh_.origin(h)) +
        " - " + std::to_string(mesh_.head(h)) + ") into face " + std::to_string(h / 3) + ", " +
        rounded(crossing.position) + " of " + rounded(mesh_.half_edge(h).length) +
        " along it, at distance " + rounded(distance));
    for (const WindowsAlong& each : windows) {
      say("      " + each.name() + ": " + window_text(each.at(number_of_it), distance));
    }
  }

  static std::string window_text(const std::optional<WindowThere>& there, double distance) {
    if (!there) return "no window here";
    const Window& w = there->window;
    const bool right = std::abs(relative_error(there->distance, distance)) <= kExactTolerance;
    return "window [" + rounded(w.begin) + ", " + rounded(w.end) + "], sigma " + rounded(w.sigma) +
           ", distance " + (right ? "right" : "WRONG: " + significant(there->distance)) +
           (w.y > 0 ? ", from the face ahead" : "");
  }

  std::string role(Index v) const { return role_of(v, mesh_, query_); }

  const Description& solver_;
  const Mesh mesh_;
  const Query& query_;
  const std::vector<double>& got_;
  Reference reference_;
  std::vector<double> right_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> explain_failure(const Description& solver, const Case& given,
                                         const Failure& failure) {
  const bool of_distances =
      !failure.query.sources.empty() && failure.got.size() == given.soup.positions.size();
  if (!of_distances || given.soup.triangles.size() > kExplainedFaces) return {};
  return Explanation(solver, given, failure).lines();
}

}  // namespace geodesic::conformance
