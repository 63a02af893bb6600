#include "harness/verify/saved_case.h"

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/corpus/solvers.h"
#include "harness/verify/isolated_check.h"
#include "meshes/mesh_file.h"

namespace geodesic::harness {
namespace {

// The members of the file.
struct CaseFile {
  std::string solver, property, vectors;
  std::string mesh;            // name of the mesh file, in the folder of this one
  std::vector<Query> queries;  // on it
  double least_distance = 0;   // Tolerance::least
};
GEODESIC_JSON_MEMBERS(CaseFile, solver, property, vectors, mesh, queries, least_distance)

void check_queries(const SavedCase& saved) {
  const Mesh mesh = saved.given.build();
  if (saved.given.queries.empty()) throw HarnessError("no queries");
  for (const Query& query : saved.given.queries) {
    if (query.sources.empty()) throw HarnessError("a query without sources");
    for (const Source& source : query.sources) {
      const std::string defect = defect_of(mesh, source.at);
      if (!defect.empty()) throw HarnessError("source " + defect);
    }
  }
}

}  // namespace

std::filesystem::path mesh_beside(const std::filesystem::path& file) {
  return std::filesystem::path(file).replace_extension(".obj");
}

void write_mesh(const Case& given, const std::filesystem::path& file) {
  write_bytes(file, mesh_bytes(given.soup, file));
}

void write_case(const SavedCase& saved, const std::filesystem::path& file) {
  const std::filesystem::path mesh = mesh_beside(file);
  const CaseFile members{.solver = saved.solver,
                         .property = saved.property,
                         .vectors = saved.vectors,
                         .mesh = mesh.filename().string(),
                         .queries = saved.given.queries,
                         .least_distance = saved.given.tolerance.least};
  write_mesh(saved.given, mesh);
  write_json(file, members);
}

SavedCase read_case(const std::filesystem::path& file) {
  const Json json = read_json(file, "a case that verify has saved");
  try {
    const CaseFile members = json.get<CaseFile>();
    const Property& property = property_named(members.property);
    SavedCase saved{.solver = solver_named(members.solver).name,
                    .property = property.name,
                    .vectors = members.vectors,
                    .given = {.mesh = file.string(),
                              .soup = read_mesh_file(file.parent_path() / members.mesh).soup,
                              .queries = members.queries,
                              .tolerance = {.least = members.least_distance}}};
    instruction_set_named(saved.vectors);
    if ((property.needs & kNonManifoldEdges) != 0) {
      saved.given.non_manifold_edges = NonManifoldEdges::crossed;
    }
    check_queries(saved);
    return saved;
  } catch (const Json::exception& error) {
    throw HarnessError(file.string() + ": no case that verify has saved: " + error.what());
  } catch (const std::exception& error) {
    throw HarnessError(file.string() + ": " + error.what());
  }
}

}  // namespace geodesic::harness
