#include "meshes/load.h"

#include <exception>
#include <future>
#include <stdexcept>
#include <utility>

#include "solvers/core/mesh_input.h"

namespace geodesic {
namespace {

LoadedMesh load_mesh(MeshFile file, DefectReport defects, const std::string& name,
                     const LoadOptions& options) {
  LoadedMesh mesh;
  mesh.soup = std::move(file.soup);
  mesh.format = std::move(file.format);
  mesh.defects = std::move(defects);
  if (options.repair) mesh.repairs = repair(mesh.soup, options.non_manifold_edges);
  require_measurable(mesh.soup, mesh.defects, name, options);
  mesh.warnings = std::move(file.warnings);
  for (const Defect& defect : mesh.defects.defects) mesh.warnings.push_back(defect.text());
  for (const RepairAction& action : mesh.repairs) {
    mesh.warnings.push_back("repair: " + action.summary());
  }
  return mesh;
}

}  // namespace

std::string list_errors(const DefectReport& report, NonManifoldEdges non_manifold_edges) {
  std::string text;
  for (const Defect& defect : report.defects) {
    if (type_of(defect.kind).severity != Severity::error) continue;
    const bool of_edges = defect.kind == DefectKind::non_manifold_edge ||
                          defect.kind == DefectKind::inconsistent_orientation;
    if (of_edges && non_manifold_edges == NonManifoldEdges::crossed) continue;
    text += (text.empty() ? "" : "; ") + defect.text();
  }
  return text;
}

void require_measurable(const TriangleSoup& soup, const DefectReport& defects,
                        const std::string& name, const LoadOptions& options) {
  const std::string errors = list_errors(defects, options.non_manifold_edges);
  if (!errors.empty() && !options.repair) {
    throw MeshError(name + ": distances would be meaningless: " + errors +
                    "; correct the file or use " + options.repair_option);
  }
  if (soup.triangles.empty()) throw MeshError(name + ": no usable face is left: " + errors);
  try {
    check_extent(soup.positions);
  } catch (const std::invalid_argument& error) {
    throw MeshError(name + ": " + error.what());
  }
}

LoadedMesh load_mesh(const std::filesystem::path& path, const LoadOptions& options) {
  return load_mesh(read_mesh_file(path), path.string(), options);
}

LoadedMesh load_mesh(MeshFile file, const std::string& name, const LoadOptions& options) {
  DefectReport defects = find_defects(file.soup, file.lines);
  return load_mesh(std::move(file), std::move(defects), name, options);
}

BuiltMesh build_mesh(const std::filesystem::path& path, const LoadOptions& options) {
  MeshFile file = read_mesh_file(path);
  BuiltMesh built;
  const auto build = [&](const TriangleSoup& soup) {
    built.mesh = std::make_unique<Mesh>(soup, Numbering::along_surface, options.non_manifold_edges);
  };
  if (options.repair) {
    built.loaded = load_mesh(std::move(file), path.string(), options);
    build(built.loaded.soup);
    return built;
  }
  std::future<DefectReport> defects =
      std::async([&file] { return find_defects(file.soup, file.lines); });
  std::exception_ptr unfit;
  try {
    build(file.soup);
  } catch (const std::invalid_argument&) {  // the defects give a better message
    unfit = std::current_exception();
  }
  built.loaded = load_mesh(std::move(file), defects.get(), path.string(), options);
  if (unfit) std::rethrow_exception(unfit);
  return built;
}

}  // namespace geodesic
