#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "harness/base/error.h"
#include "harness/base/interruption.h"
#include "harness/base/large_pages.h"
#include "harness/commands/commands.h"
#include "harness/commands/solving/answers.h"
#include "harness/commands/values.h"
#include "meshes/path_file.h"
#include "solvers/core/prepared_file.h"

namespace geodesic::harness {
namespace {

constexpr const char* kStandardOutput = "-";

// Checks that the file is none that the command reads.
void check_output(const char* flag, const std::string& output, const SolveFlags& flags,
                  const MeshEntry& entry) {
  check_output_differs(flag, output,
                       {{"mesh", entry.file},
                        {"--sources-file", flags.sources_file},
                        {"--targets-file", flags.targets_file},
                        {"--pairs", flags.pairs_file},
                        {"--sets", flags.sets_file},
                        {"--avoid", flags.avoid.vertices},
                        {"--avoid-faces", flags.avoid.faces},
                        {"--prepared", flags.prepared}});
}

/// @param output file for the distances; empty for none
/// @return the JSON to print
Json solve_mesh(const SolveFlags& flags, const Description& solver, const WrittenValues& values,
                const MeshEntry& entry, const std::string& output) {
  Outputs outputs;
  if (!output.empty()) {
    if (output != kStandardOutput) check_output("--output", output, flags, entry);
    outputs.distances.emplace(output);
    if (outputs.distances->is_mesh() &&
        (wants_rows(flags) || flags.angles || !flags.pairs_file.empty())) {
      throw HarnessError(
          "--output '" + output +
          "' is a mesh with the distances of one query: with --each, --sets, --pairs and "
          "--angles write .txt, .csv or .npy");
    }
  }
  const auto open_lines = [&](std::optional<AtomicFile>& to, const char* flag,
                              const std::string& file) {
    if (file.empty()) return;
    check_path_file(file);
    check_output(flag, file, flags, entry);
    to.emplace(file);
  };
  open_lines(outputs.paths, "--paths", flags.paths);
  open_lines(outputs.isolines, "--isolines", flags.isolines);
  check_output("--save-prepared", flags.save_prepared, flags, entry);
  const NonManifoldEdges non_manifold_edges =
      flags.cross_non_manifold ? NonManifoldEdges::crossed : NonManifoldEdges::cut;
  const BuiltMesh built = build_mesh(entry.file, {.repair = flags.repair,
                                                  .weld = flags.weld,
                                                  .avoid = values.avoided,
                                                  .non_manifold_edges = non_manifold_edges});
  Problem problem = read_problem(flags, solver, entry, built, values);
  for (const std::string& warning : built.loaded.warnings) {
    warn(entry.file.string() + ": " + warning);
  }

  Json json{{"solver", problem.solver.name},
            {"mesh", entry.name},
            {"vertices", problem.mesh.vertex_count()},
            {"faces", problem.mesh.external_face_count()},
            {"limit", std::isinf(flags.limit) ? Json(nullptr) : Json(flags.limit)}};
  if (!problem.places.empty()) json["places"] = problem.places;
  const auto answer = problem.grouped     ? solve_pairs
                      : wants_rows(flags) ? solve_separately
                                          : solve_jointly;
  json.update(answer(problem, outputs));
  if (outputs.distances) outputs.distances->commit();
  if (outputs.paths) outputs.paths->commit();
  if (outputs.isolines) outputs.isolines->commit();
  return json;
}

/// One file for the distances of each mesh in --out, all different.
std::vector<std::string> files_in_folder(const std::filesystem::path& folder,
                                         const std::vector<MeshEntry>& entries) {
  std::vector<std::string> files;
  for (const MeshEntry& entry : entries) {
    const std::string file = folder / (entry.file.stem().string() + ".txt");
    if (std::ranges::count(files, file) > 0) {
      throw HarnessError("--out: two of the meshes would be written to " + file);
    }
    files.push_back(file);
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw CannotWrite("--out " + folder.string() + ": " + error.message());
  return files;
}

/// Solves each mesh by itself. A mesh that cannot be solved is reported, and the others are solved.
void solve_many(const SolveFlags& flags, const Description& solver, const WrittenValues& values,
                const std::vector<MeshEntry>& entries) {
  const std::vector<std::string> files = flags.output_folder.empty()
                                             ? std::vector<std::string>(entries.size())
                                             : files_in_folder(flags.output_folder, entries);
  std::size_t failed = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    try {
      Json json = solve_mesh(flags, solver, values, entries[i], files[i]);
      if (!files[i].empty()) json["output"] = files[i];
      std::cout << json.dump() << std::endl;
    } catch (const CannotWrite&) {
      throw;  // the next file cannot be written either
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {  // also what a plug-in throws
      warn(entries[i].name + ": " + error.what());
      ++failed;
    }
  }
  if (failed == 0) return;
  throw HarnessError(std::to_string(failed) + " of " + std::to_string(entries.size()) +
                     " meshes were not solved");
}

// The name of the solver whose preparation is in a file.
std::string solver_in(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw HarnessError("--prepared " + file + ": " + std::strerror(errno));
  try {
    return name_in_prepared(stream);
  } catch (const std::invalid_argument& error) {
    throw HarnessError("--prepared " + file + ": " + error.what());
  }
}

void run_solve(SolveFlags& flags) {
  check_combination(flags);
  if (!flags.prepared.empty()) flags.solver = solver_in(flags.prepared);
  const WrittenValues values(flags);
  const Description& solver = solver_named(flags.solver);
  set_instruction_set(instruction_set_named(flags.vectors));
  std::vector<MeshEntry> entries;
  for (const std::string& mesh : flags.meshes) entries.push_back(find_mesh(mesh, flags.manifest));
  const LargePages large_pages;
  if (entries.size() > 1 || !flags.output_folder.empty()) {
    return solve_many(flags, solver, values, entries);
  }
  const Json json = solve_mesh(flags, solver, values, entries.front(), flags.output);
  (flags.output == kStandardOutput ? std::cerr : std::cout) << json.dump(2) << std::endl;
}

}  // namespace

void add_solve_command(CLI::App& app) {
  const auto flags = std::make_shared<SolveFlags>();
  CLI::App* command = app.add_subcommand("solve", "Compute distances; print times as JSON");
  command
      ->add_option("mesh", flags->meshes,
                   "mesh files, or names of the manifest; each is solved separately, and its JSON "
                   "object is one line if there are several")
      ->required()
      ->type_name("MESH");
  command
      ->add_option("--source", flags->sources,
                   std::string("source, repeatable, separated by commas: ") + kPointForms +
                       "; +0.5 behind it is an initial distance; distances are to the nearest "
                       "source")
      ->allow_extra_args(false)
      ->type_name("POINT");
  command
      ->add_option("--sources-file", flags->sources_file,
                   "file of sources: a JSON list, or CSV; a row of three numbers with a decimal "
                   "point is a place")
      ->type_name("FILE");
  command
      ->add_option("--target", flags->targets,
                   "point whose distance is wanted, written as a source, repeatable")
      ->allow_extra_args(false)
      ->type_name("POINT");
  command
      ->add_option("--targets-file", flags->targets_file,
                   "file of targets, in the formats of --sources-file")
      ->type_name("FILE");
  CLI::Option* const pairs =
      command
          ->add_option("--pairs", flags->pairs_file,
                       "file of pairs of points whose distance is wanted: two points a line, or a "
                       "JSON list of lists of two, written as in --sources-file")
          ->type_name("FILE");
  CLI::Option* const sets =
      command
          ->add_option(
              "--sets", flags->sets_file,
              "file of sets of sources, each solved separately: one a line, or a JSON list "
              "of lists; a row has the distances from the nearest point of its set")
          ->type_name("FILE");
  command->add_flag("--stop-at-targets", flags->stop_at_targets,
                    "end when the targets are reached; vertices farther than all of them are "
                    "unreachable");
  command
      ->add_option("--paths", flags->paths,
                   "file for the shortest paths to the targets: .obj, .ply or .json")
      ->type_name("FILE");
  command
      ->add_option("--isolines", flags->isolines,
                   "file for the lines of equal distance at --levels: .obj, .ply or .json")
      ->type_name("FILE");
  command
      ->add_option("--levels", flags->levels,
                   "levels of the isolines: a number of them, equal steps apart up to the largest "
                   "distance, or distances, separated by commas; 3 is a number, 3.0 a distance")
      ->type_name("N|DISTANCES");
  command->add_flag("--nearest-source", flags->nearest_source,
                    "a second column of --output: the number of the nearest source in the list of "
                    "sources, -1 where no path leads");
  command->add_flag("--angles", flags->angles,
                    "a further column of --output: the angle in radians at which the shortest path "
                    "leaves its source (the logarithmic map)");
  command->add_flag("--each", flags->each, "solve from each source separately");
  command
      ->add_option(
          "--threads", flags->threads,
          "threads that work at the same time (default 1): with --each, --sets and --pairs "
          "each on a source or set of its own while there are enough, otherwise on one source, "
          "where "
          "the solver can (edge-based)")
      ->check(from_to(1, 1024));
  command
      ->add_option(
          "-o,--output", flags->output,
          "file for the distances, .txt, .csv or .npy: one a vertex, with --pairs one a pair, "
          "with --each a row a source, with --sets a row a set; .ply and .vtk have the mesh too, "
          "for MeshLab (quality) and ParaView; - is standard output, and the JSON object then goes "
          "to "
          "standard error")
      ->type_name("FILE");
  command
      ->add_option("--out", flags->output_folder,
                   "folder for the distances of several meshes: MESH.txt for each")
      ->type_name("DIR")
      ->excludes("--output");
  command->add_flag(
      "--check", flags->check,
      "compare with brute force on up to 400 faces, otherwise with another exact solver");
  command->add_flag("--counters", flags->counters,
                    "solve again for counters, phases and the peak of memory");
  add_weld_option(*command, flags->weld);
  add_avoid_options(*command, flags->avoid);
  command->add_flag("--repair", flags->repair,
                    "repair defects of the mesh, and say which; joins no vertices");
  add_crossing_option(*command, flags->cross_non_manifold);
  command->add_option("--limit", flags->limit, "distance beyond which vertices are unreachable")
      ->check(zero_or_above());
  command
      ->add_option("--solver", flags->solver,
                   "solver (see geodesic-bench list; default: " + flags->solver + ")")
      ->type_name("NAME");
  command
      ->add_option("--save-prepared", flags->save_prepared,
                   "file for what the solver prepared, of one that prepares (straight-graph)")
      ->type_name("FILE");
  command
      ->add_option("--prepared", flags->prepared,
                   "file of --save-prepared, read in place of preparing again; it names its solver")
      ->type_name("FILE")
      ->excludes("--solver");
  command
      ->add_option("--vectors", flags->vectors,
                   "instruction set of the solver: auto, plain, avx2 or avx512")
      ->type_name("SET");
  command->add_option("--manifest", flags->manifest, "list of meshes and corpora")
      ->type_name("FILE");
  const std::initializer_list<std::pair<const char*, std::vector<const char*>>> groups = {
      {"From where, to where",
       {"--source", "--sources-file", "--target", "--targets-file", "--pairs", "--sets",
        "--stop-at-targets", "--limit"}},
      {"What is written",
       {"--output", "--out", "--nearest-source", "--angles", "--paths", "--isolines", "--levels"}},
      {"How it is solved",
       {"--solver", "--each", "--threads", "--save-prepared", "--prepared", "--vectors"}},
      {"The mesh",
       {"--weld", "--avoid", "--avoid-faces", "--repair", "--cross-non-manifold", "--manifest"}},
      {"What is checked and counted", {"--check", "--counters"}}};
  for (const auto& [group, options] : groups) {
    for (const char* option : options) command->get_option(option)->group(group);
  }
  for (const char* other :
       {"--source", "--sources-file", "--target", "--targets-file", "--stop-at-targets", "--limit",
        "--nearest-source", "--angles", "--paths", "--isolines", "--levels", "--each", "--check",
        "--counters"}) {
    pairs->excludes(other);
  }
  for (const char* other : {"--source", "--sources-file", "--pairs", "--each", "--nearest-source",
                            "--angles", "--paths", "--isolines", "--levels", "--counters"}) {
    sets->excludes(other);
  }
  command->footer(
      "\nExamples:\n  geodesic-bench solve bunny.ply --source 0 --output d.npy\n"
      "  geodesic-bench solve bunny.ply --source edge:3-7:0.25 --target at:0,0.1,0 --paths p.obj\n"
      "  geodesic-bench solve bunny.ply --solver mmp --source 0,17,99 --each --threads 4\n"
      "  geodesic-bench solve bunny.ply --sets regions.json --threads 4 --output rows.npy\n"
      "  geodesic-bench solve bunny.ply --pairs pairs.csv --threads 4 --output d.csv\n"
      "  geodesic-bench solve scans/*.ply --source 0 --out distances");
  command->callback([flags] { run_solve(*flags); });
}

}  // namespace geodesic::harness
