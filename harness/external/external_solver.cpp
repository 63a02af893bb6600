#include "harness/external/external_solver.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/plugins.h"
#include "harness/base/process.h"
#include "meshes/connectivity.h"
#include "meshes/formats/npy.h"
#include "meshes/formats/parsing.h"
#include "meshes/mesh_file.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

constexpr const char* kSaid = "said.txt";  // standard output of the program
constexpr int kReadings = 3;               // runs, of which the fastest counts
constexpr double kLeastSeconds = 1e-6;     // a difference of two processes may be negative

struct Place {
  std::string_view word;
  const char* file;
};
constexpr Place kMeshes[] = {
    {"{mesh}", "mesh.obj"},     {"{mesh.obj}", "mesh.obj"},         {"{mesh.off}", "mesh.off"},
    {"{mesh.ply}", "mesh.ply"}, {"{vertices.npy}", "vertices.npy"}, {"{faces.npy}", "faces.npy"}};
constexpr Place kDistances[] = {{"{distances}", "distances.txt"},
                                {"{distances.npy}", "distances.npy"}};

std::string bytes_of(const TriangleSoup& soup, const std::string& file) {
  const auto array = [](const auto& rows) {
    using Number = std::remove_cvref_t<decltype(rows[0][0])>;
    const auto numbers = std::span(rows).size() * 3;
    return npy_bytes(std::span<const Number>(rows.data()->data(), numbers), 3);
  };
  if (file == "vertices.npy") return array(soup.positions);
  return file == "faces.npy" ? array(soup.triangles) : mesh_bytes(soup, file);
}

void replace_all(std::string& text, std::string_view what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
    text.replace(at, what.size(), by);
  }
}

}  // namespace

ExternalSolver::ExternalSolver(const Mesh& mesh, const Description& description,
                               const ExternalProgram& program)
    : Solver(mesh, description), program_(program) {
  for (const auto& [word, file] : kMeshes) {
    if (program.command.find(word) == std::string::npos || fs::exists(folder_ / file)) continue;
    write_bytes(folder_ / file, bytes_of(without_left_out(soup_of(mesh)), file));
  }
}

void ExternalSolver::run(const Start& start, std::span<double> distances) {
  const MeshNumbers& numbers = mesh().numbers();
  std::string sources;
  for (const StartVertex& each : start.vertices) {
    if (!sources.empty()) sources += ',';
    sources += std::to_string(numbers.external_vertex(each.vertex));
  }
  for (const auto& [word, file] : kDistances) fs::remove(folder_ / file);
  const Process process = start_program(sources);
  const std::vector<double> written = read_distances();
  for (Index v = 0; v < distances.size(); ++v) distances[v] = written[numbers.external_vertex(v)];
  note_times(process);
}

ExternalSolver::Process ExternalSolver::start_program(const std::string& sources) const {
  std::string command = program_.command;
  for (const auto& [word, file] : kMeshes) replace_all(command, word, quoted(folder_ / file));
  for (const auto& [word, file] : kDistances) replace_all(command, word, quoted(folder_ / file));
  replace_all(command, "{sources}", sources.empty() ? "''" : quoted(sources));
  replace_all(command, "{folder}", quoted(program_.folder));
  // The command has its own lines, because it may have several, and comments. When a limit kills
  // this process, the shell gets SIGTERM and kills its group, which includes the program. The
  // program runs in the background, because a signal interrupts only a shell that waits.
  command = "exec > " + quoted(folder_ / kSaid) + "\ntrap 'kill -KILL 0' TERM\n{\n" + command +
            "\n} &\nwait $!";
  Ended ended = run_program("/bin/sh", {"-c", command}, [] {}, {.signal_at_death = SIGTERM});
  if (constexpr int kBySignal = 128; ended.code > kBySignal) {
    ended.crashed = true;
    ended.code -= kBySignal;
  }
  if (!ended.succeeded()) {
    throw HarnessError(program_.name + ": " + ended.describe() +
                       (program_.install.empty() ? "" : "; to install it: " + program_.install));
  }
  return {ended.real_seconds, ended.cpu_seconds, ended.peak_resident_bytes};
}

std::vector<double> ExternalSolver::read_distances() const {
  std::vector<double> distances;
  const std::string name = program_.name + "'s distances";
  const auto* const written = std::ranges::find_if(
      kDistances, [&](const Place& place) { return fs::exists(folder_ / place.file); });
  if (written == std::end(kDistances)) {
    throw HarnessError(program_.name + ": it ended without writing the file of {distances}");
  }
  const std::string bytes = read_bytes(folder_ / written->file);
  if (is_npy(bytes)) {
    distances = parse_npy_numbers(bytes, name);
  } else {
    TextReader text(text_of(bytes, name), name);
    while (text.next_line()) {
      while (!text.at_line_end()) distances.push_back(text.number("distance"));
    }
  }
  if (distances.size() != mesh().vertex_count()) {
    throw HarnessError(program_.name + ": it wrote " + std::to_string(distances.size()) +
                       " distances for " + std::to_string(mesh().vertex_count()) + " vertices");
  }
  return distances;
}

void ExternalSolver::note_times(const Process& process) {
  last_ = {.real = process.real, .cpu = process.cpu, .peak_bytes = process.peak_bytes};
  std::optional<double> reported;
  std::ifstream said(folder_ / kSaid);
  for (std::string line; std::getline(said, line);) {
    std::istringstream words(line);
    std::string key;
    double seconds = 0;
    if (!(words >> key >> seconds) || !(seconds >= 0)) continue;
    if (key == "solve_time") reported = seconds;
    if (key == "prepare_time") last_.prepare = seconds;
  }
  if (reported) {
    last_.real = last_.cpu = *reported;
    last_.of = "reported";
    return;
  }
  if (!reading_) reading_ = reading();
  if (!*reading_) return;
  last_.real = std::max(process.real - (*reading_)->real, kLeastSeconds);
  last_.cpu = std::max(process.cpu - (*reading_)->cpu, kLeastSeconds);
  last_.of = "process less reading";
}

std::optional<ExternalSolver::Process> ExternalSolver::reading() const {
  std::optional<Process> fastest;
  for (int i = 0; i < kReadings; ++i) {
    try {
      const Process process = start_program("");
      if (!fastest || process.cpu < fastest->cpu) fastest = process;
    } catch (const HarnessError&) {
      return std::nullopt;
    }
  }
  return fastest;
}

}  // namespace geodesic::harness
