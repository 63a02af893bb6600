// The contract between solvers and their users, on one page.
//
// Constructing a solver prepares it for one mesh (timed apart). It then answers any number of
// queries. Each object owns the state that `solve` changes: only one thread at a time may use it.
// Objects share only constant data (the mesh, their description), so different objects may solve in
// different threads at the same time.
//
// Layers of this folder: solver.h, contract.h, registry.h and prepared_file.h are the contract.
// They include the other headers; no other header includes them.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solvers/core/instruction_set.h"
#include "solvers/core/mesh.h"
#include "solvers/core/parameters.h"
#include "solvers/core/path.h"
#include "solvers/core/recording.h"
#include "solvers/core/start.h"

namespace geodesic {

class PreparedReader;
class PreparedWriter;

/// What a solver guarantees about its distances. In every case they are infinite where no path
/// leads; at a source they are its initial distance, or less if another source is nearer.
enum class Exactness {
  exact,        ///< the geodesic distance up to rounding (1e-12 relative on clean meshes)
  bounded,      ///< relative error of at most Description::error_bound
  upper_bound,  ///< never less than the geodesic distance
  unbounded,    ///< no other guarantee: its error is measured, and no error counts as wrong
};

/// What a solver can do. Asking for more is an error that names the missing ability.
struct Abilities {
  bool multiple_sources = true;
  bool initial_distances = true;
  bool distance_limit = true;
  bool non_manifold_vertices = true;  ///< several fans of faces at one vertex
  bool degenerate_faces = true;       ///< zero-length edges, zero-area faces
  bool non_manifold_edges = false;  ///< paths cross edges of more than two faces, into each of them
  bool concurrent_objects = true;   ///< objects may solve in several threads at the same time
  bool surface_sources = false;     ///< sources on edges and faces; else at vertices only
  bool paths = false;               ///< records the last segments of paths (RecordingKind::paths)
  bool saves = false;               ///< preparation can be saved; set by the registry
  bool traces = false;              ///< traces paths by a method of its own (Solver::trace)
  Index max_vertices = kNone;       ///< larger meshes take unreasonably long
};

/// What is known of a solver: its name, guarantees, abilities and parameters.
struct Description {
  std::string name;            ///< lower case with hyphens, unique: "fwp-mmp"
  std::string family;          ///< "MMP", "CH", "edge-based", ...
  std::string paper;           ///< the work to cite: author-year, title
  bool final_windows = false;  ///< keeps the windows of all edges, and returns them
  Exactness exactness = Exactness::exact;
  /// The largest relative error of a bounded solver with the parameters of this description.
  double (*error_bound)(const Description&) = nullptr;
  /// The same query gives the same bits every time; false for parallel codes that do not guarantee
  /// it.
  bool deterministic = true;
  /// Shares no kernel with others: preferred for verification, also where it runs by name only.
  bool independent_oracle = false;
  /// Runs, and verifies others unless it is an oracle, only when it is named. The build sets it for
  /// solvers/variants/.
  bool by_name_only = false;
  int threads = 1;             ///< threads of a solve, unless there is a parameter `threads`
  bool needs_renewal = false;  ///< keeps state of a query: Solver::renew before the next one
  Abilities abilities = {};
  std::string remarks = {};  ///< licence of what it links, limits, anything a user must know
  /// Numbers and choices, in the order in which names show them: "avtp?lambda=32&threads=2".
  std::vector<ParameterDescription> parameters = {};
  /// Values of the parameters that are not at their default. The registry sets them, and makes
  /// `name` canonical. A solver reads them by the functions below.
  ParameterValues values = {};

  /// @throws std::out_of_range when no such parameter is described
  double real(std::string_view parameter) const;
  Index integer(std::string_view parameter) const { return static_cast<Index>(real(parameter)); }
  std::string text(std::string_view parameter) const;

  int thread_count() const;
};

/// Errors that a solver has measured on its own mesh while it was prepared.
struct Certificate {
  Index sources = 0;  ///< random vertices whose distances were compared with an exact solver's
  /// Relative errors over all vertices that are reached, the sources left out.
  double mean_error = 0, largest_error = 0;
};

/// Computes distances on one mesh. A solver family derives from it and implements `run`,
/// and `record` if it records anything.
class Solver {
 public:
  virtual ~Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;

  /// Writes the distance of every vertex, in the mesh's unit of length and in the order in which
  /// the vertices were given. It is +infinity where no path leads or the limit is exceeded. The
  /// same query gives the same bits every time.
  /// @param distances one entry per vertex
  /// @param recording null for a timed solve, which then carries no instrumentation; otherwise
  ///        filled with what the solver counts, which replaces what an earlier solve recorded; no
  ///        distance changes
  /// @throws std::invalid_argument when the query has no source, a source or target that is not in
  ///        the mesh, a negative or non-finite initial distance or a negative limit; stops at
  ///        targets and has none; or needs an ability that the solver lacks; when `recording` is
  ///        for windows or paths that the solver does not keep; or when `distances` has the wrong
  ///        size
  void solve(const Query& query, std::span<double> distances, Recording* recording = nullptr);

  /// Returns a path to a vertex, of a solver that traces paths itself. Its length is guaranteed
  /// only as far as the solver's description says.
  /// @param query, distances query and result of the last solve of this object
  /// @throws std::invalid_argument when the solver lacks Abilities::traces, the mesh has no such
  ///        vertex, no path leads there, or `distances` has the wrong size; and any exception of
  ///        the solver
  Path trace(const Query& query, std::span<const double> distances, Index vertex);

  /// Prepares an object that has answered a query for the next one, if its description says that it
  /// needs renewal; otherwise does nothing. `solve` calls it itself. To time it apart from the
  /// solve, call it before the solve.
  void renew();

  /// Returns another object with the same preparation, for another thread. It may be called while
  /// this object solves. Solvers whose preparation takes long share it; others prepare anew.
  virtual std::unique_ptr<Solver> another() const;

  /// Writes the preparation, of a solver with Abilities::saves (core/prepared_file.h).
  virtual void save(PreparedWriter& /*to*/) const {}

  /// Errors measured during preparation; none unless a parameter of the solver requested it.
  virtual std::optional<Certificate> certificate() const { return std::nullopt; }

  const Mesh& mesh() const { return mesh_; }
  const Description& description() const { return description_; }

  /// The vector instructions that this object solves with: those chosen when it was constructed
  /// (core/instruction_set.h), as far as the solver is compiled for them.
  virtual InstructionSet instruction_set() const { return InstructionSet::plain; }

 protected:
  /// @param description must outlive the solver (registered descriptions do)
  /// @throws std::invalid_argument when the mesh needs an ability that the solver lacks
  Solver(const Mesh& mesh, const Description& description);

 private:
  /// A timed solve, in the mesh's internal numbers. The query is already checked, and `distances`
  /// filled with +infinity. Distances above the limit or the farthest target's may remain; they are
  /// cleared afterwards. A solver that does not stop there (StopRule) only takes longer.
  virtual void run(const Start& start, std::span<double> distances) = 0;

  /// The same with a recording, of a kind that the description does not exclude. A solver that
  /// counts nothing leaves it empty.
  virtual void record(const Start& start, std::span<double> distances, Recording& /*recording*/) {
    run(start, distances);
  }

  /// As `trace`: returns the points of the path, from a source on, in the mesh's internal numbers.
  /// A straight line joins each point with the next one.
  /// @param vertex its distance is finite
  virtual std::vector<InternalPoint> trace_path(const InternalQuery& query,
                                                std::span<const double> distances, Index vertex);

  /// Discards the state of the last query, which some public codes keep in their mesh.
  virtual void renew_state() {}

  /// Calls `run` or `record` with fresh distances, and clears those beyond the limit.
  void run_to_end(const Start& start, std::span<double> distances, Recording* recording);

  const Mesh& mesh_;
  const Description& description_;
  bool used_ = false;                  // since construction or renewal
  std::vector<double> in_mesh_order_;  // scratch memory for a renumbered mesh
};

}  // namespace geodesic
