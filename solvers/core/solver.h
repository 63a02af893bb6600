// The contract between solvers and their users, on one page.
//
// A solver is constructed for one mesh (its preparation, timed apart) and then answers any number
// of queries. It owns all its state, which `solve` changes: one object belongs to one thread at a
// time. What objects share is constant (the mesh, their description), so that any number of them
// may solve in as many threads.
//
// Layers of this folder: solver.h, contract.h, registry.h and rescaled.h are the contract. They
// include the other headers; no other header includes them.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solvers/core/instruction_set.h"
#include "solvers/core/mesh.h"
#include "solvers/core/parameters.h"
#include "solvers/core/recording.h"

namespace geodesic {

/// A point that distances are measured from. Points on edges and faces will be other members of
/// this struct; today a source is a vertex.
struct Source {
  Index vertex = kNone;
  double distance = 0;  ///< initial distance at the source, >= 0, finite
};

/// A problem: the distances from the nearest of some sources.
struct Query {
  std::vector<Source> sources;  ///< at least one; the result is the least over them
  double limit = kInfinity;     ///< vertices farther than this are reported as unreachable

  std::vector<Index> source_vertices() const {
    std::vector<Index> vertices;
    for (const Source& source : sources) vertices.push_back(source.vertex);
    return vertices;
  }
};

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
  bool concurrent_objects = true;     ///< objects may solve in several threads at the same time
  Index max_vertices = kNone;         ///< larger meshes take unreasonably long
};

/// A solver as data: the rows of the thesis's Table 5.3, and what `geodesic-bench list` prints.
struct Description {
  std::string name;             ///< lower case with hyphens, unique: "fwp-mmp"
  std::string family;           ///< "MMP", "CH", "edge-based", ...
  std::string paper;            ///< author-year, title
  std::string data_structure;   ///< what orders the propagation: "priority queue"
  std::string time_complexity;  ///< as in Table 5.3: "O(n^2 log n)"
  std::string space_complexity;
  std::string propagation;     ///< unit of propagation: "window", "edge", "vertex"
  bool spatial_order = false;  ///< windows of an edge are available in spatial order
  bool final_windows = false;  ///< keeps the windows of all edges, and hands them over
  Exactness exactness = Exactness::exact;
  /// Of a bounded solver: the largest relative error with the parameters of this description.
  double (*error_bound)(const Description&) = nullptr;
  /// The same query gives the same bits every time; false for parallel codes that do not promise
  /// it.
  bool deterministic = true;
  bool independent_oracle = false;  ///< shares no kernel with the others: first choice to verify by
  double relative_time = 0;         ///< of a solve of a scan of 50,000 vertices, measured, that of
                                    ///< the fastest solver being 1; 0: not known
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
  /// @throws std::invalid_argument when the query is empty, has a source that is not in the mesh,
  /// has
  ///         a negative or non-finite initial distance or a negative limit, or needs an ability
  ///         the solver lacks; when it is to record windows and does not keep them; or when
  ///         `distances` has the wrong size
  void solve(const Query& query, std::span<double> distances, Recording* recording = nullptr);

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
  /// As `solve` in the mesh's own numbering, with the query already checked and `distances` filled
  /// with +infinity. May leave distances above the limit; they are cleared afterwards.
  virtual void run(const Query& query, std::span<double> distances, Recording* recording) = 0;

  /// Drops what is left of the last query: of public codes that keep it in their mesh.
  virtual void renew_state() {}

  void solve_renumbered(Query query, std::span<double> distances, Recording* recording);

  const Mesh& mesh_;
  const Description& description_;
  bool used_ = false;                  // since it was made or renewed
  std::vector<double> in_mesh_order_;  // scratch of solve_renumbered
};

}  // namespace geodesic
