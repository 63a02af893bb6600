#include "harness/verify/explain.h"

#include <algorithm>
#include <cmath>

#include "harness/corpus/solvers.h"
#include "meshes/messages.h"
#include "meshes/oracles/path.h"

namespace geodesic::harness {
namespace {

// Enough digits to tell windows apart. Wrong distances are printed with all digits.
std::string rounded(double x) { return significant(x, 12); }

// A window that contains an edge crossing, in the frame of the half-edge that the path enters, and
// the distance of the crossing by this window.
struct WindowThere {
  Window window;
  double distance;
};

std::optional<WindowThere> nearest_window(const Mesh& mesh, const FinalWindows& windows_on,
                                          const EdgeCrossing& crossing) {
  const Index h = crossing.half_edge, own = std::min(h, mesh.twin(h));
  const double length = mesh.half_edge(h).length;
  const double slack = 1e-9 * length;  // for rounded ends of windows
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

// The windows of one solver at the edge crossings of a path.
struct WindowsAlong {
  std::string solver;
  std::vector<std::optional<WindowThere>> at;  // by crossing, counted from the source

  WindowsAlong(const std::string& name, const Mesh& mesh, const Query& query,
               const std::vector<StraightPiece>& path)
      : solver(name) {
    const ReadWindows read = [&](const FinalWindows& windows_on) {
      for (const StraightPiece& piece : path) {
        for (const EdgeCrossing& crossing : piece.crossings) {
          at.push_back(nearest_window(mesh, windows_on, crossing));
        }
      }
    };
    Recording recording;
    recording.kind = RecordingKind::windows;
    recording.read_windows = &read;
    solve_once(name, mesh, query, &recording);
  }
};

// The windows of another exact solver, then those of the solver itself, if they keep windows.
std::vector<WindowsAlong> windows_along(const Description& solver, const Mesh& mesh,
                                        const Query& query,
                                        const std::vector<StraightPiece>& path) {
  std::vector<WindowsAlong> windows;
  for (const Description* other : registered_solvers()) {
    const bool fits = other->final_windows && other->exactness == Exactness::exact &&
                      other->name != solver.name && unsupported(*other, mesh).empty();
    if (!fits) continue;
    windows.emplace_back(other->name, mesh, query, path);
    break;
  }
  if (solver.final_windows) windows.emplace_back(solver.name, mesh, query, path);
  return windows;
}

class Explanation {
 public:
  Explanation(const Description& solver, const Case& given, const Violation& violation)
      : solver_(solver),
        mesh_(given.build()),
        query_(violation.query),
        got_(violation.got),
        reference_(LocalReference(solver, mesh_, given.tolerance).distances(query_)),
        right_(reference_.values) {}

  std::vector<std::string> lines() {
    const Finding finding = check(got_, right_);
    if (!finding) {
      say("these distances equal those of " + reference_.by +
          " up to rounding: the answer that they were compared with differs from them");
      return lines_;
    }
    const Index first = finding->vertex;
    const Vec3& p = mesh_.position(first);
    say("first wrong: vertex " + std::to_string(first) + " at (" + significant(p[0]) + ", " +
        significant(p[1]) + ", " + significant(p[2]) + "), " + role_of(first, mesh_, query_));
    say("  got       " + significant(got_[first]));
    const bool reached = std::isfinite(right_[first]);
    const double error = relative_error(got_[first], right_[first]);
    say("  expected  " + significant(right_[first]) + " (" + reference_.by + ")" +
        (!reached               ? ", no path leads there"
         : std::isfinite(error) ? ", relative error " + significant(error, 3)
                                : ""));
    if (reached) explain_path(first);
    return lines_;
  }

 private:
  void say(const std::string& line) { lines_.push_back(line); }

  Finding check(std::span<const double> got, std::span<const double> right) const {
    return check_promise(Promise::of(solver_), query_, got, right);
  }
  bool wrong(Index v) const { return check({&got_[v], 1}, {&right_[v], 1}).has_value(); }

  void explain_path(Index target) {
    const auto path =
        shortest_path(mesh_, in_internal_numbers(mesh_, query_).sources, right_, target);
    if (path.empty()) return;
    const std::vector<WindowsAlong> windows = windows_along(solver_, mesh_, query_, path);
    say("the path that should have got there:");
    std::size_t crossing = 0;
    for (const StraightPiece& piece : path) {
      say("  from vertex " + std::to_string(piece.from) + " (" +
          role_of(piece.from, mesh_, query_) + ", distance " + rounded(right_[piece.from]) + ", " +
          (wrong(piece.from) ? "WRONG: got " + significant(got_[piece.from]) : "right") + ") " +
          (piece.crossings.empty() ? "along an edge" : "straight") + " for " +
          rounded(piece.length) + " to vertex " + std::to_string(piece.to));
      for (const EdgeCrossing& each : piece.crossings) {
        const double distance = right_[piece.from] + each.travelled;
        const Index h = each.half_edge;
        say("    across half-edge " + std::to_string(h) + " (" + std::to_string(mesh_.origin(h)) +
            " - " + std::to_string(mesh_.head(h)) + ") into face " + std::to_string(h / 3) + ", " +
            rounded(each.position) + " of " + rounded(mesh_.half_edge(h).length) +
            " along it, at distance " + rounded(distance));
        for (const WindowsAlong& of : windows) {
          say("      " + of.solver + ": " + window_text(of.at.at(crossing), distance));
        }
        ++crossing;
      }
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

  const Description& solver_;
  const Mesh mesh_;
  const Query& query_;
  const std::vector<double>& got_;
  const ReferenceDistances reference_;
  const std::vector<double>& right_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> explain_violation(const Description& solver, const Case& given,
                                           const Violation& violation) {
  const bool of_distances =
      !violation.query.sources.empty() && violation.got.size() == given.soup.positions.size();
  if (!of_distances || given.soup.triangles.size() > kExplainedFaces) return {};
  return Explanation(solver, given, violation).lines();
}

}  // namespace geodesic::harness
