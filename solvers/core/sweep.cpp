#include "solvers/core/sweep.h"

#include <vector>

#include "solvers/core/solver.h"

namespace geodesic {
namespace {

// Vertices that a path along edges joins to a source, the sources included.
std::uint64_t count_reachable(const Mesh& mesh, const Query& query) {
  std::vector<bool> seen(mesh.vertex_count());
  std::vector<Index> open;
  std::uint64_t count = 0;
  const auto see = [&](Index v) {
    if (seen[v]) return;
    seen[v] = true;
    open.push_back(v);
    ++count;
  };
  for (const Source& source : query.sources) see(source.vertex);
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

void Sweep::start(const Mesh& mesh, const Query& query) {
  reached_ = 0;
  reachable_ = count_reachable(mesh, query);
  next_step_ = 1;
}

}  // namespace geodesic
