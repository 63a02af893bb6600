#include "harness/corpus/solvers.h"

#include "harness/base/error.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {

const Description& solver_named(const std::string& name) {
  if (const Description* solver = find_solver(name)) return *solver;
  std::vector<std::string> known;
  for (const Description* solver : registered_solvers()) known.push_back(solver->name);
  throw HarnessError(unknown_name("solver", name, known));
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
  if (mesh.has_degenerate_faces() && !can.degenerate_faces) {
    return solver.name + " supports no faces with a zero-length edge or without area";
  }
  return {};
}

}  // namespace geodesic::harness
