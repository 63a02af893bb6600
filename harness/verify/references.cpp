#include "harness/verify/references.h"

#include <algorithm>
#include <deque>
#include <tuple>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "meshes/connectivity.h"
#include "meshes/generators/generators.h"

namespace geodesic::harness {

std::vector<const Description*> rank_references(const Description& verified,
                                                const std::vector<const Description*>& solvers,
                                                const std::optional<std::string>& named,
                                                const RelativeTimes& times) {
  std::vector<const Description*> candidates;
  for (const Description* solver : solvers) {
    if (solver->exactness != Exactness::exact) continue;
    if (base_name(solver->name) == base_name(verified.name)) continue;
    if (!solver->by_name_only || solver->independent_oracle || solver->name == named) {
      candidates.push_back(solver);
    }
  }
  std::ranges::sort(candidates, {}, [&](const Description* solver) {
    const double time = relative_time(*solver, times);
    return std::tuple(solver->name != named, !solver->independent_oracle,
                      solver->family == verified.family, time > 0 ? time : kInfinity, solver->name);
  });
  return candidates;
}

bool is_independent_oracle(const std::string& reference) {
  const Description* solver = find_solver(reference);
  return solver != nullptr && solver->independent_oracle;
}

std::vector<std::string> reference_candidates(const Description& verified,
                                              const ReferenceSources& sources) {
  std::vector<const Description*> solvers = registered_solvers();
  std::optional<std::string> named = sources.named;
  if (const Description* solver = named ? find_solver(*named) : nullptr) {
    named = solver->name;
    if (!solver->values.empty()) solvers.push_back(solver);
  }
  std::vector<std::string> names;
  std::vector<const Description*> ranked = rank_references(verified, solvers, named);
  if (sources.many_sources) {
    std::stable_partition(ranked.begin(), ranked.end(), [&](const Description* solver) {
      return !solver->independent_oracle || solver->name == named;
    });
  }
  for (const Description* solver : ranked) {
    names.push_back(solver->name);
  }
  const bool named_is_first = !names.empty() && names.front() == named;
  const auto others = names.begin() + (named_is_first ? 1 : 0);
  std::vector<std::string> known;
  if (sources.closed_form) known.emplace_back(kClosedForm);
  if (sources.brute_force) known.emplace_back(kBruteForce);
  names.insert(others, known.begin(), known.end());
  if (sources.deciding_brute_force && !sources.brute_force) {
    names.insert(names.begin() + std::min<std::ptrdiff_t>(2, std::ssize(names)), kBruteForce);
  }
  return names;
}

const Description* choose_upper_bound(const std::vector<const Description*>& solvers) {
  const auto at = std::ranges::find_if(solvers, [](const Description* solver) {
    return solver->exactness == Exactness::upper_bound && !solver->by_name_only;
  });
  return at == solvers.end() ? nullptr : *at;
}

bool has_closed_form(const MeshEntry& entry) {
  return entry.recipe && std::ranges::any_of(generator_descriptions(), [&](const auto& generator) {
           return generator.name == entry.recipe->generator && !generator.closed_form.empty();
         });
}

std::optional<std::vector<double>> closed_form_distances(const MeshEntry& entry,
                                                         const TriangleSoup& soup,
                                                         std::span<const Index> sources) {
  if (!has_closed_form(entry)) return std::nullopt;
  std::vector<double> least(soup.positions.size(), kInfinity);
  try {
    for (const Index source : sources) {
      const auto known =
          known_distances(entry.recipe->generator, entry.recipe->parameters, soup, source);
      std::ranges::transform(least, known.value(), least.begin(),
                             [](double a, double b) { return std::min(a, b); });
    }
  } catch (const std::invalid_argument& error) {
    throw HarnessError("mesh '" + entry.name +
                       "' cannot be verified by its closed form: " + error.what());
  }
  return least;
}

std::vector<double> solve_with(Solver& object, const Mesh& mesh, const Query& query,
                               Recording* recording) {
  std::vector<double> distances(mesh.vertex_count());
  object.solve(query, distances, recording);
  return distances;
}

std::vector<double> solve_once(const std::string& solver, const Mesh& mesh, const Query& query,
                               Recording* recording) {
  return solve_with(*make_solver(solver, mesh), mesh, query, recording);
}

namespace {

// Brute force on a mesh. Keeps the results for the last few meshes: finding the segments takes
// nearly all of the time, and many solvers and properties use the same mesh.
std::shared_ptr<const BruteForce> brute_force_on(const Mesh& mesh) {
  struct Known {
    TriangleSoup soup;
    bool crosses_non_manifold_edges;
    std::shared_ptr<const BruteForce> segments;
  };
  constexpr std::size_t kKept = 4;
  thread_local std::deque<Known> last;
  Known asked{soup_of(mesh), mesh.crosses_non_manifold_edges(), nullptr};
  const auto same = std::ranges::find_if(last, [&](const Known& known) {
    return known.soup.positions == asked.soup.positions &&
           known.soup.triangles == asked.soup.triangles &&
           known.soup.joined_to == asked.soup.joined_to &&
           known.soup.left_out == asked.soup.left_out &&
           known.crosses_non_manifold_edges == asked.crosses_non_manifold_edges;
  });
  if (same != last.end()) return same->segments;
  asked.segments = std::make_shared<const BruteForce>(mesh);
  if (last.size() == kKept) last.pop_back();
  last.push_front(std::move(asked));
  return last.front().segments;
}

}  // namespace

ReferenceDistances choose_reference(
    const std::vector<std::string>& candidates,
    const std::function<std::vector<double>(const std::string& candidate)>& ask,
    const Tolerance& tolerance) {
  std::vector<ReferenceDistances> given;  // by an oracle, and by one that contradicts it
  std::vector<std::string> failures;
  for (const std::string& name : candidates) {
    try {
      given.push_back({name, ask(name)});
    } catch (const NoReference& why) {
      failures.emplace_back(why.what());
      continue;
    }
    const ReferenceDistances& first = given.front();
    const ReferenceDistances& last = given.back();
    const bool differs =
        check_distances({}, last.values, first.values, Relation::equal, tolerance).has_value();
    const bool is_first = given.size() == 1;
    if (is_first ? !is_independent_oracle(name) : !differs) return first;
    if (given.size() == 3 || name == kClosedForm || name == kBruteForce) break;
  }
  if (given.empty()) {
    throw NoReference("no other exact solver gave distances (" +
                      (failures.empty() ? "none supports this mesh" : join(failures, "; ")) + ")");
  }
  ReferenceDistances chosen = given.back();
  if (given.size() > 1) {
    const RelativeErrors errors = relative_errors(given.front().values, chosen.values);
    chosen.remark = given.front().by + " differs from " + chosen.by +
                    ", the reference (largest relative error " + significant(errors.max, 3) + ")";
  }
  return chosen;
}

LocalReference::LocalReference(const Description& verified, const Mesh& mesh,
                               const Tolerance& tolerance)
    : mesh_(mesh), tolerance_(tolerance) {
  candidates_ =
      reference_candidates(verified, {.brute_force = mesh.face_count() <= kBruteForceFaces,
                                      .deciding_brute_force = mesh.face_count() <= kDecidingFaces});
  std::erase_if(candidates_, [&](const std::string& name) {
    const Description* solver = find_solver(name);
    return solver != nullptr && !unsupported(*solver, mesh).empty();
  });
}

std::vector<double> LocalReference::ask(const std::string& candidate, const Query& query) {
  if (watch) watch(candidate);
  std::vector<double> distances;
  if (candidate == kBruteForce) {
    if (!brute_force_) brute_force_ = brute_force_on(mesh_);
    distances = brute_force_->distances(query.sources);
  } else {
    distances = solve_once(candidate, mesh_, {.sources = query.sources});
  }
  if (watch) watch("");
  return distances;
}

ReferenceDistances LocalReference::distances(const Query& query) {
  ReferenceDistances chosen = choose_reference(
      candidates_, [&](const std::string& candidate) { return ask(candidate, query); }, tolerance_);
  for (double& d : chosen.values) d = d > query.limit ? kInfinity : d;
  return chosen;
}

void write_distances(std::ostream& to, std::span<const double> distances) {
  to.write(reinterpret_cast<const char*>(distances.data()),
           static_cast<std::streamsize>(distances.size_bytes()));
}

void write_distances(const std::filesystem::path& file, std::span<const double> distances) {
  AtomicFile whole(file);
  write_distances(whole.stream(), distances);
  whole.commit();
}

std::vector<double> read_distances(const std::filesystem::path& file, std::size_t vertices) {
  DistanceRows rows(file, 1, vertices);
  const std::span<const double> row = rows.next();
  return {row.begin(), row.end()};
}

DistanceRows::DistanceRows(const std::filesystem::path& file, std::size_t rows,
                           std::size_t vertices)
    : in_(file, std::ios::binary), name_(file.string()), row_(vertices) {
  std::error_code absent;
  if (std::filesystem::file_size(file, absent) != rows * vertices * sizeof(double) || absent) {
    throw HarnessError("'" + name_ + "' does not hold " + std::to_string(rows * vertices) +
                       " distances");
  }
}

std::span<const double> DistanceRows::next() {
  const auto bytes = static_cast<std::streamsize>(row_.size() * sizeof(double));
  if (!in_.read(reinterpret_cast<char*>(row_.data()), bytes)) {
    throw HarnessError("'" + name_ + "' cannot be read to its end");
  }
  return row_;
}

}  // namespace geodesic::harness
