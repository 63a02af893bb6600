#include "tests/differential/differential.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <iomanip>
#include <map>
#include <mutex>
#include <span>
#include <thread>
#include <tuple>
#include <utility>

#include "harness/base/clock.h"
#include "harness/base/files.h"
#include "harness/base/plugins.h"
#include "harness/corpus/solvers.h"
#include "harness/verify/property.h"
#include "harness/verify/shrink.h"
#include "meshes/mesh_file.h"
#include "meshes/messages.h"
#include "tests/differential/points.h"
#include "tests/differential/scratch.h"

namespace geodesic::differential {
namespace {

using harness::Case;
using harness::Finding;

constexpr const char* kBruteForce = "brute force";
constexpr const char* kPathsProperty = "paths-begin-in-faces-and-on-edges-too";
// Brute force takes a second for so many faces; beyond, an independent oracle judges.
constexpr Index kBruteForceFaces = 600;
// Where that oracle and a solver differ, brute force is asked all the same: minutes, on few meshes.
constexpr Index kArbiterFaces = 4000;

struct Answer {
  std::string by;
  std::vector<double> distances;
};

/// How far one solver is from another on one kind of mesh.
struct Distance {
  std::uint64_t comparisons = 0;
  double largest = 0;    ///< relative error over all vertices
  std::uint64_t at = 0;  ///< number of the mesh
};

struct Disagreement {
  std::uint64_t number;
  const Description* solver;
  std::string what;
  const char* property;  ///< that may fail there too
};

double largest_error(const std::vector<double>& got, const std::vector<double>& want,
                     const harness::Tolerance& tolerance) {
  double largest = 0;
  for (std::size_t v = 0; v < got.size(); ++v) {
    const double error = harness::relative_error(got[v], want[v], tolerance.least);
    largest = std::max(largest, std::abs(error));
  }
  return largest;
}

/// Distances by a solver that is not ours, and may crash or never end: then none.
/// @param ask writes so many of them
/// @throws std::runtime_error in these cases
std::vector<double> ask_in_a_process(const Description& solver, std::size_t count,
                                     const std::function<void(std::span<double>)>& ask) {
  constexpr unsigned kSeconds = 60;
  const std::size_t bytes = count * sizeof(double);
  void* shared = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::runtime_error("no memory to share");
  const std::span<double> distances(static_cast<double*>(shared), count);
  const pid_t child = fork();
  if (child == 0) {
    alarm(kSeconds);
    try {
      ask(distances);
      _exit(0);
    } catch (const std::exception&) {
      _exit(1);
    }
  }
  int status = -1;
  if (child > 0) waitpid(child, &status, 0);
  std::vector<double> copy(distances.begin(), distances.end());
  munmap(shared, bytes);
  if (status != 0) throw std::runtime_error(solver.name + " did not answer");
  return copy;
}

std::vector<const Description*> solvers_of(const Request& request) {
  std::vector<const Description*> chosen = harness::solvers_named(request.solvers);
  if (!chosen.empty()) return chosen;
  for (const Description* solver : registered_solvers()) {
    if (solver->exactness != Exactness::unbounded) chosen.push_back(solver);
  }
  return chosen;
}

class Differential {
 public:
  Differential(const Request& request, std::ostream& report)
      : request_(request), report_(report), solvers_(solvers_of(request)) {}

  bool run() {
    if (request_.only) {
      examine(*request_.only, Scratch().folder());
    } else {
      std::vector<std::jthread> jobs;
      for (unsigned j = 0; j < request_.jobs; ++j) jobs.emplace_back([this] { work(); });
    }
    print();
    std::ranges::sort(disagreements_, {}, &Disagreement::number);
    for (const Disagreement& each : disagreements_) show(each);
    return disagreements_.empty();
  }

 private:
  void work() {
    const Scratch scratch;
    for (std::uint64_t number = next_++; number < request_.meshes; number = next_++) {
      examine(number, scratch.folder());
    }
  }

  void examine(std::uint64_t number, const std::filesystem::path& scratch) {
    const Case given = random_case(request_.seed, number, scratch);
    const Mesh mesh(given.soup);
    const Kind kind = kind_of(mesh);
    const Query& query = given.queries.front();
    // What judges first, what is judged only behind.
    std::vector<Answer> judges;
    if (mesh.face_count() <= kBruteForceFaces) {
      judges.push_back(
          {kBruteForce, cut_off(BruteForce(mesh).distances(query.sources), query.limit)});
    }
    for (const Description* solver : by_independence(mesh)) {
      const bool exact = solver->exactness == Exactness::exact;
      Answer answer{solver->name, {}};
      try {
        if (judges.empty() && !exact) judges.push_back(local_reference(*solver, mesh, query));
        answer.distances =
            solver->independent_oracle
                ? ask_in_a_process(*solver, mesh.vertex_count(),
                                   [&](std::span<double> distances) {
                                     make_solver(solver->name, mesh)->solve(query, distances);
                                   })
                : harness::solve_once(solver->name, mesh, query);
      } catch (const std::exception& error) {
        if (solver->independent_oracle) {
          const std::lock_guard lock(mutex_);
          ++unanswered_[solver->name];
          continue;
        }
        note(number, *solver, given, std::string("threw: ") + error.what());
        continue;
      }
      for (Answer& judge : judges) {
        const double error = compare(number, kind, given, answer, judge);
        // The first judge decides; an independent oracle is not ours to repair.
        if (&judge != &judges.front() || solver->independent_oracle) continue;
        const auto is_wrong = [&] {
          return harness::check_promise(harness::Promise::of(*solver), query, answer.distances,
                                        judge.distances, given.tolerance)
              .has_value();
        };
        if (!is_wrong()) continue;
        if (judge.by != kBruteForce && mesh.face_count() <= kArbiterFaces) {
          ask_the_arbiter(judge, mesh, query);
          if (!is_wrong()) continue;
        }
        note(number, *solver, given, "differs from " + judge.by + " by " + significant(error, 3));
      }
      if (exact && (judges.empty() || solver->independent_oracle)) {
        judges.push_back(std::move(answer));
      }
    }
    examine_points(number, kind, given, mesh);
    const std::lock_guard lock(mutex_);
    ++meshes_[kind];
  }

  // Brute force in the place of a judge that a solver differs from.
  void ask_the_arbiter(Answer& judge, const Mesh& mesh, const Query& query) {
    const std::string before = std::exchange(judge.by, kBruteForce);
    judge.distances = cut_off(BruteForce(mesh).distances(query.sources), query.limit);
    const std::lock_guard lock(mutex_);
    ++arbitrated_[before];
  }

  // Where no exact solver was asked for and the mesh is too large for brute force.
  static Answer local_reference(const Description& solver, const Mesh& mesh, const Query& query) {
    harness::LocalReference reference(solver, mesh);
    return {reference.name(), reference.distances(query)};
  }

  // Points in faces and on edges, and the paths between them.
  void examine_points(std::uint64_t number, Kind kind, const Case& given, const Mesh& mesh) {
    std::vector<const Description*> solvers = by_independence(mesh);
    std::erase_if(solvers, [](const Description* solver) {
      return !solver->abilities.paths || !solver->abilities.surface_sources;
    });
    if (solvers.empty() || mesh.face_count() == 0) return;
    // For the points' true distances; one that is meant for small meshes would take hours on some.
    const auto judge = std::ranges::find_if(solvers, [](const Description* solver) {
      return solver->exactness == Exactness::exact && !solver->independent_oracle &&
             solver->abilities.max_vertices == kNone;
    });
    if (judge == solvers.end()) return;
    PointTask task;
    try {
      task = random_points(request_.seed, number, given, mesh, **judge, kBruteForceFaces);
    } catch (const std::exception& error) {
      note(number, **judge, given, std::string("threw: ") + error.what(), kPathsProperty);
      return;
    }
    for (const Description* solver : solvers) {
      PathFigures figures{.at = number};
      harness::Finding wrong;
      try {
        wrong = solver->independent_oracle ? ask_for_targets(*solver, mesh, task, figures)
                                           : check_points(*solver, mesh, kind, task, figures);
      } catch (const std::exception& error) {
        if (solver->independent_oracle) {
          const std::lock_guard lock(mutex_);
          ++unanswered_[solver->name];
          continue;
        }
        wrong = harness::Violation{.what = std::string("threw: ") + error.what()};
      }
      {
        const std::lock_guard lock(mutex_);
        add(figures, paths_[{kind, solver->name}]);
      }
      if (wrong && !solver->independent_oracle) {
        note(number, *solver, given, wrong->what, kPathsProperty);
      }
    }
  }

  static harness::Finding ask_for_targets(const Description& solver, const Mesh& mesh,
                                          const PointTask& task, PathFigures& figures) {
    const auto ask = [&](std::span<double> distances) {
      const auto object = make_solver(solver.name, mesh);
      const Paths paths = solve_paths(*object, mesh, task.query);
      for (std::size_t i = 0; i < distances.size(); ++i) distances[i] = paths.distance_to_target(i);
    };
    const auto got = ask_in_a_process(solver, task.expected.size(), ask);
    return check_targets(solver, task, got, figures);
  }

  static void add(const PathFigures& figures, PathFigures& sum) {
    sum.paths += figures.paths;
    sum.pieces += figures.pieces;
    if (figures.largest <= sum.largest && sum.at != 0) return;
    sum.largest = figures.largest;
    sum.at = figures.at;
  }

  static std::vector<double> cut_off(std::vector<double> distances, double limit) {
    for (double& d : distances) d = d > limit ? kInfinity : d;
    return distances;
  }

  std::vector<const Description*> by_independence(const Mesh& mesh) const {
    std::vector<const Description*> fit;
    for (const Description* solver : solvers_) {
      if (harness::unsupported(*solver, mesh).empty()) fit.push_back(solver);
    }
    std::ranges::stable_sort(fit, {}, [](const Description* solver) {
      return std::pair(!solver->independent_oracle, solver->exactness != Exactness::exact);
    });
    return fit;
  }

  double compare(std::uint64_t number, Kind kind, const Case& given, const Answer& got,
                 const Answer& want) {
    const double error = largest_error(got.distances, want.distances, given.tolerance);
    const std::lock_guard lock(mutex_);
    Distance& apart = distances_[{kind, got.by, want.by}];
    ++apart.comparisons;
    if (error > apart.largest) {
      apart.largest = error;
      apart.at = number;
    }
    return error;
  }

  void note(std::uint64_t number, const Description& solver, const Case& given,
            const std::string& what, const char* property = harness::kDistancesProperty) {
    const std::lock_guard lock(mutex_);
    report_ << "seed " << request_.seed << ", mesh " << number << " (" << given.mesh << ", "
            << given.soup.triangles.size() << " faces): " << solver.name << ' ' << what << '\n';
    report_.flush();
    const bool first = std::ranges::none_of(
        disagreements_, [&](const Disagreement& each) { return each.solver == &solver; });
    if (first) disagreements_.push_back({number, &solver, what, property});
  }

  void print() const {
    std::uint64_t meshes = 0, comparisons = 0;
    for (const auto& [kind, count] : meshes_) meshes += count;
    for (const auto& [pair, apart] : distances_) comparisons += apart.comparisons;
    report_ << "seed " << request_.seed << ": " << meshes << " meshes, " << comparisons
            << " comparisons\n";
    for (const auto& [kind, count] : meshes_) report_ << "  " << name_of(kind) << ' ' << count;
    for (const auto& [solver, count] : unanswered_) {
      report_ << "  " << solver << " refused or crashed on " << count;
    }
    for (const auto& [judge, count] : arbitrated_) {
      report_ << "  " << judge << " went to the arbiter on " << count;
    }
    report_ << '\n' << std::left;
    std::size_t widest = 0;
    for (const Description* solver : solvers_) widest = std::max(widest, solver->name.size());
    const int names = static_cast<int>(std::max<std::size_t>(widest, 16)) + 2;
    for (const auto& [pair, apart] : distances_) {
      const auto& [kind, solver, judge] = pair;
      report_ << "  " << std::setw(13) << name_of(kind) << std::setw(names) << solver
              << std::setw(18) << judge << std::setw(8) << apart.comparisons
              << "largest relative error " << significant(apart.largest, 2) << " at mesh "
              << apart.at << '\n';
    }
    for (const auto& [pair, figures] : paths_) {
      report_ << "  " << std::setw(13) << name_of(pair.first) << std::setw(names) << pair.second
              << figures.paths << " paths over " << figures.pieces
              << " faces; targets: largest relative error " << significant(figures.largest, 2)
              << " at mesh " << figures.at << '\n';
    }
  }

  void show(const Disagreement& each) const {
    const harness::Property& property = *harness::find_property(each.property);
    const Case given = random_case(request_.seed, each.number, Scratch().folder());
    const Finding failed = harness::check_case(property, *each.solver, given);
    const std::string stem = harness::as_file_name(each.solver->name) + "-seed-" +
                             std::to_string(request_.seed) + "-mesh-" + std::to_string(each.number);
    const std::filesystem::path file = request_.out / (stem + ".obj");
    Case small = given;
    if (failed) {
      const auto still_fails = [&](const Case& smaller) {
        const Finding finding = harness::check_case(property, *each.solver, smaller);
        return finding && finding->kind == failed->kind;
      };
      small = harness::shrink(given, given.queries.front(), still_fails, request_.shrink);
    }
    std::filesystem::create_directories(request_.out);
    harness::write_bytes(file, mesh_bytes(small.soup, file));
    report_ << '\n'
            << each.solver->name << ' ' << each.what << " at mesh " << each.number << " of seed "
            << request_.seed << ", " << given.mesh << '\n'
            << "  smallest case  " << file.string() << ": " << small.soup.triangles.size()
            << " faces of " << given.soup.triangles.size() << '\n'
            << "  reproduce it   geodesic-bench verify --solver "
            << harness::quoted(each.solver->name) << " --property " << property.name << " --meshes "
            << file.string() << words_of(small.queries.front()) << '\n'
            << "  the whole      differential --seed " << request_.seed << " --only " << each.number
            << " --solvers " << harness::quoted(each.solver->name) << '\n';
  }

  static std::string words_of(const Query& query) {
    std::string words;
    for (const Source& source : query.sources) {
      words += " --source " + std::to_string(source.at.vertex);
      if (source.distance > 0) words += ':' + significant(source.distance);
    }
    if (query.limit < kInfinity) words += " --limit " + significant(query.limit);
    return words;
  }

  const Request& request_;
  std::ostream& report_;
  const std::vector<const Description*> solvers_;
  std::atomic<std::uint64_t> next_ = 0;
  std::mutex mutex_;  // of all below
  std::map<Kind, std::uint64_t> meshes_;
  std::map<std::tuple<Kind, std::string, std::string>, Distance> distances_;
  std::map<std::pair<Kind, std::string>, PathFigures> paths_;
  std::map<std::string, std::uint64_t> unanswered_;  // by independent oracles
  std::map<std::string, std::uint64_t> arbitrated_;  // meshes, by the judge that was doubted
  std::vector<Disagreement> disagreements_;          // the first one of each solver
};

}  // namespace

bool run_differential(const Request& request, std::ostream& report) {
  return Differential(request, report).run();
}

}  // namespace geodesic::differential
