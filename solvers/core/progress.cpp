#include "solvers/core/progress.h"

#include <vector>

namespace geodesic {
namespace {

// Counts the vertices that a path along edges joins to a source, including the sources.
std::uint64_t count_reachable(const Mesh& mesh, const InternalQuery& query) {
  std::vector<bool> seen(mesh.vertex_count());
  std::vector<Index> open;
  std::uint64_t count = 0;
  const auto see = [&](Index v) {
    if (seen[v]) return;
    seen[v] = true;
    open.push_back(v);
    ++count;
  };
  for (const Index v : source_vertices(mesh, query)) see(v);
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

void Progress::start(const Mesh& mesh, const InternalQuery& query) {
  reached_ = 0;
  reachable_ = count_reachable(mesh, query);
  next_step_ = 1;
}

}  // namespace geodesic
