// Properties of paths, and of sources and targets in faces and on edges.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "harness/corpus/solvers.h"
#include "harness/verify/path_check.h"
#include "harness/verify/properties/properties.h"
#include "meshes/editing/inserted_points.h"
#include "meshes/messages.h"
#include "meshes/random.h"

namespace geodesic::harness {
namespace {

/// At most `most` of the items, evenly spread, including the first and the last.
template <class Each>
std::vector<Each> some_of(const std::vector<Each>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<Each> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * (all.size() - 1) / (most - 1)]);
  return some;
}

std::vector<Index> some_vertices(const Mesh& mesh, std::size_t most) {
  std::vector<Index> vertices(mesh.vertex_count());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  return some_of(vertices, most);
}

double in_space(const Vec3& a, const Vec3& b) { return geodesic::norm(subtract(a, b)); }

/// Tolerance for points that may be close to each other: their positions are rounded.
constexpr Tolerance kNearPoints{.relative = kExactTolerance, .least = 0.01};

/// Random points in faces, beside corners, on edges and at vertices, in turn; none without faces.
std::vector<SurfacePoint> points_by_chance(const Mesh& mesh, std::size_t count) {
  const Index faces = mesh.given_face_count();
  Random random(split_mix(faces));
  std::vector<SurfacePoint> points;
  while (points.size() < count && faces > 0) {
    const Index face = random.below(faces);
    std::array<double, 3> weights;
    for (double& w : weights) w = random.between(0, 1);
    if (points.size() % 4 == 1) weights = {1, 0, 1e-9 * weights[2]};
    if (points.size() % 4 == 2) weights[random.below(3)] = 0;
    if (points.size() % 4 == 3) weights = {1, 0, 0};
    points.push_back(point_in_face(mesh, face, weights));
  }
  return points;
}

void check_end(const Trial& trial, const Query& query, const SurfacePoint& end, double distance,
               const Path& path, const Tolerance& tolerance) {
  if (trial.solver().exactness != Exactness::exact) {
    const double length = path.length() + query.sources.at(path.source).distance;
    require(relative_error(length, distance, tolerance.least) <= tolerance.relative,
            "a path of length " + significant(length) + " leads to a distance of " +
                significant(distance));
    return require(check_path(trial.mesh(), query, end, length, path, tolerance));
  }
  require(check_path(trial.mesh(), query, end, distance, path, tolerance));
  // On several sheets, a path that lies in its faces and has the right length must be straight.
  if (trial.mesh().crosses_non_manifold_edges()) return;
  require(check_straight(trial.mesh(), path, tolerance));
}

/// Checks the paths to all targets and to up to 200 vertices.
void check_all(const Trial& trial, const Query& query, const Paths& paths,
               const Tolerance& tolerance) {
  for (std::size_t i = 0; i < query.targets.size(); ++i) {
    const std::string target = "to target " + std::to_string(i);
    if (paths.distance_to_target(i) == kInfinity) {
      refused(target + ", where no path leads, a path", [&] { paths.to_target(i); });
      continue;
    }
    check_end(trial, query, query.targets[i], paths.distance_to_target(i), paths.to_target(i),
              tolerance);
  }
  for (const Index v : some_vertices(trial.mesh(), 200)) {
    const double distance = paths.distances()[v];
    if (distance == kInfinity) {
      refused("to vertex " + std::to_string(v) + ", where no path leads, a path",
              [&] { paths.to_vertex(v); });
      continue;
    }
    check_end(trial, query, SurfacePoint(v), distance, paths.to_vertex(v), tolerance);
  }
}

/// Tolerance for distances and paths between points in faces or on edges: rounding moves both ends.
Tolerance between_points(const Trial& trial, double place) {
  Tolerance tolerance = trial.tolerance();
  tolerance.least = std::max(tolerance.least, 2 * place / tolerance.relative);
  return tolerance;
}
Tolerance between_points(const Trial& trial) {
  return between_points(trial, InsertedPoints(trial.mesh(), {}).place());
}

constexpr std::size_t kQueries = 4;  // largest number per case in checks of paths

void paths_are_shortest(const Trial& trial) {
  const auto solver = trial.prepare();
  const Tolerance tolerance = between_points(trial);
  for (Query query : some_of(trial.queries(), kQueries)) {
    query.targets = points_by_chance(trial.mesh(), 12);
    check_all(trial, query, solve_paths(*solver, trial.mesh(), query), tolerance);
  }
}

void paths_begin_anywhere(const Trial& trial) {
  const auto solver = trial.prepare();
  const std::vector<SurfacePoint> points = points_by_chance(trial.mesh(), 4);
  const Tolerance tolerance = between_points(trial);
  for (const SurfacePoint& from : points) {
    const Query query{.sources = {{from, 0.25}}, .targets = points};
    const Paths paths = solve_paths(*solver, trial.mesh(), query);
    check_all(trial, query, paths, tolerance);
    if (trial.solver().exactness != Exactness::exact) continue;
    const Paths anywhere =
        solve_paths(*solver, trial.mesh(), {.sources = query.sources}, /*keeps_windows=*/true);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double target = paths.distance_to_target(i), later = anywhere.distance_at(points[i]);
      const double error = relative_error(later, target, tolerance.least);
      require(std::abs(error) <= tolerance.relative,
              "point " + std::to_string(i) + " is " + significant(later) +
                  " away after a solve, and " + significant(target) + " as its target");
    }
  }
}

void paths_lead_there_and_back(const Trial& trial) {
  const auto solver = trial.prepare();
  const std::vector<SurfacePoint> points = points_by_chance(trial.mesh(), 8);
  std::vector<std::vector<double>> lengths;
  for (const SurfacePoint& from : points) {
    const Paths paths =
        solve_paths(*solver, trial.mesh(), {.sources = {{from, 0}}, .targets = points});
    lengths.emplace_back();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool leads = paths.distance_to_target(i) < kInfinity;
      lengths.back().push_back(leads ? paths.to_target(i).length() : kInfinity);
    }
  }
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const double error = relative_error(lengths[a][b], lengths[b][a], trial.tolerance().least);
      require(std::abs(error) <= trial.tolerance().relative,
              "from point " + std::to_string(a) + " to " + std::to_string(b) + " it is " +
                  significant(lengths[a][b]) + ", and back " + significant(lengths[b][a]));
    }
  }
}

void traced_paths_keep_the_promise(const Trial& trial) {
  const auto solver = trial.prepare();
  for (const Query& query : some_of(trial.queries(), kQueries)) {
    const std::vector<double> distances = trial.solve(*solver, query);
    std::vector<double> lengths(distances.size(), kInfinity);
    for (Index v = 0; v < distances.size(); ++v) {
      if (distances[v] == kInfinity) continue;
      const Path path = solver->trace(query, distances, v);
      lengths[v] = path.length() + query.sources.at(path.source).distance;
      require(check_path(trial.mesh(), query, v, lengths[v], path, trial.tolerance()));
    }
    require(trial.correct(query, lengths, trial.expected(query)));
  }
}

void recording_paths_changes_nothing(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  const Paths paths = solve_paths(*solver, trial.mesh(), query);
  require("with paths, beside a timed solve",
          same_bits(query, paths.distances(), trial.solve(*solver, query)));
}

void nearest_sources_are_nearest(const Trial& trial) {
  const Query& query = trial.query();
  const auto solver = trial.prepare();
  const Paths paths = solve_paths(*solver, trial.mesh(), query);
  std::vector<std::vector<double>> from_each;
  for (const Source& source : query.sources) {
    from_each.push_back(trial.solve(*solver, Query{.sources = {source}}));
  }
  const std::vector<Index> nearest = paths.nearest_sources();
  std::vector<double> distances;
  for (Index v = 0; v < nearest.size(); ++v) {
    require(nearest[v] == paths.nearest_source(v), "a vertex has two nearest sources");
    distances.push_back(nearest[v] == kNone ? kInfinity : from_each[nearest[v]][v]);
  }
  require("from the nearest source alone",
          check_distances(query, distances, paths.distances(), Relation::equal, trial.tolerance()));
}

/// The mesh with points inserted, and the right distances on it.
class WithPoints {
 public:
  WithPoints(const Trial& trial, const std::vector<SurfacePoint>& points)
      : inserted_(trial.mesh(), points),
        tolerance_(between_points(trial, inserted_.place())),
        reference_(trial.solver(), inserted_.mesh(), tolerance_) {}

  std::vector<double> distances(std::vector<Source> sources) {
    for (Source& source : sources) source.at = SurfacePoint(inserted_.vertex(source.at));
    return reference_.distances({.sources = std::move(sources)}).values;
  }
  Index vertex(const SurfacePoint& point) const { return inserted_.vertex(point); }
  const Tolerance& tolerance() const { return tolerance_; }

 private:
  InsertedPoints inserted_;
  Tolerance tolerance_;
  LocalReference reference_;
};

/// Requires right distances of points. The violation has no query: queries of a case have vertices.
void require_promise(const std::string& circumstances, const Trial& trial, const Query& query,
                     std::span<const double> got, std::span<const double> expected,
                     const Tolerance& tolerance) {
  Finding finding = trial.correct(query, got, expected, tolerance);
  if (finding) finding = Violation{.what = finding->what};
  require(circumstances, std::move(finding));
}

constexpr std::size_t kInserted = 8;  // points; both properties use the same finer mesh

/// Checks queries from each point alone, and from all points if the solver takes several sources.
void sources_are_as_if_inserted(const Trial& trial) {
  const std::vector<SurfacePoint> points = points_by_chance(trial.mesh(), kInserted);
  if (points.empty()) return;
  WithPoints finer(trial, points);
  const auto solver = trial.prepare();
  std::vector<Query> queries;
  for (const SurfacePoint& point : points) queries.push_back({.sources = {{point, 0}}});
  if (trial.solver().abilities.multiple_sources) {
    queries.emplace_back();
    for (const SurfacePoint& point : points) queries.back().sources.push_back({point, 0});
  }
  for (const Query& query : queries) {
    std::vector<double> expected = finer.distances(query.sources);
    expected.resize(trial.mesh().vertex_count());
    require_promise("with the points inserted", trial, query, trial.solve(*solver, query), expected,
                    finer.tolerance());
  }
}

void targets_are_as_if_inserted(const Trial& trial) {
  const std::vector<SurfacePoint> points = points_by_chance(trial.mesh(), kInserted);
  if (points.empty()) return;
  WithPoints finer(trial, points);
  const auto solver = trial.prepare();
  Query query = trial.query();
  query.limit = kInfinity;
  query.targets = points;
  const Paths paths = solve_paths(*solver, trial.mesh(), query);
  const std::vector<double> distances = finer.distances(query.sources);
  std::vector<double> got, expected;
  for (std::size_t i = 0; i < points.size(); ++i) {
    got.push_back(paths.distance_to_target(i));
    expected.push_back(distances[finer.vertex(points[i])]);
  }
  require_promise("with the points inserted", trial, query, got, expected, finer.tolerance());
}

/// Compares with the reference among the solvers that start at such points, so none are inserted.
/// The distance to a target must equal the reference's distance from the target.
void rivals_agree_between_points(const Trial& trial) {
  const Mesh& mesh = trial.mesh();
  std::vector<std::string> rivals;
  for (const Description* other : rank_references(trial.solver(), registered_solvers(), {})) {
    const bool starts_anywhere = other->abilities.surface_sources;
    if (starts_anywhere && unsupported(*other, mesh).empty()) rivals.push_back(other->name);
  }
  const auto solver = trial.prepare();
  // The positions of points depend on the rounding of corners, which matters at short distances.
  Tolerance tolerance = trial.tolerance();
  tolerance.least = std::max(tolerance.least, mesh.mean_edge_length() / 256);
  const std::vector<SurfacePoint> points = points_by_chance(mesh, 3);  // in faces and on an edge
  std::vector<std::vector<double>> expected;
  for (const SurfacePoint& point : points) {
    const Query query{.sources = {{point, 0}}};
    const auto ask = [&](const std::string& rival) { return solve_once(rival, mesh, query); };
    const ReferenceDistances right = choose_reference(rivals, ask, tolerance);
    expected.push_back(right.values);
    require_promise("beside " + right.by, trial, query, trial.solve(*solver, query), right.values,
                    tolerance);
  }
  for (const Index v : some_vertices(mesh, 4)) {
    const Query query{.sources = {{v, 0}}, .targets = points};
    const Paths paths = solve_paths(*solver, mesh, query);
    std::vector<double> got, back;
    for (std::size_t i = 0; i < points.size(); ++i) {
      got.push_back(paths.distance_to_target(i));
      back.push_back(expected[i][v]);
    }
    require_promise("beside the reference, at targets", trial, query, got, back, tolerance);
  }
}

void points_of_a_plane_are_euclids(const Trial& trial) {
  const auto solver = trial.prepare();
  const std::vector<SurfacePoint> points = points_by_chance(trial.mesh(), 40);
  for (const SurfacePoint& from : some_of(points, 6)) {
    const Query query{.sources = {{from, 0}}, .targets = points};
    const Paths paths = solve_paths(*solver, trial.mesh(), query);
    std::vector<double> got, expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      got.push_back(paths.distance_to_target(i));
      expected.push_back(
          in_space(position_of(trial.mesh(), points[i]), position_of(trial.mesh(), from)));
    }
    require_promise("as the crow flies", trial, query, got, expected, kNearPoints);
  }
}

/// Lines from several sources meet all over a plane, and no vertex separates them.
void nearest_points_of_a_plane_are_euclids(const Trial& trial) {
  const Mesh& mesh = trial.mesh();
  const auto solver = trial.prepare();
  const std::vector<SurfacePoint> points = points_by_chance(mesh, 48);
  for (std::size_t i = 0; i + 3 <= points.size(); i += 3) {
    Query query;
    for (std::size_t k = i; k < i + 3; ++k) query.sources.push_back({points[k], 0});
    std::vector<double> expected;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      double nearest = kInfinity;
      for (const Source& source : query.sources) {
        nearest = std::min(nearest, in_space(mesh.position(v), position_of(mesh, source.at)));
      }
      expected.push_back(nearest);
    }
    require_promise("as the crow flies", trial, query, trial.solve(*solver, query), expected,
                    kNearPoints);
  }
}

/// Three quadrangles around a reflex corner, vertex 4, rotated. Vertex 7 is at the end of one wall
/// of the corner. Seen from that wall, vertices 1, 2 and 5 lie behind the corner.
TriangleSoup reflex_corner() {
  TriangleSoup soup;
  for (const auto& [x, y] :
       {std::pair{0., 0.}, {1., 0.}, {2., 0.}, {0., 1.}, {1., 1.}, {2., 1.}, {0., 2.}, {1.3, 2.}}) {
    soup.positions.push_back({0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, 0});
  }
  soup.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}};
  return soup;
}

/// The straight line from the point to a vertex behind the corner misses the corner by less than
/// the distance between point and corner, and is shorter than the right path by about as much.
void distances_lead_around_a_near_corner(const Trial& trial) {
  const Mesh& mesh = trial.mesh();
  const auto solver = trial.prepare();
  for (const double share : {1e-3, 1e-5, 1e-7, 1e-9, 2e-10, 7e-11, 1e-11, 1e-13}) {
    const SurfacePoint from = point_on_edge(mesh, 4, 7, share);
    const double to_corner = share * in_space(mesh.position(7), mesh.position(4));
    std::vector<double> expected;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const bool behind = v == 1 || v == 2 || v == 5;
      expected.push_back(behind ? to_corner + in_space(mesh.position(v), mesh.position(4))
                                : in_space(mesh.position(v), position_of(mesh, from)));
    }
    const Query query{.sources = {{from, 0}}};
    require_promise(significant(share, 2) + " from the corner", trial, query,
                    trial.solve(*solver, query), expected, kNearPoints);
  }
}

Cases of_all(const std::vector<Property>& properties) {
  Cases cases;
  for (const Property& property : properties) {
    for (Case& each : property.cases()) {
      if (each.soup.triangles.size() > 5000) continue;
      each.mesh = property.name + ": " + each.mesh;
      each.queries = some_of(each.queries, kQueries);
      cases.push_back(std::move(each));
    }
  }
  return cases;
}

Cases larger_meshes() {
  return {{"terrain", rough_terrain(31, 16, 16, 1), {from(0)}},
          {"sphere", rough_sphere(32, 3, 0.1), {from(0)}}};
}

// Windows wind around such a tube a million times before a path through a vertex is shorter.
Cases tubes_of_needles() {
  const TriangleSoup tube =
      generate("cylinder", {{"sides", 3}, {"rows", 2}, {"height", 1e6}, {"diagonal", "forward"}});
  return {{"tube", tube, {from(0)}}};
}

Cases planes() {
  Cases cases;
  for (const char* diagonal : {"alternating", "forward"}) {
    const TriangleSoup grid =
        generate("grid", {{"columns", 9}, {"rows", 7}, {"diagonal", diagonal}});
    cases.push_back(plane_case(diagonal, grid, {from(0)}, grid));
  }
  return cases;
}

}  // namespace

std::vector<Property> path_properties() {
  constexpr unsigned kAnyEnds = kPaths | kSurfaceSources;
  return {
      {"paths-are-as-long-as-distances-straight-and-bend-where-they-may",
       "on rough meshes every path is as long as its end is far, straight, and bends only where "
       "that saves nothing",
       random_meshes_from_some_sources, paths_are_shortest, kPaths},
      {"paths-begin-in-faces-and-on-edges-too",
       "between points in faces, on edges and at vertices paths are as long as distances",
       random_meshes_from_some_sources, paths_begin_anywhere, kAnyEnds | kInitialDistances},
      {"paths-on-surfaces-with-a-closed-form-are-as-long-as-distances",
       "on planes, boxes, cones, saddles and cylinders, where lines run through vertices, paths "
       "are as long as distances, and straight",
       [] { return of_all(closed_form_properties()); }, paths_are_shortest, kPaths},
      {"paths-on-unclean-meshes-are-as-long-as-distances",
       "along borders, non-manifold vertices and edges, and faces without area paths are as long "
       "as distances",
       [] { return of_all(unclean_mesh_properties()); }, paths_are_shortest, kPaths},
      {"paths-on-extreme-meshes-are-as-long-as-distances",
       "over needles, valences, ties and far units paths are as long as distances",
       [] { return of_all(extreme_mesh_properties()); }, paths_are_shortest, kPaths},
      {"paths-over-several-sheets-are-as-long-as-distances",
       "where paths cross edges of several faces they lead through the faces they name, and are as "
       "long as distances",
       surfaces_of_several_sheets, paths_begin_anywhere,
       kAnyEnds | kInitialDistances | kNonManifoldEdges},
      {"points-of-several-sheets-equal-inserted-vertices",
       "from points in faces and on edges of several faces distances are those of the mesh with "
       "them as vertices",
       surfaces_of_several_sheets, sources_are_as_if_inserted, kSurfaceSources | kNonManifoldEdges},
      {"paths-lead-there-and-back", "the path from a to b is as long as that from b to a",
       random_meshes_from_some_sources, paths_lead_there_and_back, kAnyEnds | kExactDistances},
      {"paths-traced-lead-over-the-surface-and-are-as-long-as-promised",
       "paths that a solver traces itself lead from a source over the faces, and their lengths are "
       "what it promises of distances",
       random_meshes_from_some_sources, traced_paths_keep_the_promise, kTraces},
      {"paths-traced-on-unclean-meshes-are-as-long-as-promised",
       "the same along borders, non-manifold vertices and edges, and faces without area",
       [] { return of_all(unclean_mesh_properties()); }, traced_paths_keep_the_promise, kTraces},
      {"paths-recorded-change-no-distance", "a solve that records paths gives a timed one's bits",
       random_meshes_from_some_sources, recording_paths_changes_nothing, kPaths | kSameBits},
      {"nearest-sources-are-those-that-paths-come-from",
       "the source that a vertex's path comes from is one that no other is nearer than",
       random_meshes_from_four_sources, nearest_sources_are_nearest,
       kPaths | kMultipleSources | kExactDistances},
      {"sources-in-faces-and-on-edges-equal-inserted-vertices",
       "from a point in a face or on an edge distances are those of the mesh with it as a vertex",
       random_meshes_from_some_sources, sources_are_as_if_inserted, kSurfaceSources},
      {"sources-in-faces-of-a-tube-of-needles-equal-inserted-vertices",
       "in a tube a million times longer than wide windows do not wind without end",
       tubes_of_needles, sources_are_as_if_inserted, kSurfaceSources | kOwnKernel},
      {"targets-in-faces-and-on-edges-equal-inserted-vertices",
       "the distance of a point in a face or on an edge is that of the vertex it becomes",
       random_meshes_from_some_sources, targets_are_as_if_inserted, kPaths},
      {"rivals-agree-between-points-in-faces-and-on-edges",
       "from and to points in faces and on edges distances on larger meshes equal those of another "
       "exact solver that starts there",
       larger_meshes, rivals_agree_between_points, kAnyEnds | kExactDistances},
      {"points-of-a-plane-are-as-far-apart-as-in-space",
       "between points of a plane, wherever they lie, distances are Euclid's", planes,
       points_of_a_plane_are_euclids, kAnyEnds, /*on_any_mesh=*/false},
      {"several-points-of-a-plane-are-as-far-as-the-nearest",
       "from several points of a plane, wherever they lie, distances are Euclid's to the nearest",
       planes, nearest_points_of_a_plane_are_euclids, kSurfaceSources | kMultipleSources,
       /*on_any_mesh=*/false},
      {"distances-beside-a-corner-of-a-boundary-lead-around-it",
       "from a point close to a reflex corner distances are those of paths around the corner",
       [] {
         return Cases{{"reflex corner", reflex_corner(), {from(4)}}};
       },
       distances_lead_around_a_near_corner, kSurfaceSources, /*on_any_mesh=*/false},
  };
}

}  // namespace geodesic::harness
