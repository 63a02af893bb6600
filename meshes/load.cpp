#include "meshes/load.h"

#include <stdexcept>
#include <utility>

#include "solvers/core/unit.h"

namespace geodesic {
namespace {

std::string list_errors(const DefectReport& report) {
  std::string text;
  for (const Defect& defect : report.defects) {
    if (type_of(defect.kind).severity != Severity::error) continue;
    text += (text.empty() ? "" : "; ") + defect.text();
  }
  return text;
}

}  // namespace

void require_measurable(const TriangleSoup& soup, const DefectReport& defects,
                        const std::string& name, bool repaired) {
  if (defects.has_errors() && !repaired) {
    throw MeshError(name + ": distances would be meaningless: " + list_errors(defects) +
                    "; correct the file or use --repair");
  }
  if (soup.triangles.empty()) {
    throw MeshError(name + ": no usable face is left: " + list_errors(defects));
  }
  try {
    Unit::of(soup.positions);
  } catch (const std::invalid_argument& error) {
    throw MeshError(name + ": " + error.what() + "; scale it");
  }
}

LoadedMesh load_mesh(const std::filesystem::path& path, const LoadOptions& options) {
  return load_mesh(read_mesh(path), path.string(), options);
}

LoadedMesh load_mesh(MeshFile file, const std::string& name, const LoadOptions& options) {
  LoadedMesh mesh;
  mesh.soup = std::move(file.soup);
  mesh.format = std::move(file.format);
  mesh.defects = find_defects(mesh.soup, file.lines);
  if (options.repair) mesh.repairs = repair(mesh.soup);
  require_measurable(mesh.soup, mesh.defects, name, options.repair);
  mesh.warnings = std::move(file.warnings);
  for (const Defect& defect : mesh.defects.defects) mesh.warnings.push_back(defect.text());
  for (const RepairAction& action : mesh.repairs) {
    mesh.warnings.push_back("repair: " + action.summary());
  }
  return mesh;
}

}  // namespace geodesic
