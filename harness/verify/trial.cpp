#include "harness/verify/trial.h"

#include <algorithm>

#include "harness/corpus/solvers.h"
#include "harness/verify/choose.h"

namespace geodesic::conformance {
namespace {

// Null when there is none.
const Description* rival_of(const Description& verified, const Mesh& mesh) {
  for (const Description* rival :
       harness::rank_references(verified, registered_solvers(), std::nullopt)) {
    if (harness::unsupported(*rival, mesh).empty()) return rival;
  }
  return nullptr;
}

}  // namespace

std::vector<double> Reference::distances(const Query& query) {
  std::vector<double> distances;
  if (mesh_.face_count() <= kBruteForceFaces) {
    if (!brute_force_) brute_force_.emplace(mesh_);
    distances = brute_force_->distances(query.sources);
  } else {
    const Description* rival = rival_of(verified_, mesh_);
    if (rival == nullptr) {
      throw NoReference("no other exact solver can do this mesh of " +
                        std::to_string(mesh_.face_count()) +
                        " faces, which is too large for brute force");
    }
    distances = ask(*make_solver(rival->name, mesh_), mesh_, {.sources = query.sources});
  }
  for (double& d : distances) d = d > query.limit ? kInfinity : d;
  return distances;
}

std::string Reference::name() const {
  if (mesh_.face_count() <= kBruteForceFaces) return "brute force";
  const Description* rival = rival_of(verified_, mesh_);
  return rival == nullptr ? "nothing" : rival->name;
}

std::vector<double> Trial::solve(const Mesh& mesh, const Query& query) const {
  return ask(*prepare(mesh), mesh, query);
}

std::vector<double> Trial::expected(const Query& query) const {
  return given_.known ? given_.known(query) : reference_.distances(query);
}

Finding Trial::correct(const Query& query, std::span<const double> got,
                       std::span<const double> want) const {
  return (solver_.exactness == Exactness::exact ? agree : bound_from_above)(query, got, want,
                                                                            given_.tolerance);
}

std::vector<double> ask(Solver& solver, const Mesh& mesh, const Query& query,
                        Recording* recording) {
  std::vector<double> distances(mesh.vertex_count());
  solver.solve(query, distances, recording);
  return distances;
}

Query from(Index source) { return from(std::vector<Index>{source}); }

Query from(const std::vector<Index>& sources) {
  Query query;
  for (const Index v : sources) query.sources.push_back({v, 0});
  return query;
}

Query within(double limit, Query query) {
  query.limit = limit;
  return query;
}

std::vector<double> least(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t v = 0; v < a.size(); ++v) a[v] = std::min(a[v], b[v]);
  return a;
}

}  // namespace geodesic::conformance
