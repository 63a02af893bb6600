#include "harness/commands/commands.h"

#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/commands/values.h"
#include "meshes/load.h"
#include "meshes/mesh_file.h"
#include "meshes/summary.h"

namespace geodesic::harness {
namespace {

struct Flags {
  std::string file;
  std::string output;
  bool json = false;
  bool repair = false;
  std::optional<double> weld;
  AvoidedFiles avoid;
};

// Results of the inspection, after the repair if there is one.
struct Findings {
  std::string format;
  MeshSummary summary;
  std::vector<RepairAction> welds;
  DefectReport defects;  // of the file, after the weld and before the repair
  std::vector<RepairAction> repairs;
  std::vector<std::string> warnings;  // from reading the file
};

Json edge_lengths_json(const std::optional<EdgeLengths>& lengths) {
  if (!lengths) return nullptr;
  return {{"min", lengths->least}, {"mean", lengths->mean}, {"max", lengths->greatest}};
}

Json defects_json(const DefectReport& report) {
  Json list = Json::array();
  for (const Defect& defect : report.defects) {
    const DefectType& type = type_of(defect.kind);
    list.push_back({{"kind", type.key},
                    {"severity", type.severity == Severity::error ? "error" : "warning"},
                    {"count", defect.count},
                    {"first", defect.example}});
  }
  return list;
}

Json repairs_json(const std::vector<RepairAction>& repairs) {
  Json list = Json::array();
  for (const RepairAction& action : repairs) {
    list.push_back({{"kind", action.key},
                    {"count", action.count},
                    {"changed", action.changed},
                    {"what", action.text}});
  }
  return list;
}

void print_json(const Flags& flags, const Findings& findings) {
  const MeshSummary& s = findings.summary;
  Json json = {{"file", flags.file},
               {"format", findings.format},
               {"vertices", s.vertices},
               {"faces", s.faces},
               {"edges", s.edges},
               {"components", s.components},
               {"boundary_loops", s.boundary_loops},
               {"boundary_edges", s.boundary_edges},
               {"genus", s.genus},
               {"orientable", s.orientable},
               {"edge_length", edge_lengths_json(s.edge_lengths)},
               {"smallest_angle_degrees", s.smallest_angle},
               {"saddle_vertices", s.saddle_vertices},
               {"isolated_vertices", s.isolated_vertices},
               {"left_out_faces", s.left_out_faces},
               {"defects", defects_json(findings.defects)},
               {"weld_distance", flags.weld ? Json(*flags.weld) : Json(nullptr)},
               {"welds", repairs_json(findings.welds)},
               {"repaired", flags.repair},
               {"repairs", repairs_json(findings.repairs)},
               {"warnings", findings.warnings}};
  // A file name need not be UTF-8.
  std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

std::string six_digits(double value) {
  std::ostringstream text;
  text << std::setprecision(6) << value;
  return text.str();
}

template <class Value>
void print_row(std::string_view name, const Value& value) {
  std::cout << "  " << std::left << std::setw(20) << name << value << '\n';
}

// Prints text that comes from the file.
void print_words(std::string_view name, const std::string& words) {
  print_row(name, harmless(words));
}

void print_summary(const MeshSummary& s) {
  print_row("vertices", s.vertices);
  print_row("faces", s.faces);
  if (s.left_out_faces > 0) print_row("faces left out", s.left_out_faces);
  print_row("edges", s.edges);
  print_row("components", s.components);
  print_row("boundary loops", s.boundary_loops);
  print_row("boundary edges", s.boundary_edges);
  print_row("genus", s.genus ? std::to_string(*s.genus) : "none: the surface has one side only");
  if (s.edge_lengths) {
    print_row("edge length", six_digits(s.edge_lengths->least) + " to " +
                                 six_digits(s.edge_lengths->greatest) + ", mean " +
                                 six_digits(s.edge_lengths->mean));
  }
  if (s.smallest_angle) print_row("smallest angle", six_digits(*s.smallest_angle) + " degrees");
  print_row("saddle vertices", s.saddle_vertices);
  print_row("isolated vertices", s.isolated_vertices);
}

void print_text(const Flags& flags, const Findings& findings) {
  std::cout << harmless(flags.file) << ": " << findings.format << '\n';
  print_summary(findings.summary);
  for (const std::string& warning : findings.warnings) print_words("warning", warning);
  for (const RepairAction& action : findings.welds) print_words("welded", action.summary());
  if (flags.weld && findings.welds.empty()) print_row("welded", "no vertices needed it");
  for (const Defect& defect : findings.defects.defects) {
    const bool is_error = type_of(defect.kind).severity == Severity::error;
    print_words(is_error ? "defect, error" : "defect, warning",
                defect.text() + remedy_of(defect, LoadOptions{}.weld_option));
    for (const RepairAction& action : findings.repairs) {
      if (action.remedied == defect.kind) {
        print_words(action.changed ? "  repaired" : "  settled", action.summary());
      }
    }
  }
  if (findings.defects.defects.empty()) print_row("defects", "none");
  if (flags.repair && findings.repairs.empty()) print_row("repaired", "nothing needed it");
}

// Prints the findings about a mesh, even if the mesh is then refused.
void inspect(const Flags& flags) {
  MeshFile file = read_mesh_file(flags.file);
  Findings findings;
  findings.format = std::move(file.format);
  findings.warnings = std::move(file.warnings);
  const LoadOptions options = {
      .repair = flags.repair, .weld = flags.weld, .avoid = read_avoided(flags.avoid)};
  findings.welds = weld_and_leave_out(file, flags.file, options);
  findings.defects = find_defects(file.soup, file.lines);
  if (flags.repair) findings.repairs = repair(file.soup);
  findings.summary = summarize(file.soup);
  if (flags.json) {
    print_json(flags, findings);
  } else {
    print_text(flags, findings);
  }
  require_measurable(file.soup, findings.defects, flags.file, options);
  if (!flags.output.empty()) write_bytes(flags.output, mesh_bytes(file.soup, flags.output));
}

}  // namespace

void add_mesh_command(CLI::App& app) {
  const auto flags = std::make_shared<Flags>();
  CLI::App* const command = app.add_subcommand(
      "mesh",
      "Describe a mesh file: counts, topology, lengths, angles and defects; fails when the "
      "mesh has defects that make distances meaningless");
  command->footer(
      "\nExamples:\n  geodesic-bench mesh bunny.ply\n"
      "  geodesic-bench mesh scan.stl --repair -o scan.ply\n"
      "  geodesic-bench mesh model.obj --weld");
  command->add_option("FILE", flags->file, "mesh file: OBJ, OFF, PLY or STL")
      ->required()
      ->type_name("");
  command->add_flag("--json", flags->json, "print a JSON object");
  add_weld_option(*command, flags->weld);
  add_avoid_options(*command, flags->avoid);
  command->add_flag("--repair", flags->repair,
                    "repair the mesh first and say what was done; joins no vertices");
  command
      ->add_option("-o,--output", flags->output,
                   "write the mesh (without the avoided faces, after the weld and the repair) as "
                   ".obj, .off or .ply")
      ->type_name("FILE");
  command->callback([flags] { inspect(*flags); });
}

}  // namespace geodesic::harness
