// The Python module geodesic_bench._native. It takes arrays that the Python code has checked and
// returns new arrays. Only the caller's thread uses Python objects.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "geodesic/geodesic.h"
#include "meshes/avoid.h"
#include "meshes/defects.h"
#include "meshes/isolines.h"
#include "meshes/load.h"
#include "meshes/messages.h"
#include "meshes/pair_distances.h"
#include "meshes/path_file.h"
#include "meshes/row_solver.h"
#include "meshes/threads.h"
#include "meshes/weld.h"
#include "python/native/background.h"
#include "python/native/shared_mesh.h"
#include "python/native/solver_pool.h"
#include "solvers/core/messages.h"
#include "solvers/core/prepared_file.h"
#include "solvers/core/registry.h"
#include "solvers/paths/paths.h"
#include "solvers/paths/through.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

/// An array in C order. Arrays of another type are converted.
template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// Ctrl-C ends a call within this time.
constexpr std::chrono::milliseconds kSignalsAreSeenEvery(50);

using Progress = std::function<void(std::size_t done)>;  // may be empty

/// Calls `function` with a Task in another thread and returns its result. The function may take
/// long and must not use Python objects. The GIL is released during the wait.
/// @param progress called with the number of finished pieces
/// @throws py::error_already_set when a signal handler raises: KeyboardInterrupt for Ctrl-C
template <class Function>
auto in_background(Function function, const Progress& progress = {}) {
  using Result = std::invoke_result_t<Function&, Task&>;
  const auto result = std::make_shared<std::optional<Result>>();
  Background work(
      [result, function = std::move(function)](Task& task) mutable { *result = function(task); });
  const auto ended = [&] {
    const py::gil_scoped_release released;
    return work.wait(kSignalsAreSeenEvery);
  };
  while (!ended()) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress) progress(work.pieces_done());
  }
  if (progress) progress(work.pieces_done());
  return std::move(**result);
}

/// An array that takes over the memory of an object with data().
template <class Memory>
auto array_of(Memory memory, const std::vector<py::ssize_t>& shape) {
  auto owned = std::make_unique<Memory>(std::move(memory));
  const py::capsule owner(owned.get(), [](void* p) { delete static_cast<Memory*>(p); });
  const auto* const data = owned.release()->data();
  return py::array_t<std::remove_cvref_t<decltype(*data)>>(shape, data, owner);
}

template <class T>
py::array_t<T> array_of(std::vector<T> values) {
  const auto size = static_cast<py::ssize_t>(values.size());
  return array_of(std::move(values), {size});
}

/// The rows of an array of shape (n, 3), copied.
template <class T>
std::vector<std::array<T, 3>> rows_of(const Array<T>& array) {
  std::vector<std::array<T, 3>> rows(static_cast<std::size_t>(array.shape(0)));
  if (!rows.empty()) std::memcpy(rows.data(), array.data(), rows.size() * sizeof rows[0]);
  return rows;
}

/// A view that keeps the owner of its data alive and cannot be written to.
template <class T>
py::array_t<T> read_only(const T* data, const std::vector<py::ssize_t>& shape,
                         const py::object& owner) {
  py::array_t<T> view(shape, data, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

/// A read-only view of shape (n, 3).
template <class T>
py::array_t<T> view_of(const std::vector<std::array<T, 3>>& rows, const py::object& owner) {
  return read_only(reinterpret_cast<const T*>(rows.data()),
                   {static_cast<py::ssize_t>(rows.size()), 3}, owner);
}

template <class T>
std::vector<T> values_of(const Array<T>& array) {
  return {array.data(), array.data() + array.size()};
}

using SharedMeshPointer = std::shared_ptr<SharedMesh>;
using PoolPointer = std::shared_ptr<SolverPool>;

/// @param weld_distance joins vertices; none joins none
LoadOptions options_of(bool repair, bool cross_non_manifold, std::optional<double> weld_distance,
                       const Avoided& avoided) {
  return {
      .repair = repair,
      .weld = weld_distance,
      .avoid = avoided,
      .non_manifold_edges = cross_non_manifold ? NonManifoldEdges::crossed : NonManifoldEdges::cut,
      .repair_option = "repair=True",
      .weld_option = "weld=True"};
}

SharedMeshPointer shared(BuiltMesh& built, const LoadOptions& options) {
  return std::make_shared<SharedMesh>(std::move(built.loaded.soup), std::move(built.mesh),
                                      options.non_manifold_edges);
}

/// @param joined_to, left_out as in TriangleSoup
/// @return the mesh, and the warnings about its seams and repairs
std::pair<SharedMeshPointer, std::vector<std::string>> mesh(
    const Array<double>& vertices, const Array<Index>& faces, const Array<Index>& joined_to,
    std::vector<bool> left_out, bool repair, bool cross_non_manifold,
    std::optional<double> weld_distance, const Avoided& avoided) {
  MeshFile content;
  content.soup = {rows_of(vertices), rows_of(faces), values_of(joined_to), std::move(left_out)};
  return in_background([=, content = std::move(content)](Task&) mutable {
    const LoadOptions options = options_of(repair, cross_non_manifold, weld_distance, avoided);
    BuiltMesh built = build_mesh(std::move(content), "the mesh", options);
    std::vector<std::string> warnings;
    if (std::string seams = list_seams(built.loaded.defects, options.weld_option); !seams.empty()) {
      warnings.push_back(std::move(seams));
    }
    for (const RepairAction& action : built.loaded.repairs) {
      warnings.push_back("repair: " + action.summary());
    }
    return std::pair(shared(built, options), std::move(warnings));
  });
}

/// @param read_before the vertices and faces of a file that another package has read
std::pair<SharedMeshPointer, std::vector<std::string>> read(
    const std::filesystem::path& file, bool repair, bool cross_non_manifold,
    std::optional<double> weld_distance, const Avoided& avoided,
    const std::optional<std::pair<Array<double>, Array<Index>>>& read_before) {
  std::optional<TriangleSoup> soup;
  if (read_before) soup = TriangleSoup{rows_of(read_before->first), rows_of(read_before->second)};
  return in_background([=, soup = std::move(soup)](Task&) mutable {
    const LoadOptions options = options_of(repair, cross_non_manifold, weld_distance, avoided);
    MeshFile content;
    if (soup) {
      content.soup = *std::move(soup);
    } else {
      content = read_mesh_file(file);
    }
    BuiltMesh built = build_mesh(std::move(content), file.string(), options);
    return std::pair(shared(built, options), std::move(built.loaded.warnings));
  });
}

std::vector<Defect> defects(const SharedMeshPointer& mesh) {
  return in_background([=](Task&) { return find_defects(mesh->soup()).defects; });
}

/// Points of a mesh's surface, as Python objects hold them.
struct SurfacePoints {
  std::vector<SurfacePoint> points;
};

std::vector<NearestPoint> nearest_to(const SharedMeshPointer& mesh,
                                     const std::vector<Vec3>& places) {
  return in_background([=](Task& task) {
    std::vector<NearestPoint> nearest;
    for (const Vec3& place : places) {
      task.throw_if_abandoned();
      nearest.push_back(mesh->surface().nearest_to(place));
    }
    return nearest;
  });
}

/// @param vertices, faces, weights the arrays of arrays.Points: vertices (kNone for another point),
///        faces (kNone for a place in space), and weights (the coordinates of a place in space)
/// @return the points, and the remark about the place that is farthest from the surface
/// @throws std::invalid_argument for the reasons of point_in_face and nearest_point
std::pair<SurfacePoints, std::string> surface_points(const SharedMeshPointer& mesh,
                                                     const Array<Index>& vertices,
                                                     const Array<Index>& faces,
                                                     const Array<double>& weights) {
  const std::vector<Index> at = values_of(vertices), in = values_of(faces);
  const std::vector<Vec3> numbers = rows_of(weights);
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] == kNone && in[i] == kNone) places.push_back(numbers[i]);
  }
  std::vector<NearestPoint> nearest;
  if (!places.empty()) nearest = nearest_to(mesh, places);  // a thread takes time
  SurfacePoints found;
  double farthest = 0;
  auto next = nearest.begin();
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] != kNone) {
      found.points.emplace_back(at[i]);
    } else if (in[i] != kNone) {
      found.points.push_back(point_in_face(*mesh->mesh(), in[i], numbers[i]));
    } else {
      farthest = std::max(farthest, next->distance);
      found.points.push_back(next++->at);
    }
  }
  return {std::move(found), places.empty() ? "" : mesh->surface().remark_if_far(farthest)};
}

/// The nearest surface points of places, which have shape (k, 3). Returns the arrays of
/// arrays.Points and the distances between the places and these points.
py::tuple nearest_points(const SharedMeshPointer& mesh, const Array<double>& places) {
  const std::vector<NearestPoint> found = nearest_to(mesh, rows_of(places));
  std::vector<Index> vertices, faces;
  std::vector<double> weights, distances;
  for (const NearestPoint& each : found) {
    vertices.push_back(each.at.vertex);
    faces.push_back(each.at.face);
    weights.insert(weights.end(), each.at.weights.begin(), each.at.weights.end());
    distances.push_back(each.distance);
  }
  const auto count = static_cast<py::ssize_t>(found.size());
  return py::make_tuple(array_of(std::move(vertices)), array_of(std::move(faces)),
                        array_of(std::move(weights), {count, 3}), array_of(std::move(distances)));
}

/// Points that may not be given, which means all vertices.
using OptionalPoints = std::optional<SurfacePoints>;

Query query_of(const SurfacePoints& sources, const Array<double>& initial,
               const OptionalPoints& targets, double limit) {
  Query query{.sources = {}, .limit = limit};
  for (py::ssize_t i = 0; i < initial.size(); ++i) {
    query.sources.push_back(
        {.at = sources.points[static_cast<std::size_t>(i)], .distance = initial.data()[i]});
  }
  if (targets) query.targets = targets->points;
  query.stop_at_targets = !query.targets.empty();
  return query;
}

/// @return a pool that is already prepared, and that no other call shares
PoolPointer prepare(const SharedMeshPointer& mesh, const std::string& solver) {
  auto pool = std::make_shared<SolverPool>(mesh->mesh(), solver_named(solver));
  return in_background([=](Task&) {
    const BorrowedSolver first(pool);
    return pool;
  });
}

/// @return what save_prepared writes
py::bytes saved(const PoolPointer& pool) {
  return in_background([=](Task&) {
    std::ostringstream to;
    save_prepared(BorrowedSolver(pool)->solver(), to);
    return std::move(to).str();
  });
}

/// @param bytes read as read_prepared does
PoolPointer load(const SharedMeshPointer& mesh, std::string bytes) {
  return in_background([mesh = mesh->mesh(), bytes = std::move(bytes)](Task&) mutable {
    std::istringstream from(std::move(bytes));
    return std::make_shared<SolverPool>(mesh, read_prepared(*mesh, from));
  });
}

/// @return the fields of Certificate; none if the preparation has no certificate
std::optional<std::tuple<Index, double, double>> certificate(const PoolPointer& pool) {
  const auto found = BorrowedSolver(pool)->solver().certificate();
  if (!found) return std::nullopt;
  return std::tuple(found->sources, found->mean_error, found->largest_error);
}

/// The distances of the targets; of all vertices when no targets are given.
py::array_t<double> distances(const PoolPointer& pool, const SurfacePoints& sources,
                              const Array<double>& initial, const OptionalPoints& targets,
                              double limit) {
  return array_of(in_background([=, query = query_of(sources, initial, targets, limit)](Task&) {
    std::vector<double> all(pool->mesh()->vertex_count()), at_targets(query.targets.size());
    BorrowedSolver(pool_for(pool, sources.points, query.targets))->solve(query, all, at_targets);
    return targets ? at_targets : all;
  }));
}

Paths paths_of(const PoolPointer& pool, const Query& query) {
  return solve_paths(BorrowedSolver(pool)->solver(), *pool->mesh(), query);
}

/// Indices of sources as Python has them: -1 for none.
py::array_t<std::int64_t> signed_indices(const std::vector<Index>& indices) {
  std::vector<std::int64_t> converted(indices.size(), -1);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] != kNone) converted[i] = indices[i];
  }
  return array_of(std::move(converted));
}

/// The distances of targets, and for each the index of the source of its path, -1 where no path
/// leads.
py::tuple targets_and_nearest(const PoolPointer& pool, const SurfacePoints& sources,
                              const Array<double>& initial, const SurfacePoints& targets,
                              double limit) {
  auto [reached, nearest] =
      in_background([=, query = query_of(sources, initial, targets, limit)](Task&) {
        const Paths paths = paths_of(pool, query);
        std::vector<double> lengths;
        std::vector<Index> indices;
        for (std::size_t i = 0; i < query.targets.size(); ++i) {
          const auto path = paths.find_to_target(i);
          lengths.push_back(paths.distance_to_target(i));
          indices.push_back(path ? path->source : kNone);
        }
        return std::pair(std::move(lengths), std::move(indices));
      });
  return py::make_tuple(array_of(std::move(reached)), signed_indices(nearest));
}

/// @return positions of shape (k, 3), the k - 1 faces between them, and the length up to each
py::tuple arrays_of(const std::vector<PathPoint>& points) {
  std::vector<double> positions, travelled;
  std::vector<std::int64_t> faces;
  for (const PathPoint& each : points) {
    positions.insert(positions.end(), each.position.begin(), each.position.end());
    travelled.push_back(each.travelled);
    if (each.face != kNone) faces.push_back(each.face);
  }
  const auto count = static_cast<py::ssize_t>(points.size());
  return py::make_tuple(array_of(std::move(positions), {count, 3}), array_of(std::move(faces)),
                        array_of(std::move(travelled)));
}

using FoundPaths = std::vector<std::optional<Path>>;

/// @return for each path arrays_of its points and the index of its source; None where none leads
py::list list_of(const FoundPaths& paths) {
  py::list list;
  for (const std::optional<Path>& each : paths) {
    if (each) {
      list.append(arrays_of(each->points) + py::make_tuple(each->source));
    } else {
      list.append(py::none());
    }
  }
  return list;
}

/// @param required whether a target without a path is refused
/// @return the path from the nearest source to each target, as list_of
py::list paths(const PoolPointer& pool, const SurfacePoints& sources, const Array<double>& initial,
               const SurfacePoints& targets, bool required) {
  return list_of(in_background([=, query = query_of(sources, initial, targets, kInfinity)](Task&) {
    FoundPaths found;
    if (query.targets.empty()) return found;
    const Paths all = paths_of(pool, query);
    for (std::size_t i = 0; i < query.targets.size(); ++i) {
      found.push_back(required ? all.to_target(i) : all.find_to_target(i));
    }
    return found;
  }));
}

using FieldPointer = std::shared_ptr<const Field>;

FieldPointer solve(const PoolPointer& pool, const SurfacePoints& sources,
                   const Array<double>& initial, double limit, bool anywhere) {
  return in_background([=, query = query_of(sources, initial, {}, limit)](Task&) -> FieldPointer {
    const BorrowedSolver solver(pool);
    return std::make_shared<Field>(solve_field(*solver, pool->mesh(), query, anywhere));
  });
}

py::array_t<std::int64_t> nearest_sources(const FieldPointer& solved) {
  return signed_indices(in_background([=](Task&) { return solved->nearest_sources(); }));
}

py::array_t<double> distances_at(const FieldPointer& solved, const SurfacePoints& points) {
  return array_of(in_background(
      [=](Task& task) { return solved->at(points.points, [&] { task.throw_if_abandoned(); }); }));
}

py::array_t<std::int64_t> nearest_sources_at(const FieldPointer& solved,
                                             const SurfacePoints& points) {
  return signed_indices(in_background([=](Task& task) {
    return solved->nearest_sources(points.points, [&] { task.throw_if_abandoned(); });
  }));
}

/// @return of shape (k, 3)
py::array_t<double> gradients_at(const FieldPointer& solved, const SurfacePoints& points) {
  std::vector<double> numbers = in_background([=](Task& task) {
    std::vector<double> found;
    for (const Vec3& gradient :
         solved->gradients(points.points, [&] { task.throw_if_abandoned(); })) {
      found.insert(found.end(), gradient.begin(), gradient.end());
    }
    return found;
  });
  const auto rows = static_cast<py::ssize_t>(numbers.size() / 3);
  return array_of(std::move(numbers), {rows, 3});
}

/// As `paths`, from a field, without another solve.
py::list paths_to(const FieldPointer& solved, const SurfacePoints& points, bool required) {
  return list_of(in_background([=](Task& task) {
    FoundPaths found;
    for (const SurfacePoint& point : points.points) {
      task.throw_if_abandoned();
      found.push_back(required ? solved->path_to(point) : solved->find_path_to(point));
    }
    return found;
  }));
}

/// @return lengths and angles, one for each vertex
std::pair<py::array_t<double>, py::array_t<double>> log_map_of(const FieldPointer& solved) {
  const std::vector<PolarCoordinates> map = in_background([=](Task&) { return solved->log_map(); });
  std::vector<double> lengths, angles;
  for (const auto& [length, angle] : map) {
    lengths.push_back(length);
    angles.push_back(angle);
  }
  return {array_of(std::move(lengths)), array_of(std::move(angles))};
}

/// @return whether the line ends at the boundary, and arrays_of its points
py::tuple trace(const SharedMeshPointer& mesh, const SurfacePoints& begin, double angle,
                double length) {
  const StraightestLine line =
      in_background([mesh = mesh->mesh(), at = begin.points.at(0), angle, length](Task&) {
        return trace_straightest(*mesh, at, angle, length);
      });
  return py::make_tuple(line.ends_at_boundary) + arrays_of(line.points);
}

/// @return arrays_of its points
py::tuple path_through(const PoolPointer& pool, const SurfacePoints& points, bool closed,
                       bool straighten) {
  const Path path = in_background([=](Task&) {
    return geodesic::path_through(BorrowedSolver(pool)->solver(), *pool->mesh(), points.points,
                                  {.closed = closed, .straighten = straighten});
  });
  return arrays_of(path.points);
}

/// @return for each isoline its level, whether it is closed, and arrays_of its points
py::list isolines(const SharedMeshPointer& mesh, const Array<double>& distances,
                  const Array<double>& levels) {
  const std::vector<Isoline> found =
      in_background([mesh = mesh->mesh(), own = values_of(distances), levels = values_of(levels)](
                        Task&) { return geodesic::isolines(*mesh, own, levels); });
  py::list lines;
  for (const Isoline& each : found) {
    lines.append(py::make_tuple(each.level, each.closed) + arrays_of(each.points));
  }
  return lines;
}

/// A line of Python: its points of shape (k, 3), the length up to each, its level, whether it is
/// closed.
using GivenLine = std::tuple<Array<double>, Array<double>, double, bool>;

/// @param are_isolines otherwise they are paths, whose levels mean nothing
/// @param file without the faces and weights of points, which only .json has
py::bytes line_bytes(const std::filesystem::path& file, const std::vector<GivenLine>& given,
                     bool are_isolines) {
  std::vector<Isoline> lines;
  std::vector<Path> paths;
  for (const auto& [positions, travelled, level, closed] : given) {
    std::vector<PathPoint> points;
    for (const Vec3& position : rows_of(positions)) {
      points.push_back(
          {.at = {}, .position = position, .travelled = travelled.data()[points.size()]});
    }
    if (are_isolines) {
      lines.push_back({.level = level, .closed = closed, .points = std::move(points)});
    } else {
      paths.push_back({.source = 0, .points = std::move(points)});
    }
  }
  return are_isolines ? isoline_bytes(lines, file) : path_bytes(paths, file);
}

/// A solver that returns to its pool with its last owner.
std::shared_ptr<PointSolver> borrowed(const PoolPointer& pool) {
  const auto own = std::make_shared<BorrowedSolver>(pool);
  return {own, &**own};
}

/// @param a, b as many points: the ends of each pair
py::array_t<double> pair_distances(const PoolPointer& pool, const SurfacePoints& a,
                                   const SurfacePoints& b, unsigned threads) {
  return array_of(in_background([=](Task& task) {
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < a.points.size(); ++i) pairs.push_back({a.points[i], b.points[i]});
    const GroupedPairs grouped(pool->solver(), pairs);
    const PoolPointer able = pool_for(pool, grouped.sources(), grouped.targets());
    return grouped.distances(
        *pool->mesh(), threads, [&] { return borrowed(able); }, [&] { task.throw_if_abandoned(); });
  }));
}

/// Sets of points: set i has the points from begins[i] to before begins[i + 1].
struct PointSets {
  SurfacePoints all;
  std::vector<std::int64_t> begins;

  std::size_t count() const { return begins.size() - 1; }
  std::vector<Source> sources(std::size_t set) const {
    std::vector<Source> sources;
    for (auto i = begins[set]; i < begins[set + 1]; ++i) {
      sources.push_back({.at = all.points[static_cast<std::size_t>(i)]});
    }
    return sources;
  }
};

/// Distances from the nearest source of each set. Rows have the order of the sets, columns the
/// order of the targets. All vertices are columns when no targets are given.
struct Matrix {
  PoolPointer pool;
  PointSets rows;
  OptionalPoints columns;
  unsigned threads;
  double limit = kInfinity;

  std::size_t width() const {
    return columns ? columns->points.size() : pool->mesh()->vertex_count();
  }
};

/// Solves all rows and returns after the last one.
/// @param put called once for each row, by several threads at a time
void solve_rows(const Matrix& matrix, Task& task,
                const std::function<void(std::size_t row, std::span<const double>)>& put) {
  Query asked{.sources = {}, .limit = matrix.limit};
  if (matrix.columns) asked.targets = matrix.columns->points;
  asked.stop_at_targets = !asked.targets.empty();
  const PoolPointer pool = pool_for(matrix.pool, matrix.rows.all.points, asked.targets);
  const std::size_t count = matrix.width() > 0 ? matrix.rows.count() : 0;
  do_in_threads(count, matrix.threads, [&]() -> Worker {
    RowSolver solver(borrowed(pool), *matrix.pool->mesh(), asked);
    return [&, solver = std::move(solver)](std::size_t i) mutable {
      task.throw_if_abandoned();
      solver.solve(matrix.rows.sources(i));
      put(i, solver.row());
      task.count_piece();
    };
  });
}

/// @param out array of shape (rows, columns), of any strides and alignment; infinite where no path
///        leads; is no longer written to once this has ended, by Ctrl-C too
template <class T>
void dense(const PoolPointer& pool, const PointSets& rows, const OptionalPoints& columns,
           unsigned threads, const Progress& progress, py::array_t<T, 0> out) {
  const Matrix matrix{pool, rows, columns, threads};
  in_background(
      [=, begin = reinterpret_cast<std::byte*>(out.mutable_data()), to_next_row = out.strides(0),
       to_next = out.strides(1)](Task& task) {
        solve_rows(matrix, task, [&](std::size_t row, auto distances) {
          task.write_for_caller([&] {
            std::byte* at = begin + static_cast<py::ssize_t>(row) * to_next_row;
            for (const double d : distances) {
              const T value = static_cast<T>(d);
              std::memcpy(at, &value, sizeof value);
              at += to_next;
            }
          });
        });
        return true;
      },
      progress);
}

/// @return the finite distances as three arrays: values, column indices, and the begin of each row
template <class T>
py::tuple sparse(const PoolPointer& pool, const PointSets& rows, const OptionalPoints& columns,
                 double limit, unsigned threads, const Progress& progress) {
  struct Compressed {
    std::vector<T> values;
    std::vector<std::int64_t> columns, begins{0};
  };
  const Matrix matrix{pool, rows, columns, threads, limit};
  Compressed all = in_background(
      [=](Task& task) {
        std::vector<Compressed> found(matrix.rows.count());
        solve_rows(matrix, task, [&](std::size_t row, auto distances) {
          for (std::size_t column = 0; column < distances.size(); ++column) {
            if (std::isinf(distances[column])) continue;
            found[row].values.push_back(static_cast<T>(distances[column]));
            found[row].columns.push_back(static_cast<std::int64_t>(column));
          }
        });
        Compressed joined;
        for (const Compressed& row : found) {
          joined.values.insert(joined.values.end(), row.values.begin(), row.values.end());
          joined.columns.insert(joined.columns.end(), row.columns.begin(), row.columns.end());
          joined.begins.push_back(static_cast<std::int64_t>(joined.values.size()));
        }
        return joined;
      },
      progress);
  return py::make_tuple(array_of(std::move(all.values)), array_of(std::move(all.columns)),
                        array_of(std::move(all.begins)));
}

std::string_view severity_of(const Defect& defect) {
  return type_of(defect.kind).severity == Severity::error ? "error" : "warning";
}

/// Names of the solver's parameters as Python keyword arguments.
std::vector<std::string> parameters_of(const Description& solver) {
  std::vector<std::string> names;
  for (const ParameterDescription& each : solver.parameters) {
    names.push_back(each.name);
    std::ranges::replace(names.back(), '-', '_');
  }
  return names;
}

template <class T>
void define_matrices(py::module_& module) {
  const std::string type = sizeof(T) == sizeof(double) ? "float64" : "float32";
  module.def("dense", &dense<T>, py::arg(), py::arg(), py::arg(), py::arg(), py::arg(),
             py::arg().noconvert());
  module.def(("sparse_" + type).c_str(), &sparse<T>);
}

}  // namespace

PYBIND11_MODULE(_native, module) {
  module.attr("__version__") = GEODESIC_VERSION;
  py::register_exception_translator([](const std::exception_ptr error) {  // NOLINT: pybind11's type
    try {
      if (error) std::rethrow_exception(error);
    } catch (const MeshError& mesh_error) {
      PyErr_SetString(PyExc_ValueError, harmless(mesh_error.what()).c_str());
    }
  });

  py::class_<SharedMesh, SharedMeshPointer>(module, "SharedMesh")
      .def_property_readonly("vertices",
                             [](const py::object& self) {
                               return view_of(self.cast<SharedMesh&>().soup().positions, self);
                             })
      .def_property_readonly("faces",
                             [](const py::object& self) {
                               return view_of(self.cast<SharedMesh&>().soup().triangles, self);
                             })
      .def_property_readonly("joined_to",
                             [](const SharedMesh& mesh) { return array_of(mesh.soup().joined_to); })
      .def_property_readonly("left_out",
                             [](const SharedMesh& mesh) { return mesh.soup().left_out; })
      .def_property_readonly("crosses_non_manifold", [](const SharedMesh& mesh) {
        return mesh.non_manifold_edges() == NonManifoldEdges::crossed;
      });

  py::class_<Avoided>(module, "Avoided")
      .def(py::init([](const Array<Index>& vertices, std::optional<std::size_t> vertex_flags,
                       const Array<Index>& faces, std::optional<std::size_t> face_flags) {
        return Avoided{values_of(vertices), values_of(faces), vertex_flags, face_flags};
      }));

  py::class_<SolverPool, PoolPointer>(module, "SolverPool")
      .def_property_readonly("solver", &SolverPool::solver, py::return_value_policy::reference)
      .def_property_readonly("certificate", &certificate);

  py::class_<Field, std::shared_ptr<Field>>(module, "Field")
      .def_property_readonly("distances",
                             [](const py::object& self) {
                               const auto distances = self.cast<Field&>().distances();
                               return read_only(distances.data(),
                                                {static_cast<py::ssize_t>(distances.size())}, self);
                             })
      .def_property_readonly("nearest", &nearest_sources)
      .def("at", &distances_at)
      .def("nearest_at", &nearest_sources_at)
      .def("gradients", &gradients_at)
      .def("paths_to", &paths_to)
      .def("log_map", &log_map_of)
      .def("file_bytes", [](const Field& self, const std::filesystem::path& file) {
        return py::bytes(self.file_bytes(file));
      });

  py::class_<SurfacePoints>(module, "SurfacePoints").def("__len__", [](const SurfacePoints& self) {
    return self.points.size();
  });

  py::class_<PointSets>(module, "PointSets")
      .def(py::init([](const SurfacePoints& all, const Array<std::int64_t>& begins) {
        return PointSets{all, {begins.data(), begins.data() + begins.size()}};
      }))
      .def("__len__", &PointSets::count);

  py::class_<Defect>(module, "Defect", "A kind of defect of a mesh, from `defects`.")
      .def_property_readonly(
          "kind", [](const Defect& d) { return type_of(d.kind).key; },
          "The kind as in docs/adding-a-mesh.md, such as \"non_manifold_edge\".")
      .def_property_readonly("severity", &severity_of,
                             "\"error\" if distances have no meaning, otherwise \"warning\".")
      .def_readonly("count", &Defect::count,
                    "Number of faces, edges, vertices or components with this defect.")
      .def_readonly("first", &Defect::example, "The first of these elements.")
      .def("__str__", &Defect::text)
      .def(
          "__repr__",
          [](const Defect& d) { return "<" + std::string(severity_of(d)) + ": " + d.text() + ">"; })
      .def(py::pickle(
          [](const Defect& d) {
            return py::make_tuple(static_cast<int>(d.kind), d.count, d.example);
          },
          [](const py::tuple& kept) {
            return Defect{.kind = static_cast<DefectKind>(kept[0].cast<int>()),
                          .count = kept[1].cast<std::size_t>(),
                          .example = kept[2].cast<std::string>()};
          }));

  py::class_<Description>(module, "Solver", "A solver and its origin, from `solvers`.")
      .def_readonly("name", &Description::name, "Its name, for the argument `solver`.")
      .def_readonly("family", &Description::family, "The family of solvers, such as \"MMP\".")
      .def_readonly("paper", &Description::paper, "The paper to cite.")
      .def_readonly("remarks", &Description::remarks, "Licences, limits and other notes.")
      .def_property_readonly("parameters", &parameters_of,
                             "Names of its parameters, which are keyword arguments of a query.")
      .def_property_readonly(
          "exact", [](const Description& d) { return d.exactness == Exactness::exact; },
          "Whether distances are exact. If not, they are upper bounds.")
      .def_property_readonly(
          "prepares", [](const Description& d) { return d.abilities.saves; },
          "Whether `Mesh.prepare` accepts it.")
      .def("__repr__", [](const Description& d) { return "<" + d.name + ": " + d.paper + ">"; })
      .def(py::pickle(
          [](const Description& d) { return py::make_tuple(d.name); },
          [](const py::tuple& kept) { return solver_named(kept[0].cast<std::string>()); }));

  module.def("mesh", &mesh);
  module.def("read", &read);
  module.def("defects", &defects);
  module.def("unknown_name", &unknown_name);
  module.def("solvers", &registered_solvers, py::return_value_policy::reference);
  module.def("surface_points", &surface_points);
  module.def("pool", [](SharedMesh& mesh, const std::string& solver) { return mesh.pool(solver); });
  module.def("prepare", &prepare);
  module.def("saved", &saved);
  module.def("load", &load);
  module.def("distances", &distances);
  module.def("targets_and_nearest", &targets_and_nearest);
  module.def("solve", &solve);
  module.def("paths", &paths);
  module.def("path_through", &path_through);
  module.attr("MOST_LEVELS") = kMostLevels;
  module.def("equal_levels", [](const Array<double>& distances, Index count) {
    return array_of(equal_levels(values_of(distances), count));
  });
  module.def("isolines", &isolines);
  module.def("line_bytes", &line_bytes);
  module.def("trace", &trace);
  module.def("angle_of",
             [](const SharedMeshPointer& mesh, const SurfacePoints& begin, const Vec3& vector) {
               return angle_of(*mesh->mesh(), begin.points.at(0), vector);
             });
  module.def("total_angle", [](const SharedMeshPointer& mesh, const SurfacePoints& point) {
    return total_angle(*mesh->mesh(), point.points.at(0));
  });
  module.def("pair_distances", &pair_distances);
  module.def("nearest_points", &nearest_points);
  define_matrices<double>(module);
  define_matrices<float>(module);
}

}  // namespace geodesic::python
