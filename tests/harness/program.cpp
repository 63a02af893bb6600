#include "tests/harness/program.h"

#include <sys/wait.h>

#include <cstdlib>

#include "tests/harness/whole_manifest.h"

namespace geodesic::harness {
namespace {

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

// An isolated vertex, followed by a bumpy grid of n by n vertices.
std::string hill(int n) {
  std::ostringstream off;
  off << "OFF\n" << n * n + 1 << ' ' << 2 * (n - 1) * (n - 1) << " 0\n9 9 9\n";
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) off << x << ' ' << y << ' ' << 0.25 * ((x * 7 + y * 5) % 4) << '\n';
  }
  for (int y = 0; y + 1 < n; ++y) {
    for (int x = 0; x + 1 < n; ++x) {
      const int v = 1 + y * n + x;
      off << "3 " << v << ' ' << v + 1 << ' ' << v + n + 1 << '\n';
      off << "3 " << v << ' ' << v + n + 1 << ' ' << v + n << '\n';
    }
  }
  return off.str();
}

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

constexpr const char* kManifest = R"({
  "corpora": {"quick": ["hill", "tetrahedron", "absent"], "missing": ["absent"]},
  "meshes": [
    {"name": "hill", "kind": "generated", "file": "hill.off"},
    {"name": "tetrahedron", "kind": "generated", "file": "tetrahedron.obj"},
    {"name": "absent", "kind": "downloaded", "file": "absent.ply"}]})";

}  // namespace

ProgramTest::ProgramTest() : manifest_(write("manifest.json", whole_manifest(kManifest))) {
  write("hill.off", hill(6));
  write("tetrahedron.obj", kTetrahedron);
}

Output ProgramTest::run(const Program& program, std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin() + 1, {"--manifest", manifest_.string()});
  return run_plainly(program, arguments);
}

Output ProgramTest::run_plainly(const Program& program,
                                const std::vector<std::string>& arguments) const {
  std::string command =
      "GEODESIC_DATASETS=" + quoted(folder_.string()) + ' ' + quoted(program.file);
  for (const std::string& word : program.words) command += ' ' + quoted(word);
  for (const std::string& argument : arguments) command += ' ' + quoted(argument);
  const auto out = folder_ / "stdout", err = folder_ / "stderr";
  command += " >" + quoted(out.string()) + " 2>" + quoted(err.string());
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
}

std::string ProgramTest::exact_solver() const {
  const nlohmann::json list = nlohmann::json::parse(run(PROGRAM, {"list", "--json"}).out);
  for (const nlohmann::json& solver : list.at("solvers")) {
    if (solver.at("exactness") == "exact" && !solver.at("by_name_only").get<bool>() &&
        !solver.at("independent_oracle").get<bool>() &&
        solver.at("abilities").at("max_vertices").is_null()) {
      return solver.at("name");
    }
  }
  throw std::runtime_error("the program has no exact solver");
}

nlohmann::json ProgramTest::read_json(const std::filesystem::path& file) const {
  return nlohmann::json::parse(read(file));
}

}  // namespace geodesic::harness
