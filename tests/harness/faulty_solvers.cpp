// Solvers that fail in every way that a run must catch and survive. They solve by another solver
// first, so that only what is wrong on purpose is wrong.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
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

class Faulty : public Solver {
 public:
  Faulty(const Mesh& mesh, const Description& description) : Solver(mesh, description) {}

 protected:
  // Both in the mesh's internal numbering, as `run` has it; `solve` speaks of the numbers given.
  void solve_soundly(Query query, std::span<double> distances) {
    for (Source& source : query.sources)
      source.at.vertex = mesh().numbers().external_vertex(source.at.vertex);
    std::vector<double> given(distances.size());
    make_solver(sound_solver().name, mesh())->solve(query, given);
    for (Index v = 0; v < distances.size(); ++v)
      distances[v] = given[mesh().numbers().external_vertex(v)];
  }
  // The last vertex of the file; the relative error is far above rounding and far below what a plot
  // shows.
  void spoil(std::span<double> distances) const {
    distances[mesh().numbers().internal_vertex(mesh().vertex_count() - 1)] *= 1 + 1e-9;
  }
};

class Wrong final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly(query, distances);
    spoil(distances);
  }
};

// Keeps state that a second solve trips over.
class Forgetful final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly(query, distances);
    if (solves_++ > 0) spoil(distances);
  }
  int solves_ = 0;
};

// Is right until it was asked for another source.
class Stale final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly(query, distances);
    if (first_ == kNone) first_ = query.sources.front().at.vertex;
    spoiled_ = spoiled_ || first_ != query.sources.front().at.vertex;
    if (spoiled_) spoil(distances);
  }
  Index first_ = kNone;
  bool spoiled_ = false;
};

class Disturbed final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    solve_soundly(query, distances);
    if (recording != nullptr) spoil(distances);
  }
};

// Knows the first source only.
class SingleMinded final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly({.sources = {query.sources.front()}, .limit = query.limit}, distances);
  }
};

// Knows no pseudo-sources at boundaries: what lies behind them is not reached.
class BoundaryBlind final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly({.sources = query.sources}, distances);
    const std::vector<double> right(distances.begin(), distances.end());
    for (Index v = 0; v < right.size(); ++v) {
      const auto path = shortest_path(mesh(), query.sources, right, v);
      for (std::size_t bend = 1; bend < path.size(); ++bend) {
        if (mesh().is_boundary(path[bend].from)) distances[v] = kInfinity;
      }
    }
  }
};

class NotANumber final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly(query, distances);
    distances.back() = std::nan("");
  }
};

// Too long on meshes of some faces, too short on smaller ones: two faults.
class TwoFaced final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly(query, distances);
    distances[mesh().numbers().internal_vertex(mesh().vertex_count() - 1)] *=
        mesh().face_count() < 6 ? 1 - 1e-9 : 1 + 1e-9;
  }
};

class Miscounting final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording* recording) override {
    solve_soundly(query, distances);
    if (recording != nullptr) recording->strip_depth = 1;
  }
};

// Closes its standard error, which is what a process is waited for by.
class Mute final : public Faulty {
  using Faulty::Faulty;
  void run(const Query&, std::span<double> distances, Recording*) override {
    close(STDERR_FILENO);
    for (volatile double* at = distances.data();;) *at = 0;
  }
};

class Looping final : public Faulty {
  using Faulty::Faulty;
  void run(const Query&, std::span<double> distances, Recording*) override {
    for (volatile double* at = distances.data();;) *at = 0;
  }
};

class Crashing final : public Faulty {
  using Faulty::Faulty;
  void run(const Query&, std::span<double>, Recording*) override { std::abort(); }
};

class Throwing final : public Faulty {
  using Faulty::Faulty;
  void run(const Query&, std::span<double>, Recording*) override {
    throw std::runtime_error("ran out of luck");
  }
};

class Leaving final : public Faulty {
  using Faulty::Faulty;
  void run(const Query&, std::span<double>, Recording*) override { std::_Exit(0); }
};

// As a library may that takes itself for a program.
class Exiting final : public Faulty {
  using Faulty::Faulty;
  void run(const Query&, std::span<double>, Recording*) override { std::exit(0); }
};

// Right, and talks like a result file.
class Printing final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    for (std::ostream* out : {&std::cout, &std::cerr}) {
      *out << R"({"name": "forged", "outcome": "ok", "cpu_time": 0})" << std::endl;
    }
    std::puts("forged/tetrahedron/src:0");
    solve_soundly(query, distances);
  }
};

// Every distance is off by the same part, except those of sources.
class Off final : public Faulty {
 public:
  Off(const Mesh& mesh, const Description& description)
      : Faulty(mesh, description), factor_(1 + description.real("off")) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly(query, distances);
    for (double& d : distances) d *= factor_;
  }
  const double factor_;
};

// Adds what is left of the last query.
class Renewable final : public Faulty {
  using Faulty::Faulty;
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly(query, distances);
    if (left_) spoil(distances);
    left_ = true;
  }
  void renew_state() override { left_ = false; }
  bool left_ = false;
};

// As parallel codes may: other last digits from solve to solve, or another answer.
class Fickle final : public Faulty {
 public:
  Fickle(const Mesh& mesh, const Description& description)
      : Faulty(mesh, description), by_(description.real("by")) {}

 private:
  void run(const Query& query, std::span<double> distances, Recording*) override {
    solve_soundly(query, distances);
    for (double& d : distances) d *= 1 + by_ * solves_;
    ++solves_;
  }
  const double by_;
  int solves_ = 0;
};

Description faulty(const char* name, Index max_vertices = 1000) {
  return {.name = name,
          .family = kFamily,
          .paper = "none",
          .abilities = {.max_vertices = max_vertices}};
}

// By name only: the bounds are the harness's to test, not those of every solver.
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

const RegisterSolver<Exiting> exiting{faulty("exiting")};
const RegisterSolver<Printing> printing{faulty("printing")};
const RegisterSolver<Off> off_within{bounded()};
const RegisterSolver<Off> off_above{inexact("upper", Exactness::upper_bound)};
const RegisterSolver<Off> off_anyhow{inexact("unbounded", Exactness::unbounded)};
const RegisterSolver<Off> off_as_oracle{oracle()};
const RegisterSolver<Renewable> renewable_solver{renewable()};
const RegisterSolver<Fickle> fickle_solver{fickle()};
const RegisterSolver<Wrong> wrong{faulty("wrong")};
const RegisterSolver<Forgetful> forgetful{faulty("forgetful")};
const RegisterSolver<Stale> stale{faulty("stale")};
const RegisterSolver<Disturbed> disturbed{faulty("disturbed")};
const RegisterSolver<SingleMinded> single_minded{faulty("single-minded")};
const RegisterSolver<BoundaryBlind> boundary_blind{faulty("boundary-blind")};
const RegisterSolver<NotANumber> not_a_number{faulty("not-a-number")};
const RegisterSolver<TwoFaced> two_faced{faulty("two-faced")};
const RegisterSolver<Miscounting> miscounting{faulty("miscounting")};
const RegisterSolver<Mute> mute{faulty("mute")};
const RegisterSolver<Looping> looping{faulty("looping")};
const RegisterSolver<Crashing> crashing{faulty("crashing")};
const RegisterSolver<Throwing> throwing{faulty("throwing")};
const RegisterSolver<Leaving> leaving{faulty("leaving")};
const RegisterSolver<Wrong> tiny{faulty("tiny", 3)};

}  // namespace
}  // namespace geodesic
