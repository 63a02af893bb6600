// Which distances a solver's are compared with, and where they come from.
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

/// Names of references that are not solvers: what stands in a row's `reference`.
inline constexpr const char* kClosedForm = "closed-form";
inline constexpr const char* kBruteForce = "brute force";

/// Brute force takes less than a second on meshes of so many faces.
inline constexpr Index kBruteForceFaces = 400;

/// CGAL's time grows with the number of sources: on a plate of 2,068 vertices a run that it
/// verifies takes 0.4 s from one of them, 16 s from the 480 of its boundary.
inline constexpr std::size_t kFewSources = 4;

/// The references that there are beside the registered solvers.
struct ReferenceSources {
  std::optional<std::string> named = {};  ///< the exact solver that the user names, or kBruteForce
  bool closed_form = false;               ///< the mesh has one
  bool brute_force = false;               ///< the mesh is small enough
  bool many_sources = false;              ///< more than kFewSources: oracles come last
};

/// Exact solvers that can verify another one, best first: the named one, independent oracles, other
/// families, the faster ones (one of unknown speed last), then by name. One that is `by_name_only`
/// must be named. None is the same solver with other parameters. Whether one supports the mesh is
/// not considered.
std::vector<const Description*> rank_references(const Description& verified,
                                                const std::vector<const Description*>& solvers,
                                                const std::optional<std::string>& named,
                                                const RelativeTimes& times = relative_times());

/// Whether a reference is an independent oracle, which may be wrong and is not ours to repair.
bool is_independent_oracle(const std::string& reference);

/// What can verify a solver, best first: the named solver, the closed form, brute force, then the
/// other registered solvers as rank_references orders them.
std::vector<std::string> reference_candidates(const Description& verified,
                                              const ReferenceSources& sources);

/// A solver whose distances are never too short and that is not `by_name_only`, to bound exact ones
/// from above; null if there is none.
const Description* choose_upper_bound(const std::vector<const Description*>& solvers);

/// Whether the mesh's generator states a closed form.
bool has_closed_form(const MeshEntry& entry);

/// Distances by the closed form from the nearest of the sources; nothing when there is none.
/// @param soup the mesh as it was read from the entry's file
/// @throws HarnessError when the file holds another mesh than the manifest's generator and
///         parameters make, or these are wrong
std::optional<std::vector<double>> closed_form_distances(const MeshEntry& entry,
                                                         const TriangleSoup& soup,
                                                         std::span<const Index> sources);

/// Distances by an object that may have solved before.
std::vector<double> solve_with(Solver& object, const Mesh& mesh, const Query& query,
                               Recording* recording = nullptr);

/// Distances by a new object of a registered solver.
std::vector<double> solve_once(const std::string& solver, const Mesh& mesh, const Query& query,
                               Recording* recording = nullptr);

/// Thrown where no reference supports the mesh.
class NoReference : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a LocalReference may be.
struct Judges {
  Index brute_force_faces = kBruteForceFaces;  ///< up to so many faces it is brute force
  bool oracles = true;                         ///< beyond, an independent oracle comes first
};

/// The best reference that needs neither a manifest nor another process: brute force, or the best
/// ranked solver that supports the mesh.
class LocalReference {
 public:
  /// Both must outlive it.
  LocalReference(const Description& verified, const Mesh& mesh, Judges judges = {});

  /// kBruteForce, a solver's name, or "nothing".
  const std::string& name() const { return name_; }

  bool is_independent() const { return is_independent_oracle(name_); }

  /// @throws NoReference when there is none
  std::vector<double> distances(const Query& query);

  /// For a process that a reference may end: called with its name before it is asked, and with
  /// nothing when it has answered.
  static inline std::function<void(const std::string& name)> watch = {};

 private:
  const Mesh& mesh_;
  std::string name_ = "nothing";
  std::shared_ptr<const BruteForce> brute_force_;  // once it was needed
};

/// Distances between two processes: raw doubles of this machine, one a vertex. Writes the file
/// whole or not at all. @throws HarnessError
void write_distances(const std::filesystem::path& file, std::span<const double> distances);

/// @throws HarnessError when the file does not hold `vertices` distances
std::vector<double> read_distances(const std::filesystem::path& file, std::size_t vertices);

}  // namespace geodesic::harness
