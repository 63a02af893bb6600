// The properties that every solver must have. A property states one fact about answers and has its
// own meshes. Most properties can be checked on any other mesh, too.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "harness/verify/distance_check.h"
#include "harness/verify/references.h"

namespace geodesic::harness {

/// A mesh and the queries on it.
struct Case {
  std::string mesh;  ///< name
  TriangleSoup soup;
  std::vector<Query> queries;
  /// Returns the right distances of a query; empty: those of LocalReference are right.
  std::function<std::vector<double>(const Query&)> known = {};
  /// Larger than the default where the mesh's internal numbers require it; the property says why.
  Tolerance tolerance = {};
  /// Behaviour of paths at non-manifold edges.
  NonManifoldEdges non_manifold_edges = NonManifoldEdges::cut;

  /// @throws std::invalid_argument when it cannot be built
  Mesh build() const { return Mesh(soup, Numbering::as_given, non_manifold_edges); }
};

/// One solver on one case.
class Trial {
 public:
  /// Both must outlive the trial. @throws std::invalid_argument when the mesh cannot be built
  Trial(const Description& solver, const Case& given)
      : solver_(solver),
        given_(given),
        mesh_(given.build()),
        reference_(solver, mesh_, given.tolerance) {}
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

  /// Checks that distances keep the solver's promise (distance_check.h).
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
  mutable LocalReference reference_;  // caches brute force on the mesh
  mutable double largest_error_ = 0;
};

/// Checks that all distances by one solver object keep the solver's promise, and that exact
/// distances of neighbours differ by at most the length of their edge.
/// @throws Violation
void distances_are_right(const Trial& trial);

/// Claims of a solver about itself that a property needs, as bits.
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
  kNonManifoldEdges = 2048,  ///< the property's cases are built with them crossed
  kTraces = 4096,            ///< traces paths by its own code
};

struct Property {
  std::string name;              ///< unique: "refusals-name-the-solver"
  std::string statement;         ///< one sentence
  std::vector<Case> (*cases)();  ///< small meshes first
  /// Checks one case by `require` and `refused` (properties.h). Throws a Violation when the
  /// property does not hold.
  void (*check)(const Trial& trial) = distances_are_right;
  unsigned needs = kNoClaim;  ///< claims
  bool on_any_mesh = true;    ///< whether it holds on other meshes than its own
};

/// All properties, the fast ones first.
const std::vector<Property>& all_properties();

/// @throws HarnessError for an unknown name; the message lists the known ones
const Property& property_named(std::string_view name);

/// The property that is checked on a user's mesh: distances equal those of the reference.
inline constexpr const char* kDistancesProperty = "distances-equal-the-reference";

/// The property's needs in words: "a distance limit".
std::vector<std::string> needs_of(const Property& property);

/// "does not promise: a distance limit, multiple sources"; empty when the solver promises all
/// needs.
std::string unclaimed(const Property& property, const Description& solver);

/// Whether the mesh has more vertices than the solver is meant for. Such cases are skipped.
bool too_large(const Case& given, const Description& solver);

/// Prefix of a violation's text when the solver threw an exception.
inline constexpr const char* kThrew = "threw: ";

/// Thrown when a property has nothing to compare on a case: it neither holds nor fails there.
class NothingCompared : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Checks one case. The solver must refuse a mesh that it declares unsupported. An exception of the
/// solver is a violation.
/// @param largest_error raised to Trial::largest_error; may be null
/// @throws NoReference, NothingCompared
Finding check_case(const Property& property, const Description& solver, const Case& given,
                   double* largest_error = nullptr);

/// Role of the vertex for paths from the query's sources: "source", "boundary vertex", "saddle
/// vertex", "isolated vertex" or "ordinary vertex".
std::string role_of(Index v, const Mesh& mesh, const Query& query);

Query from(Index source);
Query from(const std::vector<Index>& sources);

}  // namespace geodesic::harness
