// The contract between solvers and their users, on one page.
//
// A solver is constructed for one mesh (its preparation, timed apart) and then answers any number
// of queries. It owns all its state, which `solve` changes: one object belongs to one thread at a
// time. What objects share is constant (the mesh, their description), so that any number of them
// may solve in as many threads.
//
// Layers of this folder: solver.h, contract.h and registry.h are the contract. They include the
// other headers; no other header includes them.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solvers/core/instruction_set.h"
#include "solvers/core/mesh.h"
#include "solvers/core/parameters.h"
#include "solvers/core/path.h"
#include "solvers/core/query.h"
#include "solvers/core/recording.h"

namespace geodesic {

/// What a solver promises of its distances. Whatever it promises, they are 0 at sources and
/// infinite where no path leads.
enum class Exactness {
  exact,        ///< the geodesic distance up to rounding (1e-12 relative on clean meshes)
  bounded,      ///< of a relative error of at most Description::error_bound
  upper_bound,  ///< never less than the geodesic distance
  unbounded,    ///< no more: its error is measured, and never wrong
};

/// What a solver can do; asking for more is an error that names the missing ability.
struct Abilities {
  bool multiple_sources = true;
  bool initial_distances = true;
  bool distance_limit = true;
  bool non_manifold_vertices = true;  ///< several fans of faces at one vertex
  bool degenerate_faces = true;       ///< zero-length edges, zero-area faces
  bool non_manifold_edges = false;    ///< crosses edges of more than two faces, into each of them
  bool concurrent_objects = true;     ///< objects may solve in several threads at the same time
  bool surface_sources = false;       ///< sources on edges and faces; else at vertices only
  bool paths = false;                 ///< remembers how paths arrive (RecordingKind::paths)
  bool traces = false;                ///< has means of its own to trace paths (Solver::trace)
  Index max_vertices = kNone;         ///< larger meshes take unreasonably long
};

/// A solver as data: its name, what it promises and can do, and its parameters.
struct Description {
  std::string name;            ///< lower case with hyphens, unique: "fwp-mmp"
  std::string family;          ///< "MMP", "CH", "edge-based", ...
  std::string paper;           ///< whom to cite: author-year, title
  bool final_windows = false;  ///< keeps the windows of all edges, and hands them over
  Exactness exactness = Exactness::exact;
  /// Of a bounded solver: the largest relative error with the parameters of this description.
  double (*error_bound)(const Description&) = nullptr;
  /// The same query gives the same bits every time; false for parallel codes that do not promise
  /// it.
  bool deterministic = true;
  bool independent_oracle = false;  ///< shares no kernel with the others: first choice to verify by
  bool by_name_only = false;  ///< a variant or an example, which runs and verifies others only when
                              ///< named; set by the build for what lies in solvers/variants/
  int threads = 1;  ///< that a solve uses; the parameter `threads` says so where there is one
  bool needs_renewal = false;  ///< keeps state of a query: Solver::renew before the next one
  Abilities abilities = {};
  std::string remarks = {};  ///< licence of what it links, limits, anything a user must know
  /// Numbers and choices, in the order in which names show them: "avtp?lambda=32&threads=2".
  std::vector<ParameterDescription> parameters = {};
  /// Of those that are not at their default; set by the registry, which also makes `name` the
  /// canonical one. A solver reads them by the functions below.
  ParameterValues values = {};

  /// @throws std::out_of_range when no such parameter is described
  double real(std::string_view parameter) const;
  Index integer(std::string_view parameter) const { return static_cast<Index>(real(parameter)); }
  std::string text(std::string_view parameter) const;

  int thread_count() const;
};

/// Distances over one mesh; a solver family derives from it and implements `run`.
class Solver {
 public:
  virtual ~Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// Writes the distance of every vertex, in the order in which the mesh was given its vertices and
  /// in its unit of length, +infinity where no path leads or the limit is exceeded. The same query
  /// gives the same bits every time.
  /// @param distances one entry a vertex
  /// @param recording null for a timed solve, which then carries no instrumentation; otherwise
  ///        filled with what the solver can count, without changing any distance
  /// @throws std::invalid_argument when the query is empty, has a source or target that is not in
  ///         the mesh, a negative or non-finite initial distance or a negative limit, or nothing to
  ///         stop at, or needs an ability the solver lacks; when it is to record windows or paths
  ///         and does not keep them; or when `distances` has the wrong size
  void solve(const Query& query, std::span<double> distances, Recording* recording = nullptr);

  /// A path to a vertex, of a solver that traces paths itself. Nothing is promised of its length
  /// but what the solver's description says.
  /// @param query, distances the last solve of this object, and what it gave
  /// @throws std::invalid_argument when the solver does not claim it (Abilities::traces), the mesh
  ///         has no such vertex, or no path leads there; and what the solver throws
  Path trace(const Query& query, std::span<const double> distances, Index vertex);

  /// Makes an object that has answered a query ready for the next one, where its description says
  /// that it needs renewal; otherwise nothing. `solve` does so by itself. Who times solves calls it
  /// before, and times it apart.
  void renew();

  /// The vector instructions that this object solves with: those chosen when it was constructed
  /// (core/instruction_set.h), as far as the solver is compiled for them.
  virtual InstructionSet instruction_set() const { return InstructionSet::plain; }

 protected:
  /// @param description must outlive the solver (registered descriptions do)
  /// @throws std::invalid_argument when the mesh needs an ability that the solver lacks
  Solver(const Mesh& mesh, const Description& description);
  const Mesh& mesh() const { return mesh_; }

 private:
  /// As `solve` in the mesh's internal numbers, with the query already checked and `distances`
  /// filled with +infinity. May leave distances above the limit or the farthest target's; they are
  /// cleared afterwards. Whoever does not end there (StopRule) only takes longer.
  virtual void run(const InternalQuery& query, std::span<double> distances,
                   Recording* recording) = 0;

  /// As `trace`: the points of the path, from a source on, in the mesh's internal numbers. A
  /// straight line joins each with the next one.
  /// @param vertex one that has a distance
  virtual std::vector<InternalPoint> trace_path(const InternalQuery& query,
                                                std::span<const double> distances, Index vertex);

  /// Drops what is left of the last query: of public codes that keep it in their mesh.
  virtual void renew_state() {}

  /// `run` from fresh distances, without what lies beyond the limit.
  void run_to_end(const InternalQuery& query, std::span<double> distances, Recording* recording);

  const Mesh& mesh_;
  const Description& description_;
  bool used_ = false;                  // since it was made or renewed
  std::vector<double> in_mesh_order_;  // scratch of a renumbered mesh
};

}  // namespace geodesic
