// Solvers that fail in every way that a run must catch and survive. A solver that returns distances
// takes them from a sound solver first, so that all errors are deliberate.
#include <signal.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <list>
#include <set>
#include <stdexcept>
#include <vector>

#include "meshes/oracles/path.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

constexpr const char* kFamily = "test-only";

const Description& sound_solver() {
  for (const Description* solver : registered_solvers()) {
    if (solver->exactness == Exactness::exact && solver->family != kFamily &&
        !solver->by_name_only && solver->abilities.max_vertices == kNone) {
      return *solver;
    }
  }
  throw std::logic_error("no exact solver is registered");
}

struct Asked {
  const Description& description;
  const Mesh& mesh;
  const InternalQuery& query;
  std::span<double> distances;
  Recording* recording;
  int solves;                      // number of earlier solves since construction or renewal
  const std::set<Index>& sources;  // first sources of all solves, including this one

  Index last_vertex() const { return mesh.numbers().internal_vertex(mesh.vertex_count() - 1); }
  // Changes the distance of the file's last vertex by far more than rounding and far less than a
  // plot shows.
  void spoil() const { distances[last_vertex()] *= 1 + 1e-9; }

  void solve_soundly(const InternalQuery& same) const {
    const MeshNumbers& numbers = mesh.numbers();
    Query given{.sources = {}, .limit = same.limit};
    for (const InternalSource& source : same.sources) {
      given.sources.push_back({in_external_numbers(mesh, source.at), source.distance});
    }
    std::vector<double> sound(distances.size());
    make_solver(sound_solver().name, mesh)->solve(given, sound);
    for (Index v = 0; v < sound.size(); ++v) distances[v] = sound[numbers.external_vertex(v)];
  }
};

using Fault = void (*)(const Asked& asked);

class Faulty final : public Solver {
 public:
  Faulty(const Mesh& mesh, const Description& description, Fault fault, bool answers)
      : Solver(mesh, description), description_(description), fault_(fault), answers_(answers) {}

 private:
  void run(const Start& start, std::span<double> distances) override {
    answer(start, distances, nullptr);
  }
  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    answer(start, distances, &recording);
  }
  void answer(const Start& start, std::span<double> distances, Recording* recording) {
    const InternalQuery& query = start.query;
    sources_.insert(query.sources.front().at.vertex);
    const Asked asked{description_, mesh(), query, distances, recording, solves_++, sources_};
    if (answers_) asked.solve_soundly(query);
    fault_(asked);
  }
  // Takes 20 ms of processor time, far more than a solve of a tetrahedron.
  void renew_state() override {
    const std::clock_t begin = std::clock();
    while (std::clock() - begin < CLOCKS_PER_SEC / 50) continue;
    solves_ = 0;
  }

  const Description& description_;
  const Fault fault_;
  const bool answers_;
  int solves_ = 0;
  std::set<Index> sources_;
};

// Registers a solver, as RegisterSolver does.
void add(Description description, Fault fault, bool answers) {
  SolverFactory factory = [=](const Mesh& mesh, const Description& d, PreparedReader* /*saved*/) {
    return std::make_unique<Faulty>(mesh, d, fault, answers);
  };
  geodesic_register_solver(compiled_contract().c_str(), &description, &factory);
}

// Computes sound distances, which the fault then changes.
struct Wrong {
  Wrong(Description description, Fault fault) { add(std::move(description), fault, true); }
};

// Computes no distances.
struct Hostile {
  Hostile(Description description, Fault fault) { add(std::move(description), fault, false); }
};

Description faulty(const char* name, Index max_vertices = 1000) {
  return {.name = name,
          .family = kFamily,
          .paper = "none",
          .abilities = {.max_vertices = max_vertices}};
}

Description only_by_name(const char* name) {
  return {.name = name, .family = kFamily, .paper = "none", .by_name_only = true};
}

// Runs by name only: these bounds serve the tests of the harness, not the tests of all solvers.
Description inexact(const char* name, Exactness exactness) {
  Description description = faulty(name);
  description.exactness = exactness;
  description.by_name_only = true;
  description.parameters = {real_parameter("off", 0, -0.5, 10, "relative error"),
                            integer_parameter("threads", 1, 1, 8, "threads that it claims to use")};
  return description;
}

Description bounded() {
  Description description = inexact("bounded", Exactness::bounded);
  description.parameters.push_back(real_parameter("bound", 0.1, 0, 1, "of the error"));
  description.error_bound = [](const Description& d) { return d.real("bound"); };
  return description;
}

Description oracle() {
  Description description = inexact("oracle", Exactness::exact);
  description.independent_oracle = true;
  return description;
}

Description renewable() {
  Description description = faulty("renewable");
  description.needs_renewal = true;
  return description;
}

Description fickle() {
  Description description = faulty("fickle");
  description.deterministic = false;
  description.parameters = {real_parameter("by", 1e-16, 0, 1, "relative change a solve")};
  return description;
}

void spoil(const Asked& asked) { asked.spoil(); }

// Keeps state that makes every solve but the first wrong.
void spoil_second(const Asked& asked) {
  if (asked.solves > 0) asked.spoil();
}

// Scales every distance by the same factor. The distance 0 of a source stays.
void be_off(const Asked& asked) {
  for (double& d : asked.distances) d *= 1 + asked.description.real("off");
}

void loop(const Asked& asked) {
  for (volatile double* at = asked.distances.data();;) *at = 0;
}

const Wrong kWrong[] = {
    {faulty("wrong"), spoil},
    {faulty("tiny", 3), spoil},
    {faulty("forgetful"), spoil_second},
    {renewable(), spoil_second},
    {bounded(), be_off},
    {inexact("upper", Exactness::upper_bound), be_off},
    {inexact("unbounded", Exactness::unbounded), be_off},
    {oracle(), be_off},
    // Like parallel code, gives other last digits in each solve, or other answers if `by` is large.
    {fickle(),
     [](const Asked& asked) {
       for (double& d : asked.distances) d *= 1 + asked.description.real("by") * asked.solves;
     }},
    // Wrong after a query from another source.
    {faulty("stale"),
     [](const Asked& asked) {
       if (asked.sources.size() > 1) asked.spoil();
     }},
    // Too short after a query from another source.
    {inexact("stale-bound", Exactness::upper_bound),
     [](const Asked& asked) {
       if (asked.sources.size() > 1) asked.distances[asked.last_vertex()] *= 1 - 1e-9;
     }},
    {faulty("disturbed"),
     [](const Asked& asked) {
       if (asked.recording != nullptr) asked.spoil();
     }},
    // Ignores all sources but the first.
    {faulty("single-minded"),
     [](const Asked& asked) {
       asked.solve_soundly({.sources = {asked.query.sources[0]}, .limit = asked.query.limit});
     }},
    // Has no pseudo-sources on the boundary and does not reach the vertices behind them.
    {faulty("boundary-blind"),
     [](const Asked& asked) {
       asked.solve_soundly({.sources = asked.query.sources});
       const std::vector<double> right(asked.distances.begin(), asked.distances.end());
       for (Index v = 0; v < right.size(); ++v) {
         const auto path = shortest_path(asked.mesh, asked.query.sources, right, v);
         for (std::size_t bend = 1; bend < path.size(); ++bend) {
           if (asked.mesh.is_boundary(path[bend].from)) asked.distances[v] = kInfinity;
         }
       }
     }},
    {faulty("not-a-number"), [](const Asked& asked) { asked.distances.back() = std::nan(""); }},
    // Two faults: a distance is too long on meshes of 6 or more faces, too short on smaller ones.
    {faulty("two-faced"),
     [](const Asked& asked) {
       asked.distances[asked.last_vertex()] *= asked.mesh.face_count() < 6 ? 1 - 1e-9 : 1 + 1e-9;
     }},
    {faulty("miscounting"),
     [](const Asked& asked) {
       if (asked.recording != nullptr) asked.recording->strip_depth = 1;
     }},
    // Correct, but prints lines that look like results.
    {faulty("printing"),
     [](const Asked&) {
       for (std::ostream* out : {&std::cout, &std::cerr}) {
         *out << R"({"name": "forged", "outcome": "ok", "cpu_time": 0})" << std::endl;
       }
       std::puts("forged/tetrahedron/src:0");
     }},
};

// Uses more than a page of stack per call, and again after it, which prevents a tail call.
int deeper(int depth, const volatile bool& on) {
  volatile char page[5000];
  page[depth % 5000] = 1;
  return on ? deeper(depth + 1, on) + page[depth % 5000] : 0;
}

constexpr std::size_t kBlock = std::size_t{16} << 20;

const Hostile kHostile[] = {
    {faulty("looping"), loop},
    // Closes its standard error, on which the harness waits for the end of the process.
    {faulty("mute"),
     [](const Asked& asked) {
       close(STDERR_FILENO);
       loop(asked);
     }},
    {faulty("crashing"), [](const Asked&) { std::abort(); }},
    {faulty("throwing"), [](const Asked&) { throw std::invalid_argument("ran out of luck"); }},
    {faulty("leaving"), [](const Asked&) { std::_Exit(0); }},
    // Ends the process, as some libraries do.
    {faulty("exiting"), [](const Asked&) { std::exit(0); }},
    {only_by_name("stack-overflow"),
     [](const Asked& asked) {
       const volatile bool for_ever = true;
       asked.distances[0] = deeper(0, for_ever);
     }},
    {only_by_name("hungry"),
     [](const Asked&) {
       for (std::list<std::vector<char>> blocks;;) blocks.emplace_back(kBlock, 'x');
     }},
    // Does not check whether malloc succeeded.
    {only_by_name("hungry-and-blind"),
     [](const Asked&) {
       for (;;) {
         void* volatile block = std::malloc(kBlock);  // volatile keeps the call
         std::memset(block, 'x', kBlock);
       }
     }},
    // Writes more than a pipe holds to both outputs.
    {only_by_name("talkative"),
     [](const Asked&) {
       const std::string line(1000, 'x');
       for (int i = 0; i < 10'000; ++i) {
         std::cout << line << '\n';
         std::cerr << line << '\n';
       }
       std::cerr << "the \033[31mlast\377 words" << std::endl;
       std::abort();
     }},
    {only_by_name("chatterbox"),
     [](const Asked&) {
       for (;;) std::cerr << "and another thing" << std::endl;
     }},
    // Ends and leaves a child process that keeps standard error open and never ends.
    {only_by_name("parent"),
     [](const Asked&) {
       if (fork() == 0) {
         for (;;) pause();
       }
       throw 7;
     }},
    {only_by_name("deaf"),
     [](const Asked&) {
       for (const int each : {SIGINT, SIGTERM, SIGHUP}) signal(each, SIG_IGN);
       for (;;) pause();
     }},
};

}  // namespace
}  // namespace geodesic
