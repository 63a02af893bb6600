// Distances of points of faces after one solve, by kept windows and by CGAL's sequence tree.
#ifdef GEODESIC_HAS_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#endif
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "geodesic/geodesic.h"
#include "meshes/random.h"
#include "solvers/core/registry.h"

namespace geodesic {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

constexpr std::size_t kPoints = 100'000;

std::vector<SurfacePoint> random_points(const Mesh& mesh) {
  Random random(1);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    std::array<double, 3> weights;
    for (double& w : weights) w = random.between(0, 1);
    points.push_back(point_in_face(mesh, random.below(mesh.external_face_count()), weights));
  }
  return points;
}

/// Bytes that the heap has given out.
double used_bytes() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// Times single queries of all points.
/// @param distance_at of point i
template <class DistanceAt>
void report_queries(benchmark::State& state, const DistanceAt& distance_at) {
  std::vector<double> times;
  double sum = 0;
  for (auto _ : state) {
    times.clear();
    for (std::size_t i = 0; i < kPoints; ++i) {
      const auto begin = Clock::now();
      sum += distance_at(i);
      times.push_back(seconds_since(begin));
    }
  }
  benchmark::DoNotOptimize(sum);
  std::ranges::sort(times);
  state.counters["median_us"] = 1e6 * times[kPoints / 2];
  state.counters["p99.9_us"] = 1e6 * times[kPoints * 999 / 1000];
  state.counters["largest_us"] = 1e6 * times.back();
}

/// @param solve returns what answers queries
template <class Solve>
auto measured(benchmark::State& state, const Mesh& mesh, const Solve& solve) {
  std::vector<double> times;
  for (int i = 0; i < 4; ++i) {
    const auto begin = Clock::now();
    const auto solved = solve();
    times.push_back(seconds_since(begin));
  }
  const double before = used_bytes();
  auto solved = solve();
  state.counters["construction_ms"] = 1e3 * median(times);
  state.counters["bytes_per_vertex"] = (used_bytes() - before) / mesh.vertex_count();
  return solved;
}

void query_points(benchmark::State& state, const std::string& file, const char* name) {
  const SurfaceMesh mesh = read_mesh(file);
  const std::vector<SurfacePoint> points = random_points(mesh);
  DistanceSolver solver(mesh, name);
  const Field field = measured(state, mesh, [&] { return solver.from({0}, {.anywhere = true}); });
  const auto plain = make_solver(name, mesh);
  std::vector<double> distances(mesh.vertex_count()), times;
  for (int i = 0; i < 9; ++i) {
    const auto begin = Clock::now();
    plain->solve({.sources = {{.at = 0}}}, distances);
    times.push_back(seconds_since(begin));
  }
  state.counters["over_plain_solve"] = state.counters["construction_ms"] / 1e3 / median(times);
  report_queries(state, [&](std::size_t i) { return field.at(points[i]); });
  const auto begin = Clock::now();
  benchmark::DoNotOptimize(field.at(points));
  state.counters["all_at_once_us"] = 1e6 * seconds_since(begin) / kPoints;
}

#ifdef GEODESIC_HAS_CGAL
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface>>;

void query_points_by_cgal(benchmark::State& state, const std::string& file) {
  const SurfaceMesh mesh = read_mesh(file);
  const TriangleSoup soup = mesh.soup();
  Surface surface;
  for (const Vec3& p : soup.positions) surface.add_vertex({p[0], p[1], p[2]});
  for (const auto& [a, b, c] : soup.triangles) {
    surface.add_face(Surface::Vertex_index(a), Surface::Vertex_index(b), Surface::Vertex_index(c));
  }
  const std::vector<SurfacePoint> points = random_points(mesh);
  const auto tree = measured(state, mesh, [&] {
    auto built = std::make_unique<Tree>(surface);
    built->add_source_point(Surface::Vertex_index(0));
    built->build_sequence_tree();
    return built;
  });
  report_queries(state, [&](std::size_t i) {
    const auto& [vertex, face, w] = points[i];
    return tree->shortest_distance_to_source_points(Surface::Face_index(face), {w[0], w[1], w[2]})
        .first;
  });
}
#endif

/// The files named in the environment variable GEODESIC_MESHES, which spaces separate.
const bool registered = [] {
  const char* files = std::getenv("GEODESIC_MESHES");
  std::istringstream names(files != nullptr ? files : "");
  for (std::string file; names >> file;) {
    const std::string mesh = "/" + std::filesystem::path(file).stem().string();
    for (const char* solver : {"edge-based", "mmp"}) {
      benchmark::RegisterBenchmark(("point_queries/" + std::string(solver) + mesh).c_str(),
                                   query_points, file, solver);
    }
#ifdef GEODESIC_HAS_CGAL
    benchmark::RegisterBenchmark(("point_queries/cgal" + mesh).c_str(), query_points_by_cgal, file);
#endif
  }
  return true;
}();

}  // namespace
}  // namespace geodesic
