// The references that a solver's distances are compared with.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "meshes/oracles/brute_force.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {

/// Names of references that are not solvers, as in a row's `reference`.
inline constexpr const char* kClosedForm = "closed-form";
inline constexpr const char* kBruteForce = "brute force";

/// Largest number of faces on which brute force takes less than a second.
inline constexpr Index kBruteForceFaces = 400;

/// For more sources, oracles come last. CGAL's time grows with the number of sources: on a plate of
/// 2,068 vertices a run that it verifies takes 0.4 s from one, 16 s from 480 of the boundary.
inline constexpr std::size_t kFewSources = 4;

/// The references that are available in addition to the registered solvers.
struct ReferenceSources {
  std::optional<std::string> named = {};  ///< the exact solver that the user names, or kBruteForce
  bool closed_form = false;               ///< the mesh has one
  bool brute_force = false;               ///< the mesh is small enough
  bool many_sources = false;              ///< more than kFewSources: oracles come last
};

/// Exact solvers that can verify another one, best first: the named solver, independent oracles,
/// solvers of other families, faster solvers (unknown speed last), then by name. A `by_name_only`
/// solver that is no oracle must be named. The verified solver with other parameters is left out. Whether a solver
/// supports the mesh is not considered.
std::vector<const Description*> rank_references(const Description& verified,
                                                const std::vector<const Description*>& solvers,
                                                const std::optional<std::string>& named,
                                                const RelativeTimes& times = relative_times());

/// Whether a reference is an independent oracle: code of another project, which may be wrong.
bool is_independent_oracle(const std::string& reference);

/// References that can verify a solver, best first: the named solver, the closed form, brute force,
/// then the other registered solvers in the order of rank_references.
std::vector<std::string> reference_candidates(const Description& verified,
                                              const ReferenceSources& sources);

/// A solver of upper bounds that is not `by_name_only`, to bound exact distances; null if there is
/// none.
const Description* choose_upper_bound(const std::vector<const Description*>& solvers);

/// Whether the mesh's generator states a closed form.
bool has_closed_form(const MeshEntry& entry);

/// Distances by the closed form from the nearest source; nothing when the mesh has no closed form.
/// @param soup the mesh as it was read from the entry's file
/// @throws HarnessError when the file's mesh differs from that of the manifest's generator and
///         parameters, or the parameters are wrong
std::optional<std::vector<double>> closed_form_distances(const MeshEntry& entry,
                                                         const TriangleSoup& soup,
                                                         std::span<const Index> sources);

/// Distances by an object that may have solved before.
std::vector<double> solve_with(Solver& object, const Mesh& mesh, const Query& query,
                               Recording* recording = nullptr);

/// Distances by a new object of a registered solver.
std::vector<double> solve_once(const std::string& solver, const Mesh& mesh, const Query& query,
                               Recording* recording = nullptr);

/// Thrown when no reference supports the mesh.
class NoReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The references that a LocalReference chooses from.
struct Judges {
  Index brute_force_faces = kBruteForceFaces;  ///< most faces for brute force
  bool oracles = true;                         ///< whether independent oracles are allowed
};

/// The best reference that needs neither a manifest nor another process: brute force, or the best
/// ranked solver that supports the mesh.
class LocalReference {
 public:
  /// The mesh must outlive it.
  LocalReference(const Description& verified, const Mesh& mesh, Judges judges = {});

  /// kBruteForce, a solver's name, or "nothing".
  const std::string& name() const { return name_; }

  bool is_independent() const { return is_independent_oracle(name_); }

  /// @throws NoReference when there is none
  std::vector<double> distances(const Query& query);

  /// For a process that a reference may end. Called with the name of the reference before it
  /// computes, and with an empty name afterwards.
  static inline std::function<void(const std::string& name)> watch = {};

 private:
  const Mesh& mesh_;
  std::string name_ = "nothing";
  std::shared_ptr<const BruteForce> brute_force_;  // null until it is needed
};

/// Writes distances for another process: raw doubles of this machine, one per vertex. The file is
/// written completely or not at all. @throws HarnessError
void write_distances(const std::filesystem::path& file, std::span<const double> distances);

/// @throws HarnessError when the file does not hold `vertices` distances
std::vector<double> read_distances(const std::filesystem::path& file, std::size_t vertices);

}  // namespace geodesic::harness
