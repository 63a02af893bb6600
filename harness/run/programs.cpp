#include "harness/run/programs.h"

#include <set>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/base/process.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

constexpr const char* kTetrahedron =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

// Uses only options that every revision has.
Json result_of_small_run(const Program& program, const fs::path& folder) {
  const fs::path out = folder / program.name, result = out / "run.json";
  if (!fs::exists(result)) {
    fs::remove_all(out);  // left by an interrupted run
    const fs::path mesh = folder / "tetrahedron.off", suite = folder / "suite.json";
    write_bytes(mesh, kTetrahedron);
    write_json(suite, {{"meshes", {fs::absolute(mesh).string()}},
                       {"sources", 1},
                       {"repetitions", 1},
                       {"min_time", 1e-6}});
    const Ended ended =
        run_program(program.file,
                    {"run", suite.string(), "--recordings", "none", "--out", out.string()}, [] {});
    if (!fs::exists(result)) {
      throw HarnessError("program '" + program.name + "' (" + program.file.string() +
                         ") cannot measure a tetrahedron: " + ended.describe());
    }
  }
  return read_json(result);
}

}  // namespace

void check_programs(const std::vector<Program>& programs) {
  if (programs.size() == 1) {
    throw HarnessError("--program is given once: two programs or more are measured alternating");
  }
  std::set<std::string> names;
  for (const auto& [name, file, facts] : programs) {
    check_name("program name", name);
    if (!names.insert(name).second) throw HarnessError("two programs are named '" + name + "'");
    if (!fs::is_regular_file(file)) {
      throw HarnessError("program '" + name + "': no such file: " + file.string());
    }
  }
}

std::vector<Program> with_facts(std::vector<Program> programs, const fs::path& folder) {
  if (!programs.empty()) fs::create_directories(folder / "programs");
  for (Program& program : programs) {
    const Json result = result_of_small_run(program, folder / "programs");
    const Json& itself = result.at("context").at("geodesic_bench");
    program.facts = {{"name", program.name},
                     {"path", program.file.string()},
                     {"sha256", sha256_of_file(program.file)}};
    for (const char* key : {"revision", "modified", "compiler", "compiler_flags", "build_type"}) {
      program.facts[key] = itself.at(key);
    }
  }
  return programs;
}

}  // namespace geodesic::harness
