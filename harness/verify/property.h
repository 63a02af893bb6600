// What every solver is held to, as data: a property states one thing about answers, has meshes of
// its own that it is checked on, and most can be checked on any other mesh.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "harness/verify/distance_check.h"
#include "harness/verify/references.h"

namespace geodesic::harness {

/// A mesh and the queries on it.
struct Case {
  std::string mesh;  ///< its name
  TriangleSoup soup;
  std::vector<Query> queries;
  /// Distances that are known; empty: those of LocalReference.
  std::function<std::vector<double>(const Query&)> known = {};
  /// Another one where the mesh's internal numbers allow no better, which the property explains.
  Tolerance tolerance = {};
  /// What paths do at the mesh's edges that are no manifold's.
  NonManifoldEdges non_manifold_edges = NonManifoldEdges::cut;
  /// Whose distances are right where none are known.
  Judges judges = {};

  /// @throws std::invalid_argument when it cannot be built
  Mesh build() const { return Mesh(soup, Numbering::as_given, non_manifold_edges); }
};

/// One solver on one case.
class Trial {
 public:
  /// Both must outlive it. @throws std::invalid_argument when the mesh cannot be built
  Trial(const Description& solver, const Case& given)
      : solver_(solver),
        given_(given),
        mesh_(given.build()),
        reference_(solver, mesh_, given.judges) {}
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  const Description& solver() const { return solver_; }
  const Mesh& mesh() const { return mesh_; }
  const TriangleSoup& soup() const { return given_.soup; }
  const Tolerance& tolerance() const { return given_.tolerance; }
  const std::vector<Query>& queries() const { return given_.queries; }
  const Query& query() const { return queries().front(); }  ///< the first

  /// A new solver object.
  std::unique_ptr<Solver> prepare() const { return make_solver(solver_.name, mesh_); }

  /// Distances on the case's mesh by an object that may have solved before.
  std::vector<double> solve(Solver& object, const Query& query,
                            Recording* recording = nullptr) const {
    return solve_with(object, mesh_, query, recording);
  }

  /// Distances by a new object, on the case's mesh or another one.
  std::vector<double> solve(const Query& query) const { return solve(mesh_, query); }
  std::vector<double> solve(const Mesh& mesh, const Query& query,
                            Recording* recording = nullptr) const {
    return solve_once(solver_.name, mesh, query, recording);
  }

  /// The right distances on the case's mesh. @throws NoReference
  std::vector<double> expected(const Query& query) const;

  /// The same on a finer mesh.
  LocalReference reference_on(const Mesh& finer) const {
    LocalReference reference(solver_, finer, given_.judges);
    oracle_judges_ |= reference.is_independent();
    return reference;
  }
  /// Whether an independent oracle says what is right, which is not ours to repair.
  bool oracle_judges() const {
    return oracle_judges_ || (!given_.known && reference_.is_independent());
  }

  /// What the solver promises (distance_check.h).
  Finding correct(const Query& query, std::span<const double> got,
                  std::span<const double> expected) const {
    return correct(query, got, expected, given_.tolerance);
  }
  Finding correct(const Query& query, std::span<const double> got, std::span<const double> expected,
                  const Tolerance& tolerance) const;

  /// The largest relative error that `correct` has seen in exact distances.
  double largest_error() const { return largest_error_; }

 private:
  const Description& solver_;
  const Case& given_;
  const Mesh mesh_;
  mutable LocalReference reference_;  // keeps what it found out about the mesh
  mutable bool oracle_judges_ = false;
  mutable double largest_error_ = 0;
};

/// Every distance, by one solver object for all queries, is what the solver promises; exact ones of
/// neighbours differ by no more than their edge is long.
/// @throws Violation
void distances_are_right(const Trial& trial);

/// What a solver must claim about itself for a property to concern it: bits.
enum Claim : unsigned {
  kNoClaim = 0,
  kExactDistances = 1,
  kMultipleSources = 2,
  kInitialDistances = 4,
  kDistanceLimit = 8,
  kFinalWindows = 16,
  kNoFinalWindows = 32,
  kOwnKernel = 64,  ///< not an independent oracle
  kSameBits = 128,  ///< deterministic
  kConcurrentObjects = 256,
  kSurfaceSources = 512,
  kPaths = 1024,
  kNonManifoldEdges = 2048,  ///< its cases are to be built with them crossed
  kTraces = 4096,            ///< traces paths by means of its own
};

struct Property {
  std::string name;              ///< unique: "refusals-name-the-solver"
  std::string statement;         ///< one sentence
  std::vector<Case> (*cases)();  ///< small meshes first
  /// On one case. Throws a Violation where the property does not hold.
  void (*check)(const Trial& trial) = distances_are_right;
  unsigned needs = kNoClaim;  ///< claims
  bool on_any_mesh = true;    ///< whether it holds on other meshes than its own
};

/// All of them, the fast ones first.
const std::vector<Property>& all_properties();

/// @throws HarnessError naming the known ones
const Property& property_named(std::string_view name);

/// Distances equal those of the reference: what is checked on a user's mesh.
inline constexpr const char* kDistancesProperty = "distances-equal-the-reference";

/// In words: "a distance limit".
std::vector<std::string> needs_of(const Property& property);

/// "does not claim: a distance limit, multiple sources"; empty when the property concerns it.
std::string unclaimed(const Property& property, const Description& solver);

/// Whether the mesh has more vertices than the solver is meant for: such cases are passed over.
bool too_large(const Case& given, const Description& solver);

/// What stands in front of the message of an exception.
inline constexpr const char* kThrew = "threw: ";

/// Checks one case. A mesh that the solver declares not to support must be refused. What the solver
/// throws is a violation. An independent oracle may be wrong: where a solver differs from it, brute
/// force says which on up to 1,500 faces, in some seconds, and another exact solver beyond.
/// @param largest_error raised to Trial::largest_error
/// @throws NoReference
Finding check_case(const Property& property, const Description& solver, const Case& given,
                   double* largest_error = nullptr);

/// What the vertex is to paths from the query's sources: "source", "boundary vertex", "saddle
/// vertex", "isolated vertex", "ordinary vertex".
std::string role_of(Index v, const Mesh& mesh, const Query& query);

Query from(Index source);
Query from(const std::vector<Index>& sources);

}  // namespace geodesic::harness
