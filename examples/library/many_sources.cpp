// many_sources MESH_FILE SOURCE...: prints the farthest vertex from each of some sources, with as
// many threads as the machine has.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "meshes/load.h"
#include "solvers/core/registry.h"

namespace {

using namespace geodesic;

struct Farthest {
  Index vertex = kNone;
  double distance = 0;
};

/// Returns the farthest of the reachable vertices.
Farthest farthest(const std::vector<double>& distances) {
  Farthest result;
  for (std::size_t v = 0; v < distances.size(); ++v) {
    if (std::isfinite(distances[v]) && distances[v] >= result.distance) {
      result = {static_cast<Index>(v), distances[v]};
    }
  }
  return result;
}

/// Threads share the mesh. Each has its own solver, which keeps its memory for the next source.
std::vector<Farthest> farthest_from_each(const Mesh& mesh, const std::vector<Index>& sources) {
  std::vector<Farthest> results(sources.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    const std::unique_ptr<Solver> solver = make_solver("edge-based", mesh);
    std::vector<double> distances(mesh.vertex_count());
    for (std::size_t i = next++; i < sources.size(); i = next++) {
      solver->solve({.sources = {{.at = sources[i]}}}, distances);
      results[i] = farthest(distances);
    }
  };
  std::vector<std::jthread> threads(std::max(1U, std::thread::hardware_concurrency()));
  for (std::jthread& thread : threads) thread = std::jthread(work);
  threads.clear();  // joins them
  return results;
}

}  // namespace

int main(int argument_count, char** arguments) try {
  if (argument_count < 3) {
    std::fprintf(stderr, "Usage: many_sources MESH_FILE SOURCE...\n");
    return 1;
  }
  // Rejects meshes with errors; {.repair = true} repairs them.
  const LoadedMesh loaded = load_mesh(arguments[1]);
  for (const std::string& warning : loaded.warnings) {
    std::fprintf(stderr, "warning: %s\n", warning.c_str());
  }
  const Mesh mesh(loaded.soup, Numbering::along_surface);
  std::vector<Index> sources;
  for (int i = 2; i < argument_count; ++i) {
    const unsigned long source = std::stoul(arguments[i]);
    // Checked here, since an exception in a thread would end the program.
    if (source >= mesh.vertex_count())
      throw std::invalid_argument("no vertex " + std::string(arguments[i]));
    sources.push_back(static_cast<Index>(source));
  }
  const std::vector<Farthest> results = farthest_from_each(mesh, sources);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    std::printf("%u %u %.17g\n", sources[i], results[i].vertex, results[i].distance);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "many_sources: %s\n", error.what());
  return 1;
}
