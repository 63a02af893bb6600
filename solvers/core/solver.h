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

enum class Exactness {
  exact,        ///< the geodesic distance up to rounding (1e-12 relative on clean meshes)
  upper_bound,  ///< never less than the geodesic distance
};

/// What a solver can do; asking for more is an error that names the missing ability.
struct Abilities {
  bool multiple_sources = true;
  bool initial_distances = true;
  bool distance_limit = true;
  bool non_manifold_vertices = true;  ///< several fans of faces at one vertex
  bool degenerate_faces = true;       ///< zero-length edges, zero-area faces
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
  bool independent_oracle = false;  ///< shares no kernel with the others: first choice to verify by
  double relative_time = 0;         ///< of a solve of a scan of 50,000 vertices, measured, that of
                                    ///< the fastest solver being 1; 0: not known
  bool by_name_only = false;  ///< a variant or an example, which runs and verifies others only when
                              ///< named; set by the build for what lies in solvers/variants/
  Abilities abilities = {};
  std::string remarks = {};  ///< licence of what it links, limits, anything a user must know
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

  void solve_renumbered(Query query, std::span<double> distances, Recording* recording);

  const Mesh& mesh_;
  const Description& description_;
  std::vector<double> in_mesh_order_;  // scratch of solve_renumbered
};

}  // namespace geodesic
