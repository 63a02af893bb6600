// The Python module geodesic_bench._native: arrays that its Python part has checked go in, and new
// arrays come out. No thread but the caller's ever sees a Python object.
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
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "meshes/defects.h"
#include "meshes/load.h"
#include "meshes/messages.h"
#include "python/native/background.h"
#include "python/native/shared_mesh.h"
#include "solvers/core/messages.h"
#include "solvers/core/registry.h"
#include "solvers/paths/paths.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

/// In C order; what has another type was converted.
template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// Ctrl-C ends a call within this time.
constexpr std::chrono::milliseconds kSignalsAreSeenEvery(50);

/// Waits for the work with the GIL released.
/// @param progress called with the number of pieces done; may be empty
/// @throws py::error_already_set as the handler of a signal does, KeyboardInterrupt for Ctrl-C
void wait_for(Background& work, const std::function<void(std::size_t)>& progress = {}) {
  const auto done = [&] {
    const py::gil_scoped_release released;
    return work.wait(kSignalsAreSeenEvery);
  };
  while (!done()) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress) progress(work.done());
  }
  if (progress) progress(work.done());
}

/// What a function returns that takes long and uses no Python object.
template <class Function>
auto in_background(Function function) {
  const auto result = std::make_shared<std::optional<decltype(function())>>();
  Background work(1, 1, [=]() -> Worker { return [=](std::size_t) { *result = function(); }; });
  wait_for(work);
  return std::move(**result);
}

/// An array that takes over the memory of a vector.
template <class T>
py::array_t<T> array_of(std::vector<T> values, const std::vector<py::ssize_t>& shape) {
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  const py::capsule owner(owned.get(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>(shape, owned.release()->data(), owner);
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

/// A view of shape (n, 3) that keeps its owner alive and cannot be written to.
template <class T>
py::array view_of(const std::vector<std::array<T, 3>>& rows, const py::object& owner) {
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows.size()), 3};
  const py::array_t<T> view(shape, reinterpret_cast<const T*>(rows.data()), owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

std::vector<Index> indices_of(const Array<Index>& array) {
  return {array.data(), array.data() + array.size()};
}

using SharedMeshPointer = std::shared_ptr<SharedMesh>;

SharedMeshPointer mesh_from(const Array<double>& vertices, const Array<Index>& faces) {
  return std::make_shared<SharedMesh>(TriangleSoup{rows_of(vertices), rows_of(faces)});
}

std::pair<SharedMeshPointer, std::vector<std::string>> read(const std::filesystem::path& file,
                                                            bool repair) {
  return in_background([=] {
    LoadedMesh loaded = load_mesh(file, {.repair = repair});
    return std::pair(std::make_shared<SharedMesh>(std::move(loaded.soup)),
                     std::move(loaded.warnings));
  });
}

std::vector<Defect> defects(const SharedMeshPointer& mesh) {
  return in_background([=] { return find_defects(mesh->soup()).defects; });
}

Query query_of(const Array<Index>& sources, const Array<double>& initial, double limit) {
  Query query{.sources = {}, .limit = limit};
  for (py::ssize_t i = 0; i < sources.size(); ++i) {
    query.sources.push_back({.at = sources.data()[i], .distance = initial.data()[i]});
  }
  return query;
}

py::array_t<double> distances(const SharedMeshPointer& mesh, const std::string& solver,
                              const Array<Index>& sources, const Array<double>& initial,
                              double limit) {
  return array_of(in_background([=, query = query_of(sources, initial, limit)] {
    std::vector<double> result(mesh->soup().positions.size());
    BorrowedSolver(mesh, solver).solve(query, result);
    return result;
  }));
}

Paths solve_paths(const SharedMeshPointer& mesh, const std::string& solver, const Query& query) {
  std::vector<double> distances(mesh->soup().positions.size());
  Recording recording;
  recording.what = Record::paths;
  BorrowedSolver(mesh, solver).solve(query, distances, &recording);
  return {mesh->mesh(), query, std::move(distances), std::move(recording)};
}

/// The distances, and by vertex the source that its path comes from, -1 where none does.
py::tuple distances_and_nearest(const SharedMeshPointer& mesh, const std::string& solver,
                                const Array<Index>& sources, const Array<double>& initial,
                                double limit) {
  auto [all, nearest] = in_background([=, query = query_of(sources, initial, limit)] {
    const Paths paths = solve_paths(mesh, solver, query);
    const std::vector<Index> indices = paths.nearest_sources();
    std::vector<std::int64_t> signed_indices(indices.size(), -1);
    for (std::size_t v = 0; v < indices.size(); ++v) {
      if (indices[v] != kNone) signed_indices[v] = indices[v];
    }
    return std::pair(paths.distances(), std::move(signed_indices));
  });
  return py::make_tuple(array_of(std::move(all)), array_of(std::move(nearest)));
}

/// A vertex, or kNone and a point in a face: the face and its weights.
using GivenPoint = std::tuple<Index, Index, std::array<double, 3>>;

/// @return of the path from one point to another: positions of shape (k, 3), the k - 1 faces
///         between them, and the length up to each
py::tuple path(const SharedMeshPointer& mesh, const std::string& solver, const GivenPoint& source,
               const GivenPoint& target) {
  const Path found = in_background([=] {
    const auto point = [&](const GivenPoint& given) {
      const auto& [vertex, face, weights] = given;
      return vertex != kNone ? SurfacePoint(vertex) : point_in_face(mesh->mesh(), face, weights);
    };
    const Query query{
        .sources = {{point(source), 0}}, .targets = {point(target)}, .stop_at_targets = true};
    return solve_paths(mesh, solver, query).to_target(0);
  });
  std::vector<double> positions, travelled;
  std::vector<Index> faces;
  for (const PathPoint& each : found.points) {
    positions.insert(positions.end(), each.position.begin(), each.position.end());
    travelled.push_back(each.travelled);
    if (each.face != kNone) faces.push_back(each.face);
  }
  const auto count = static_cast<py::ssize_t>(found.points.size());
  return py::make_tuple(array_of(std::move(positions), {count, 3}), array_of(std::move(faces)),
                        array_of(std::move(travelled)));
}

/// Distances from each of some sources by itself, at some vertices, in the order of both.
struct Matrix {
  std::vector<Index> rows, columns;
  double limit = kInfinity;
};

/// @param put called once a row, by several threads at a time, with the distances of all vertices;
///        it owns what it writes to
/// @return after the last row
void solve_rows(const SharedMeshPointer& mesh, const std::string& solver,
                const std::shared_ptr<const Matrix>& matrix, unsigned threads,
                const std::function<void(std::size_t)>& progress,
                const std::function<void(std::size_t row, std::span<const double>)>& put) {
  Background work(matrix->rows.size(), threads, [=]() -> Worker {
    const auto own = std::make_shared<BorrowedSolver>(mesh, solver);
    return [=, all = std::vector<double>(mesh->soup().positions.size())](std::size_t i) mutable {
      own->solve({.sources = {{.at = matrix->rows[i]}}, .limit = matrix->limit}, all);
      put(i, all);
    };
  });
  wait_for(work, progress);
}

/// @return of shape (rows, columns), infinite where no path leads
template <class T>
py::array_t<T> dense(const SharedMeshPointer& mesh, const std::string& solver,
                     const Array<Index>& rows, const Array<Index>& columns, unsigned threads,
                     const std::function<void(std::size_t)>& progress) {
  const auto matrix = std::make_shared<const Matrix>(Matrix{indices_of(rows), indices_of(columns)});
  const std::size_t width = matrix->columns.size();
  const auto values = std::make_shared<std::vector<T>>(matrix->rows.size() * width);
  solve_rows(mesh, solver, matrix, threads, progress, [=](std::size_t row, auto all) {
    T* value = values->data() + row * width;
    for (const Index v : matrix->columns) *value++ = static_cast<T>(all[v]);
  });
  return array_of(std::move(*values), {rows.size(), columns.size()});
}

/// @return of the finite distances: values, their columns by position, and where each row begins
template <class T>
py::tuple sparse(const SharedMeshPointer& mesh, const std::string& solver, const Array<Index>& rows,
                 const Array<Index>& columns, double limit, unsigned threads,
                 const std::function<void(std::size_t)>& progress) {
  struct Row {
    std::vector<T> values;
    std::vector<std::int64_t> columns;
  };
  const auto matrix =
      std::make_shared<const Matrix>(Matrix{indices_of(rows), indices_of(columns), limit});
  const auto found = std::make_shared<std::vector<Row>>(matrix->rows.size());
  solve_rows(mesh, solver, matrix, threads, progress, [=](std::size_t row, auto all) {
    Row& reached = (*found)[row];
    for (std::size_t column = 0; column < matrix->columns.size(); ++column) {
      const double distance = all[matrix->columns[column]];
      if (std::isinf(distance)) continue;
      reached.values.push_back(static_cast<T>(distance));
      reached.columns.push_back(static_cast<std::int64_t>(column));
    }
  });
  std::vector<T> values;
  std::vector<std::int64_t> value_columns, begins{0};
  for (const Row& row : *found) {
    values.insert(values.end(), row.values.begin(), row.values.end());
    value_columns.insert(value_columns.end(), row.columns.begin(), row.columns.end());
    begins.push_back(static_cast<std::int64_t>(values.size()));
  }
  return py::make_tuple(array_of(std::move(values)), array_of(std::move(value_columns)),
                        array_of(std::move(begins)));
}

std::string_view severity_of(const Defect& defect) {
  return type_of(defect.kind).severity == Severity::error ? "error" : "warning";
}

template <class T>
void define_matrices(py::module_& module) {
  const std::string type = sizeof(T) == sizeof(double) ? "float64" : "float32";
  module.def(("dense_" + type).c_str(), &dense<T>);
  module.def(("sparse_" + type).c_str(), &sparse<T>);
}

}  // namespace

PYBIND11_MODULE(_native, module) {
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const MeshError& mesh_error) {
      PyErr_SetString(PyExc_ValueError, harmless(mesh_error.what()).c_str());
    }
  });

  py::class_<SharedMesh, SharedMeshPointer>(module, "SharedMesh")
      .def(py::init(&mesh_from))
      .def_property_readonly("vertices",
                             [](const py::object& self) {
                               return view_of(self.cast<SharedMesh&>().soup().positions, self);
                             })
      .def_property_readonly("faces", [](const py::object& self) {
        return view_of(self.cast<SharedMesh&>().soup().triangles, self);
      });

  py::class_<Defect>(module, "Defect", "A kind of fault that a mesh has.")
      .def_property_readonly("kind", [](const Defect& d) { return type_of(d.kind).key; })
      .def_property_readonly("severity", &severity_of)
      .def_readonly("count", &Defect::count)
      .def_readonly("first", &Defect::example)
      .def("__str__", &Defect::text)
      .def("__repr__", [](const Defect& d) {
        return "<" + std::string(severity_of(d)) + ": " + d.text() + ">";
      });

  py::class_<Description>(module, "Solver", "What a solver is, and whose.")
      .def_readonly("name", &Description::name)
      .def_readonly("family", &Description::family)
      .def_readonly("paper", &Description::paper)
      .def_readonly("data_structure", &Description::data_structure)
      .def_readonly("time_complexity", &Description::time_complexity)
      .def_readonly("space_complexity", &Description::space_complexity)
      .def_readonly("remarks", &Description::remarks)
      .def_property_readonly("exact",
                             [](const Description& d) { return d.exactness == Exactness::exact; })
      .def("__repr__", [](const Description& d) { return "<" + d.name + ": " + d.paper + ">"; });

  module.def("read", &read);
  module.def("defects", &defects);
  module.def("solvers", &registered_solvers, py::return_value_policy::reference);
  module.def("distances", &distances);
  module.def("distances_and_nearest", &distances_and_nearest);
  module.def("path", &path);
  define_matrices<double>(module);
  define_matrices<float>(module);
}

}  // namespace geodesic::python
