#include "harness/corpus/solvers.h"

#include <algorithm>
#include <sstream>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "solvers/core/number_text.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace {

// The solver for a word after a comma. A number is another value of the last parameter of the
// solver before it.
std::string name_after(const std::string& before, const std::string& word) {
  const std::size_t equals = before.rfind('='), more = word.find('&');
  if (equals == std::string::npos || !number_in<double>(std::string_view(word).substr(0, more))) {
    return word;
  }
  if (more != std::string::npos) {
    throw HarnessError("'" + before + ',' + word +
                       "': the parameter with several values comes last, as in "
                       "'SOLVER?ONE=1&OTHER=2,3'");
  }
  return before.substr(0, equals + 1) + word;
}

}  // namespace

const Description& solver_named(const std::string& name) {
  try {
    return geodesic::solver_named(name);
  } catch (const std::invalid_argument& error) {
    throw HarnessError(error.what());
  }
}

std::vector<const Description*> solvers_named(const std::vector<std::string>& words) {
  std::vector<const Description*> solvers;
  std::string before;
  for (const std::string& word : words) {
    std::istringstream list(word);
    for (std::string name; std::getline(list, name, ',');) {
      before = name_after(before, name);
      solvers.push_back(&solver_named(before));
    }
  }
  return solvers;
}

std::string canonical_cell(const std::string& cell) {
  const std::size_t slash = std::min(cell.find('/'), cell.size());
  const std::string solver = cell.substr(0, slash);
  const bool known = find_solver(base_name(solver)) != nullptr;
  return known ? solver_named(solver).name + cell.substr(slash) : cell;
}

std::string shown_exactness(const Description& solver) {
  if (solver.exactness == Exactness::bounded) {
    return "within " + ParameterValue(solver.error_bound(solver)).text();
  }
  std::string text(exactness_name(solver.exactness));
  std::ranges::replace(text, '_', ' ');
  return text;
}

const RelativeTimes& relative_times() {
  static const RelativeTimes times = [] {
    const std::filesystem::path file = data_folder() / "harness" / "relative_times.json";
    return std::filesystem::exists(file) ? read_json(file).get<RelativeTimes>() : RelativeTimes{};
  }();
  return times;
}

double relative_time(const Description& solver, const RelativeTimes& times) {
  const auto found = times.find(base_name(solver.name));
  return found == times.end() ? 0 : found->second;
}

std::string unsupported(const Description& solver, const Mesh& mesh) {
  const Abilities& can = solver.abilities;
  if (can.max_vertices != kNone && mesh.vertex_count() > can.max_vertices) {
    return solver.name + " is limited to " + std::to_string(can.max_vertices) +
           " vertices, the mesh has " + std::to_string(mesh.vertex_count());
  }
  if (mesh.has_non_manifold_vertices() && !can.non_manifold_vertices) {
    return solver.name + " supports no vertices that several fans of faces share";
  }
  if (mesh.crosses_non_manifold_edges() && !can.non_manifold_edges) {
    std::vector<std::string> others;
    for (const Description* other : registered_solvers()) {
      if (other->abilities.non_manifold_edges && !other->by_name_only) {
        others.push_back(other->name);
      }
    }
    return solver.name + " does not cross edges of more than two faces; there are: " + join(others);
  }
  if (mesh.has_degenerate_faces() && !can.degenerate_faces) {
    return solver.name + " supports no faces with a zero-length edge or without area";
  }
  return {};
}

InstructionSet instruction_set_named(const std::string& word) {
  if (word == kAutoVectors) return widest_instruction_set();
  std::vector<std::string> known{kAutoVectors};
  for (const InstructionSet set : kInstructionSets) {
    known.emplace_back(name_of(set));
    if (word != name_of(set)) continue;
    const std::string why = why_unavailable(set);
    if (!why.empty()) throw HarnessError("--vectors " + word + ": " + why);
    return set;
  }
  throw HarnessError(unknown_name("kind of vectors", word, known));
}

}  // namespace geodesic::harness
