// The references that a solver's distances are compared with.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "harness/corpus/manifest.h"
#include "harness/corpus/solvers.h"
#include "harness/verify/distance_check.h"
#include "meshes/oracles/brute_force.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {

/// Names of references that are not solvers, as in a row's `reference`.
inline constexpr const char* kClosedForm = "closed-form";
inline constexpr const char* kBruteForce = "brute force";

/// Largest number of faces on which brute force takes less than a second.
inline constexpr Index kBruteForceFaces = 400;

/// Largest number of faces on which brute force, in some seconds, decides between two references
/// that differ: 1,500, and those that inserted points add.
inline constexpr Index kDecidingFaces = 1600;

/// For more sources, oracles come last. CGAL's time grows with the number of sources: on a plate of
/// 2,068 vertices a run that it verifies takes 0.4 s from one, 16 s from 480 of the boundary.
inline constexpr std::size_t kFewSources = 4;

/// The references that are available in addition to the registered solvers.
struct ReferenceSources {
  std::optional<std::string> named = {};  ///< the exact solver that the user names, or kBruteForce
  bool closed_form = false;               ///< the mesh has one
  bool brute_force = false;               ///< the mesh is small enough
  bool deciding_brute_force = false;      ///< where the first two references differ
  bool many_sources = false;              ///< more than kFewSources: oracles come last
};

/// Exact solvers that can verify another one, best first: the named solver, independent oracles,
/// solvers of other families, faster solvers (unknown speed last), then by name. A `by_name_only`
/// solver that is no oracle must be named. The verified solver with other parameters is left out.
/// Whether a solver supports the mesh is not considered.
std::vector<const Description*> rank_references(const Description& verified,
                                                const std::vector<const Description*>& solvers,
                                                const std::optional<std::string>& named,
                                                const RelativeTimes& times = relative_times());

/// Whether a reference is an independent oracle: code of another project, which may be wrong.
bool is_independent_oracle(const std::string& reference);

/// References that can verify a solver, best first: the named solver, the closed form, brute force,
/// then the other registered solvers in the order of rank_references. Brute force that only decides
/// follows the first two.
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

/// The distances that a solver's are compared with.
struct ReferenceDistances {
  std::string by;              ///< name of a solver, kClosedForm or kBruteForce
  std::vector<double> values;  ///< one per vertex
  std::string remark = {};     ///< one line when `by` contradicts an oracle; otherwise empty
};

/// Chooses the reference; every command and property does so here. It is the first candidate that
/// gives distances, unless that is an independent oracle, which may be wrong: the next candidate
/// must confirm it. Where the two differ, a third decides: the closed form, brute force, or the
/// next solver.
/// @param candidates best first (reference_candidates)
/// @param ask returns the distances of a candidate, or throws NoReference with the reason
/// @param tolerance for the difference of two right references
/// @throws NoReference with the reasons of all candidates
ReferenceDistances choose_reference(
    const std::vector<std::string>& candidates,
    const std::function<std::vector<double>(const std::string& candidate)>& ask,
    const Tolerance& tolerance = {});

/// References that need neither a manifest nor another process: brute force, and the solvers that
/// support the mesh.
class LocalReference {
 public:
  /// The mesh must outlive it.
  LocalReference(const Description& verified, const Mesh& mesh, const Tolerance& tolerance = {});

  /// @throws NoReference when there is none
  ReferenceDistances distances(const Query& query);

  /// For a process that a reference may end. Called with the name of the reference before it
  /// computes, and with an empty name afterwards.
  static inline std::function<void(const std::string& name)> watch = {};

 private:
  std::vector<double> ask(const std::string& candidate, const Query& query);

  const Mesh& mesh_;
  const Tolerance tolerance_;
  std::vector<std::string> candidates_;
  std::shared_ptr<const BruteForce> brute_force_;  // null until it is needed
};

/// Writes distances for another process: raw doubles of this machine, one per vertex.
void write_distances(std::ostream& to, std::span<const double> distances);
/// The same into a file, which is written completely or not at all. @throws HarnessError
void write_distances(const std::filesystem::path& file, std::span<const double> distances);

/// @throws HarnessError when the file does not hold `vertices` distances
std::vector<double> read_distances(const std::filesystem::path& file, std::size_t vertices);

/// Distances from one source after the other, in the format of write_distances: a file that may be
/// larger than memory.
class DistanceRows {
 public:
  /// @throws HarnessError when the file does not hold `rows` times `vertices` distances
  DistanceRows(const std::filesystem::path& file, std::size_t rows, std::size_t vertices);

  /// The distances from the next source, until the next call. @throws HarnessError on a read error
  std::span<const double> next();

 private:
  std::ifstream in_;
  std::string name_;
  std::vector<double> row_;
};

}  // namespace geodesic::harness
