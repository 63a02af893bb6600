// One solver on one case, and what properties need to examine it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/verify/compare.h"
#include "meshes/oracles/brute_force.h"
#include "solvers/core/registry.h"

namespace geodesic::conformance {

/// A mesh and what to ask on it.
struct Case {
  std::string mesh;  ///< what it is called
  TriangleSoup soup;
  std::vector<Query> queries;
  /// Distances that are known; empty: those of the reference.
  std::function<std::vector<double>(const Query&)> known = {};
  /// Another one where the mesh's own numbers allow no better, which the property explains.
  Tolerance tolerance = {};
};

/// A reference: brute force on meshes of up to so many faces, else the best other exact solver
/// (verify/choose.h).
inline constexpr Index kBruteForceFaces = 400;

/// When the right distances are not to be had.
class NoReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Reference {
 public:
  /// Both must outlive it.
  Reference(const Description& verified, const Mesh& mesh) : verified_(verified), mesh_(mesh) {}

  /// @throws NoReference when no other solver can do the mesh
  std::vector<double> distances(const Query& query);

  /// "brute force", or the solver's name.
  std::string name() const;

 private:
  const Description& verified_;
  const Mesh& mesh_;
  std::optional<BruteForce> brute_force_;
};

class Trial {
 public:
  /// Both must outlive it. @throws std::invalid_argument when the mesh cannot be built
  Trial(const Description& solver, const Case& given)
      : solver_(solver), given_(given), mesh_(given.soup), reference_(solver, mesh_) {}
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  const Description& solver() const { return solver_; }
  const Mesh& mesh() const { return mesh_; }
  const TriangleSoup& soup() const { return given_.soup; }
  const std::vector<Query>& queries() const { return given_.queries; }
  /// The first query, and its first source.
  const Query& query() const { return given_.queries.front(); }
  Index source() const { return query().sources.front().vertex; }

  std::unique_ptr<Solver> prepare() const { return prepare(mesh_); }
  std::unique_ptr<Solver> prepare(const Mesh& mesh) const {
    return make_solver(solver_.name, mesh);
  }

  /// Distances by a solver object that has not been used before.
  std::vector<double> solve(const Mesh& mesh, const Query& query) const;
  std::vector<double> solve(const Query& query) const { return solve(mesh_, query); }

  /// The right distances on the case's mesh.
  std::vector<double> expected(const Query& query) const;

  /// Equal up to rounding for an exact solver, not below for an upper bound.
  Finding correct(const Query& query, std::span<const double> got,
                  std::span<const double> want) const;

  const Tolerance& tolerance() const { return given_.tolerance; }

 private:
  const Description& solver_;
  const Case& given_;
  const Mesh mesh_;
  mutable Reference reference_;  // what it found out about the mesh
};

/// Distances by a solver object that may have been used before.
std::vector<double> ask(Solver& solver, const Mesh& mesh, const Query& query,
                        Recording* recording = nullptr);

Query from(Index source);
Query from(const std::vector<Index>& sources);
Query within(double limit, Query query);

/// Entry by entry the smaller one.
std::vector<double> least(std::vector<double> a, const std::vector<double>& b);

}  // namespace geodesic::conformance
