#include "harness/commands/solving/problem.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "harness/base/error.h"
#include "harness/commands/solving/answers.h"
#include "meshes/isolines.h"
#include "meshes/nearest_point.h"
#include "solvers/core/messages.h"
#include "solvers/core/number_text.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

bool are_vertices(const Query& query) {
  return std::ranges::all_of(query.targets, &SurfacePoint::is_vertex) &&
         std::ranges::all_of(query.sources, &SurfacePoint::is_vertex, &Source::at);
}

// The points of a flag, and those of the file that another flag names.
std::vector<WrittenPoint> points_of(const std::string& flag, const std::vector<std::string>& words,
                                    const std::string& file) {
  std::vector<WrittenPoint> points;
  const auto add = [&points](const std::vector<WrittenPoint>& more) {
    points.insert(points.end(), more.begin(), more.end());
  };
  for (const std::string& word : words) add(parse_points(word, "--" + flag));
  if (!file.empty()) add(read_points(file, "--" + flag + "s-file"));
  return points;
}

Levels parse_levels(const std::string& text) {
  Levels levels;
  const auto refuse = [&] {
    throw HarnessError("--levels: '" + text + "' is neither a number of levels, from 1 to " +
                       std::to_string(kMostLevels) +
                       ", nor distances above 0, such as 0.5 or 1,2.5");
  };
  if (text.find_first_not_of("0123456789") == std::string::npos) {
    levels.count = number_in<Index>(text).value_or(0);
    if (levels.count == 0 || levels.count > kMostLevels) refuse();
    return levels;
  }
  for (std::size_t begin = 0, end = 0; end < text.size(); begin = end + 1) {
    end = std::min(text.find(',', begin), text.size());
    const auto word = std::string_view(text).substr(begin, end - begin);
    levels.given.push_back(number_in<double>(word).value_or(0));
    if (!(levels.given.back() > 0 && levels.given.back() < kInfinity)) refuse();
  }
  return levels;
}

// Checks that the solver has the abilities that the flags and the query need.
void check_abilities(const SolveFlags& flags, unsigned threads, const Description& solver,
                     const Query& query) {
  if (threads > 1 && !solver.abilities.concurrent_objects) {
    throw HarnessError(solver.name +
                       " cannot solve in several threads at the same time: leave out --threads");
  }
  if (!flags.save_prepared.empty() && !solver.abilities.saves) {
    std::vector<std::string> others;
    for (const Description* other : registered_solvers()) {
      if (other->abilities.saves) others.push_back(other->name);
    }
    throw HarnessError("--save-prepared: " + solver.name +
                       " has no preparation that could be saved; there are: " + join(others));
  }
  if (!wants_paths(flags)) return;
  const bool from_vertices = are_vertices({query.sources});
  const auto can = [&](const Abilities& abilities) {
    return (abilities.paths && (abilities.surface_sources || from_vertices)) ||
           (abilities.traces && are_vertices(query) && !flags.nearest_source && !flags.angles);
  };
  if (can(solver.abilities)) return;
  std::vector<std::string> others;
  for (const Description* other : registered_solvers()) {
    if (can(other->abilities) && !other->by_name_only) others.push_back(other->name);
  }
  if (solver.abilities.traces && !flags.nearest_source && !flags.angles) {
    throw HarnessError(solver.name +
                       " traces paths between vertices only; there are: " + join(others));
  }
  throw HarnessError(solver.name + " does not remember how paths arrive, which --paths, " +
                     "--nearest-source and --angles need; there are: " + join(others));
}

// Whether several threads can work on one source.
bool shares_sources(const Description& solver) {
  return std::ranges::count(solver.parameters, "threads", &ParameterDescription::name) > 0 &&
         !solver.values.contains("threads");
}

const Description& with_threads(const Description& solver, unsigned threads) {
  if (threads == 1) return solver;
  return solver_named(solver.name + (solver.values.empty() ? '?' : '&') +
                      "threads=" + std::to_string(threads));
}

// The number of sources that are solved at the same time, and of threads for each source: one
// thread if there are sources for all threads, because that costs nothing. Solvers whose
// preparation can be saved use their threads for that alone.
struct ThreadShares {
  unsigned sources = 1, within = 1;
};
ThreadShares share_threads(const SolveFlags& flags, const Description& solver,
                           std::size_t sources) {
  if (!wants_rows(flags) && flags.pairs_file.empty()) {
    if (flags.threads > 1 && !shares_sources(solver)) {
      throw HarnessError("--threads is for --each, --sets and --pairs where the solver is " +
                         solver.name);
    }
    return {.within = flags.threads};
  }
  const auto side_by_side = static_cast<unsigned>(std::min<std::size_t>(flags.threads, sources));
  if (!shares_sources(solver)) return {side_by_side, 1};
  return {side_by_side, solver.abilities.saves ? flags.threads : flags.threads / side_by_side};
}

}  // namespace

bool wants_rows(const SolveFlags& flags) { return flags.each || !flags.sets_file.empty(); }

bool wants_paths(const SolveFlags& flags) {
  return flags.nearest_source || flags.angles || !flags.paths.empty();
}

void check_combination(const SolveFlags& flags) {
  const auto refuse = [](const std::string& why) { throw HarnessError(why); };
  const bool targets = !flags.targets.empty() || !flags.targets_file.empty();
  const bool sources = !flags.sources.empty() || !flags.sources_file.empty();
  if (flags.meshes.size() > 1 &&
      !(flags.output.empty() && flags.paths.empty() && flags.isolines.empty())) {
    refuse("--output, --paths and --isolines are files of one mesh: with several use --out");
  }
  if (flags.meshes.size() > 1 && !(flags.prepared.empty() && flags.save_prepared.empty())) {
    refuse("--prepared and --save-prepared are files of one mesh");
  }
  if (!sources && flags.pairs_file.empty() && flags.sets_file.empty()) {
    refuse("--source, --sources-file, --sets or --pairs is required");
  }
  if (flags.each && flags.counters) refuse("--counters is for one solve: leave out --each");
  if (flags.each && wants_paths(flags)) {
    refuse("--paths, --nearest-source and --angles are for one solve: leave out --each");
  }
  if (flags.each && !flags.isolines.empty())
    refuse("--isolines is for one solve: leave out --each");
  if (flags.isolines.empty() != flags.levels.empty()) {
    refuse("--isolines and --levels need each other: a file, and the distances of its lines");
  }
  const auto place_of = [](const std::string& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file));
  };
  if (!flags.isolines.empty() && !flags.paths.empty() &&
      place_of(flags.isolines) == place_of(flags.paths)) {
    refuse("--isolines and --paths need a file each");
  }
  if (flags.check && (std::isfinite(flags.limit) || flags.stop_at_targets)) {
    refuse("--check is for distances without --limit and --stop-at-targets");
  }
  if (flags.stop_at_targets && !targets) refuse("--stop-at-targets needs --target");
  if (!flags.paths.empty() && !targets) refuse("--paths needs --target, where the paths lead");
  if ((flags.nearest_source || flags.angles) && flags.output.empty() &&
      flags.output_folder.empty()) {
    refuse(std::string(flags.angles ? "--angles" : "--nearest-source") +
           " needs --output: it is a column of that file");
  }
}

WrittenValues::WrittenValues(const SolveFlags& flags)
    : sources(points_of("source", flags.sources, flags.sources_file)),
      targets(points_of("target", flags.targets, flags.targets_file)),
      avoided(read_avoided(flags.avoid)) {
  if (!flags.levels.empty()) levels = parse_levels(flags.levels);
  if (!flags.pairs_file.empty()) pairs = read_pairs(flags.pairs_file, "--pairs");
  if (!flags.sets_file.empty()) sets = read_sets(flags.sets_file, "--sets");
}

Problem read_problem(const SolveFlags& flags, const Description& solver, const MeshEntry& entry,
                     const BuiltMesh& built, const WrittenValues& values) {
  const std::string unable = unsupported(solver, *built.mesh);
  if (!unable.empty()) throw HarnessError(unable);
  const std::size_t side_by_side =
      std::max({values.sources.size(), values.pairs.size(), values.sets.size()});
  const ThreadShares shares = share_threads(flags, solver, side_by_side);
  Problem problem{flags,
                  with_threads(solver, shares.within),
                  shares.sources,
                  entry,
                  built.loaded.soup,
                  *built.mesh,
                  {}};
  problem.levels = values.levels;
  problem.query.limit = flags.limit;
  problem.query.stop_at_targets = flags.stop_at_targets;
  const NearestPointSearch surface(problem.mesh);
  const auto placed = [&](const WrittenPoint& point) {
    const PlacedPoint found = place(point, surface);
    if (found.from_surface) {
      const std::string remark = surface.remark_if_far(*found.from_surface);
      if (!remark.empty()) warn(point.text + ' ' + remark);
      problem.places.push_back({{"place", point.numbers},
                                {"point", written(problem.mesh, found.at)},
                                {"distance_to_surface", *found.from_surface}});
    }
    return found;
  };
  std::vector<SurfacePoint> starts;
  const auto placed_source = [&](const WrittenPoint& written) -> Source {
    const PlacedPoint source = placed(written);
    starts.push_back(source.at);
    return {.at = source.at, .distance = source.initial};
  };
  for (const WrittenPoint& source : values.sources) {
    if (flags.each) {
      problem.rows.push_back({placed_source(source)});
    } else {
      problem.query.sources.push_back(placed_source(source));
    }
  }
  for (const WrittenSet& set : values.sets) {
    std::ranges::transform(set, std::back_inserter(problem.rows.emplace_back()), placed_source);
  }
  for (const WrittenPoint& target : values.targets) {
    if (target.initial) throw HarnessError(target.text + ": a target has no initial distance");
    problem.query.targets.push_back(placed(target).at);
  }
  for (const auto& [from, to] : values.pairs) {
    const SurfacePoint begin = placed(from).at;
    problem.pairs.push_back({begin, placed(to).at});
  }
  check_abilities(flags, problem.threads, solver, problem.query);
  if (!problem.pairs.empty()) {
    const GroupedPairs& grouped = problem.grouped.emplace(solver, problem.pairs);
    problem.inserted = insert_for(solver, problem.mesh, grouped.sources(), grouped.targets());
    return problem;
  }
  problem.inserted = insert_for(solver, problem.mesh, starts, problem.query.targets);
  return problem;
}

}  // namespace geodesic::harness
