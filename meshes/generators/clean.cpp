// A measurable mesh from a raw scan: oriented, manifold, every face with an area.
#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "meshes/generators/cleaning/steps.h"
#include "meshes/generators/families.h"
#include "meshes/generators/input.h"
#include "meshes/generators/sheet.h"
#include "meshes/mesh_file.h"

namespace geodesic {
namespace {

using Step = std::vector<RepairAction> (*)(TriangleSoup& soup);

// Welding and flips can make faces meet that did not before, which the next round separates.
constexpr Step kSteps[] = {cancel_opposite_faces, repair, weld_edges, separate_sheets,
                           remove_flat_faces};

/// Far more than any scan takes; each round but the last removes something.
constexpr int kMostRounds = 100;

/// What was done in all rounds together, in the order in which it was first done.
class Log {
 public:
  /// @return whether anything changed
  bool add(const std::vector<RepairAction>& actions) {
    bool changed = false;
    for (const RepairAction& action : actions) {
      if (!action.changed) continue;
      changed = true;
      const auto known =
          std::find_if(actions_.begin(), actions_.end(),
                       [&](const RepairAction& other) { return other.key == action.key; });
      if (known == actions_.end()) {
        actions_.push_back(action);
      } else {
        known->count += action.count;
      }
    }
    return changed;
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    std::transform(actions_.begin(), actions_.end(), std::back_inserter(lines),
                   [](const RepairAction& action) { return action.summary(); });
    return lines;
  }

 private:
  std::vector<RepairAction> actions_;
};

/// Takes the steps until a round changes nothing.
void take_steps(TriangleSoup& soup, const std::string& file, Log& log) {
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (const Step step : kSteps) changed |= log.add(step(soup));
    if (!changed) return;
  }
  throw MeshError(file + ": still not a measurable mesh after " + std::to_string(kMostRounds) +
                  " rounds of cleaning");
}

Made make_clean(const CheckedParameters& parameters) {
  const std::string& file = parameters.file("input");
  TriangleSoup soup = read_mesh(file).soup;
  Log log;
  take_steps(soup, file, log);
  if (parameters.choice("parts") == "largest") log.add(keep_largest_component(soup));
  const std::size_t vertices = soup.positions.size();
  drop_isolated_vertices(soup);
  if (const std::size_t dropped = vertices - soup.positions.size(); dropped > 0) {
    log.add({{"dropped_vertices", "vertices without a face dropped", dropped}});
  }
  if (soup.triangles.empty()) {
    throw MeshError(file + ": no face with an area is left; is it the right file?");
  }
  return {std::move(soup), log.lines()};
}

}  // namespace

Family clean() {
  return {{.name = "clean",
           .description = "a mesh made measurable for every solver: oriented, manifold, without "
                          "repeated faces, zero-length edges, faces without area and isolated "
                          "vertices; what was in order stays as it was",
           .closed_form = "",
           .parameters = {input_parameter(),
                          choice_parameter("parts", {"largest", "all"},
                                           "the connected parts to keep; largest by faces")}},
          make_clean};
}

}  // namespace geodesic
