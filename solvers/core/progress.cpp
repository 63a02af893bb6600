#include "solvers/core/progress.h"

#include <vector>

namespace geodesic {
namespace {

// Counts the vertices that a path along edges joins to a source, including the sources.
std::uint64_t count_reachable(const Mesh& mesh, const Start& start) {
  std::vector<bool> seen(mesh.vertex_count());
  std::vector<Index> open;
  std::uint64_t count = 0;
  const auto see = [&](Index v) {
    if (seen[v]) return;
    seen[v] = true;
    open.push_back(v);
    ++count;
  };
  for (const StartVertex& each : start.vertices) see(each.vertex);
  while (!open.empty()) {
    const Index v = open.back();
    open.pop_back();
    for (const Index h : mesh.outgoing(v)) {
      see(mesh.head(h));
      see(mesh.apex(h));
    }
  }
  return count;
}

}  // namespace

void Progress::start(const Mesh& mesh, const Start& start) {
  reached_ = 0;
  reachable_ = count_reachable(mesh, start);
  next_step_ = 1;
}

}  // namespace geodesic
