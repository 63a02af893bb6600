#include "meshes/load.h"

#include <algorithm>
#include <exception>
#include <future>
#include <stdexcept>
#include <utility>

#include "solvers/core/mesh_input.h"

namespace geodesic {
namespace {

LoadedMesh load_mesh(MeshFile file, std::vector<RepairAction> welds, DefectReport defects,
                     const std::string& name, const LoadOptions& options) {
  LoadedMesh mesh;
  mesh.welds = std::move(welds);
  mesh.soup = std::move(file.soup);
  mesh.format = std::move(file.format);
  mesh.defects = std::move(defects);
  if (options.repair) mesh.repairs = repair(mesh.soup, options.non_manifold_edges);
  require_measurable(mesh.soup, mesh.defects, name, options);
  mesh.warnings = std::move(file.warnings);
  for (const RepairAction& action : mesh.welds) {
    mesh.warnings.push_back("weld: " + action.summary());
  }
  for (const Defect& defect : mesh.defects.defects) {
    mesh.warnings.push_back(defect.text() + remedy_of(defect, options.weld_option));
  }
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

std::string remedy_of(const Defect& defect, const std::string& weld_option) {
  const bool near = defect.kind == DefectKind::nearly_coincident_vertex;
  if (!near && defect.kind != DefectKind::coincident_vertex) return {};
  const std::string option =
      near ? weld_option.substr(0, weld_option.find('=')) + "=DISTANCE" : weld_option;
  return ": paths do not cross there; " + option +
         (defect.count == 1 ? " joins it" : " joins them");
}

std::string list_seams(const DefectReport& report, const std::string& weld_option) {
  std::string text;
  for (const Defect& defect : report.defects) {
    const std::string remedy = remedy_of(defect, weld_option);
    if (!remedy.empty()) text += (text.empty() ? "" : "; ") + defect.text() + remedy;
  }
  return text;
}

std::vector<RepairAction> weld_and_leave_out(MeshFile& file, const std::string& name,
                                             const LoadOptions& options) {
  const TriangleSoup& soup = file.soup;
  try {
    check_names(soup.positions.size(), soup.triangles, soup.joined_to, soup.left_out);
  } catch (const std::invalid_argument& error) {
    throw MeshError(name + ": " + error.what());
  }
  std::vector<RepairAction> done;
  try {
    if (options.weld) done = weld(file.soup, *options.weld);
  } catch (const std::invalid_argument& error) {
    throw MeshError(error.what());
  }
  try {
    leave_out(file.soup, options.avoid);
  } catch (const std::invalid_argument& error) {
    throw MeshError(name + ": " + error.what());
  }
  return done;
}

void require_measurable(const TriangleSoup& soup, const DefectReport& defects,
                        const std::string& name, const LoadOptions& options) {
  const std::string errors = list_errors(defects, options.non_manifold_edges);
  if (!errors.empty() && !options.repair) {
    throw MeshError(name + ": distances would be meaningless: " + errors +
                    "; correct the mesh or use " + options.repair_option);
  }
  const bool has_faces = std::ranges::count(faces_of(soup), true) > 0;
  if (!has_faces && errors.empty() && soup.joined_to.empty()) {
    throw MeshError(name + ": empty mesh: no faces");
  }
  if (!has_faces && errors.empty()) {
    throw MeshError(name +
                    ": every face collapses when vertices are joined; join them within a "
                    "smaller distance");
  }
  if (!has_faces) throw MeshError(name + ": no usable face is left: " + errors);
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
  std::vector<RepairAction> welds = weld_and_leave_out(file, name, options);
  DefectReport defects = find_defects(file.soup, file.lines);
  return load_mesh(std::move(file), std::move(welds), std::move(defects), name, options);
}

BuiltMesh build_mesh(const std::filesystem::path& path, const LoadOptions& options) {
  return build_mesh(read_mesh_file(path), path.string(), options);
}

BuiltMesh build_mesh(MeshFile file, const std::string& name, const LoadOptions& options) {
  BuiltMesh built;
  const auto build = [&](const TriangleSoup& soup) {
    built.mesh = std::make_unique<Mesh>(soup, Numbering::along_surface, options.non_manifold_edges);
  };
  if (options.repair) {
    built.loaded = load_mesh(std::move(file), name, options);
    build(built.loaded.soup);
    return built;
  }
  std::vector<RepairAction> welds = weld_and_leave_out(file, name, options);
  std::future<DefectReport> defects =
      std::async([&file] { return find_defects(file.soup, file.lines); });
  std::exception_ptr unfit;
  try {
    build(file.soup);
  } catch (const std::invalid_argument&) {  // the defects give a better message
    unfit = std::current_exception();
  }
  built.loaded = load_mesh(std::move(file), std::move(welds), defects.get(), name, options);
  if (unfit) std::rethrow_exception(unfit);
  return built;
}

}  // namespace geodesic
