#include "harness/verify/property.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "harness/base/error.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/sources.h"
#include "harness/verify/properties/properties.h"

namespace geodesic::harness {
namespace {

struct ClaimInWords {
  Claim claim;
  const char* words;
  bool (*made_by)(const Description& solver);
};

constexpr ClaimInWords kClaims[] = {
    {kExactDistances, "exact distances",
     [](const Description& d) { return d.exactness == Exactness::exact; }},
    {kDistanceLimit, "a distance limit",
     [](const Description& d) { return d.abilities.distance_limit; }},
    {kInitialDistances, "initial distances",
     [](const Description& d) { return d.abilities.initial_distances; }},
    {kMultipleSources, "multiple sources",
     [](const Description& d) { return d.abilities.multiple_sources; }},
    {kFinalWindows, "windows that it keeps", [](const Description& d) { return d.final_windows; }},
    {kNoFinalWindows, "to keep no windows", [](const Description& d) { return !d.final_windows; }},
    {kOwnKernel, "the window kernel of this project",
     [](const Description& d) { return !d.independent_oracle; }},
    {kSameBits, "the same bits every time", [](const Description& d) { return d.deterministic; }},
    {kConcurrentObjects, "objects that solve at the same time",
     [](const Description& d) { return d.abilities.concurrent_objects; }},
    {kSurfaceSources, "sources in faces and on edges",
     [](const Description& d) { return d.abilities.surface_sources; }},
    {kNonManifoldEdges, "to cross non-manifold edges",
     [](const Description& d) { return d.abilities.non_manifold_edges; }},
    {kPaths, "paths", [](const Description& d) { return d.abilities.paths; }},
    {kTraces, "to trace paths itself", [](const Description& d) { return d.abilities.traces; }},
};

void must_refuse(const Trial& trial, const std::string& why) {
  refused("the mesh, though " + why + ",", [&] { trial.prepare(); });
}

// "limit 1.5e-7 of 12" becomes "limit # of #".
std::string without_numbers(const std::string& text) {
  std::string kept;
  bool in_number = false;
  for (const char c : text) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (digit && !in_number) kept += '#';
    in_number = digit || (in_number && std::string_view(".e+-").find(c) != std::string::npos);
    if (!in_number) kept += c;
  }
  return kept;
}

// The violation's kind, with the role of its vertex on this mesh.
std::string kind_of(const Violation& violation, const Mesh& mesh) {
  if (violation.kind.empty()) return without_numbers(violation.what);
  std::string kind = without_numbers(violation.kind);
  if (violation.vertex >= mesh.vertex_count()) return kind;
  return kind + ", at: " + role_of(violation.vertex, mesh, violation.query);
}

}  // namespace

std::vector<double> Trial::expected(const Query& query) const {
  return given_.known ? given_.known(query) : reference_.distances(query).values;
}

Finding Trial::correct(const Query& query, std::span<const double> got,
                       std::span<const double> expected, const Tolerance& tolerance) const {
  if (solver_.exactness == Exactness::exact) {
    for (std::size_t i = 0; i < got.size(); ++i) {
      const double error = std::abs(relative_error(got[i], expected[i], tolerance.least));
      largest_error_ = std::max(largest_error_, error);
    }
  }
  return check_promise(Promise::of(solver_), query, got, expected, tolerance);
}

void distances_are_right(const Trial& trial) {
  const auto solver = trial.prepare();
  for (const Query& query : trial.queries()) {
    const auto got = trial.solve(*solver, query);
    require(trial.correct(query, got, trial.expected(query)));
    const bool exact = trial.solver().exactness == Exactness::exact;
    if (!exact || query.limit < kInfinity) continue;  // beyond it, distances become infinite
    require(check_edges(trial.mesh(), query, got, trial.tolerance()));
  }
}

std::vector<std::string> needs_of(const Property& property) {
  std::vector<std::string> needs;
  for (const ClaimInWords& each : kClaims) {
    if ((property.needs & each.claim) != 0) needs.emplace_back(each.words);
  }
  return needs;
}

std::string unclaimed(const Property& property, const Description& solver) {
  std::vector<std::string> missing;
  for (const ClaimInWords& each : kClaims) {
    const bool needed = (property.needs & each.claim) != 0;
    if (needed && !each.made_by(solver)) missing.emplace_back(each.words);
  }
  return missing.empty() ? "" : "does not promise: " + join(missing);
}

bool too_large(const Case& given, const Description& solver) {
  return given.soup.positions.size() > solver.abilities.max_vertices;
}

Finding check_case(const Property& property, const Description& solver, const Case& given,
                   double* largest_error) {
  try {
    const Trial trial(solver, given);
    const std::string why_not = unsupported(solver, trial.mesh());
    const std::uint64_t before = requirements();
    try {
      why_not.empty() ? property.check(trial) : must_refuse(trial, why_not);
    } catch (Violation& found) {
      found.kind = kind_of(found, trial.mesh());
      return found;
    }
    if (requirements() == before) throw NothingCompared("has nothing to compare here");
    if (largest_error != nullptr) {
      *largest_error = std::max(*largest_error, trial.largest_error());
    }
    return {};
  } catch (const NoReference&) {
    throw;
  } catch (const NothingCompared&) {
    throw;
  } catch (const std::exception& error) {
    const std::string what = kThrew + std::string(error.what());
    return Violation{.what = what, .kind = without_numbers(what)};
  }
}

std::string role_of(Index v, const Mesh& mesh, const Query& query) {
  const auto is_v = [v](const Source& source) { return source.at.vertex == v; };
  if (std::ranges::any_of(query.sources, is_v)) return "source";
  if (mesh.outgoing(v).empty()) return "isolated vertex";
  if (mesh.is_boundary(v)) return "boundary vertex";
  return mesh.is_pseudo_source(v) ? "saddle vertex" : "ordinary vertex";
}

Query from(Index source) { return from(std::vector<Index>{source}); }

Query from(const std::vector<Index>& sources) { return query_from(sources); }

}  // namespace geodesic::harness
