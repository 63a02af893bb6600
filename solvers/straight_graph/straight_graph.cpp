// `straight-graph` and `saddle-vertex-graph`: graphs of straight links, prepared once, for many
// sources on one mesh.
#include <cmath>
#include <random>

#include "solvers/core/registry.h"
#include "solvers/straight_graph/builder.h"
#include "solvers/straight_graph/discs.h"
#include "solvers/straight_graph/fan.h"
#include "solvers/straight_graph/last_links.h"
#include "solvers/straight_graph/search.h"

namespace geodesic::straight_graph {
namespace {

/// Compares distances from random vertices with exact ones.
/// @param sources at least 1; vertices may be drawn more than once
Certificate compare_with_exact(Solver& solver, Index sources) {
  const Mesh& mesh = solver.mesh();
  Certificate found;
  if (mesh.vertex_count() == 0) return found;
  const std::unique_ptr<Solver> exact = make_solver("edge-based", mesh);
  std::mt19937_64 random(1);  // the same sources each time
  std::vector<double> distances(mesh.vertex_count()), expected(mesh.vertex_count());
  double sum = 0;
  std::uint64_t count = 0;
  for (; found.sources < sources; ++found.sources) {
    const Query query{.sources = {{.at = static_cast<Index>(random() % mesh.vertex_count())}}};
    solver.solve(query, distances);
    exact->solve(query, expected);
    for (std::size_t v = 0; v < distances.size(); ++v) {
      if (!(expected[v] > 0) || std::isinf(expected[v])) continue;
      const double error = distances[v] / expected[v] - 1;
      found.largest_error = std::max(found.largest_error, error);
      sum += error;
      ++count;
    }
  }
  if (count > 0) found.mean_error = sum / static_cast<double>(count);
  return found;
}

/// Links chosen by the angle between them.
struct ByAngle {
  static Graph build(const Mesh& mesh, const Description& description, unsigned threads) {
    return build_graph(mesh, description.real("alpha"), threads);
  }
  static double angle(const Description& description) { return description.real("alpha"); }
  static FollowLinks follow_links(const Mesh& mesh, const Description& description) {
    return follow_links_by_angle(mesh, angle(description));
  }
};

/// All links of a disc, which need no finer fan at sources.
struct ByDisc {
  static Graph build(const Mesh& mesh, const Description& description, unsigned threads) {
    return build_disc_graph(mesh, description.integer("disc"), threads);
  }
  static double angle(const Description& /*description*/) { return kFanAngle; }
  static FollowLinks follow_links(const Mesh& mesh, const Description& description) {
    return follow_links_of_disc(mesh, description.integer("disc"));
  }
};

/// @tparam Links which links a vertex has: the graph, and the angle between its links
template <class Links>
class StraightGraph final : public Solver {
 public:
  StraightGraph(const Mesh& mesh, const Description& description)
      : StraightGraph(
            mesh, description,
            std::make_shared<const Graph>(Links::build(
                mesh, description, static_cast<unsigned>(description.integer("threads"))))) {
    const Index sources = description.integer("check");
    if (sources > 0) certificate_ = compare_with_exact(*this, sources);
  }
  StraightGraph(const Mesh& mesh, const Description& description, PreparedReader& from)
      : StraightGraph(mesh, description, std::make_shared<const Graph>(mesh.vertex_count(), from)) {
    const std::vector<double> found = from.read<double>();
    if (found.size() == 3) certificate_ = {static_cast<Index>(found[0]), found[1], found[2]};
  }

  std::unique_ptr<Solver> another() const override {
    std::unique_ptr<StraightGraph> other(new StraightGraph(mesh(), description(), graph_));
    other->certificate_ = certificate_;
    return other;
  }
  void save(PreparedWriter& to) const override {
    graph_->save(to);
    std::vector<double> found;
    if (certificate_) {
      found = {static_cast<double>(certificate_->sources), certificate_->mean_error,
               certificate_->largest_error};
    }
    to.write(std::span<const double>(found));
  }
  std::optional<Certificate> certificate() const override { return certificate_; }

 private:
  StraightGraph(const Mesh& mesh, const Description& description,
                std::shared_ptr<const Graph> graph)
      : Solver(mesh, description),
        graph_(std::move(graph)),
        search_(mesh, *graph_, Links::angle(description)) {}

  void run(const Start& start, std::span<double> distances) override {
    search_.run(start.query, distances);
  }

  void record(const Start& start, std::span<double> distances, Recording& recording) override {
    if (recording.kind != RecordingKind::paths) return run(start, distances);
    std::vector<Index> roots(distances.size(), kNone);
    search_.run(start.query, distances, roots);
    record_last_links(mesh(), start.query, Links::angle(description()), distances, roots,
                      Links::follow_links(mesh(), description()), recording);
  }

  std::shared_ptr<const Graph> graph_;
  Search search_;
  std::optional<Certificate> certificate_;
};

constexpr const char* kFamily = "straight graph";
constexpr const char* kPaper =
    "Ying, Wang, He 2013, Saddle Vertex Graph (SVG): A Novel Solution to the Discrete Geodesic "
    "Problem";
constexpr Abilities kAbilities{.surface_sources = true, .paths = true};

/// @param links which links a graph has
std::vector<ParameterDescription> parameters(const ParameterDescription& links) {
  return {links, integer_parameter("threads", 1, 1, 256, "that prepare the graph"),
          integer_parameter("check", 0, 0, 1000,
                            "random sources from which preparation measures its errors")};
}

const RegisterSolver<StraightGraph<ByAngle>> straight_graph{{
    .name = "straight-graph",
    .family = kFamily,
    .paper = kPaper,
    .exactness = Exactness::upper_bound,
    .by_name_only = true,
    .abilities = kAbilities,
    .remarks = "prepares links once, for many sources",
    .parameters =
        parameters(real_parameter("alpha", 0.2, 0.02, 1, "least angle between links, in radians")),
}};
const RegisterSolver<StraightGraph<ByDisc>> saddle_vertex_graph{{
    .name = "saddle-vertex-graph",
    .family = kFamily,
    .paper = kPaper,
    .exactness = Exactness::upper_bound,
    .by_name_only = true,
    .abilities = kAbilities,
    .remarks = "prepares all links of discs once, for many sources",
    .parameters =
        parameters(integer_parameter("disc", 100, 1, 10000, "nearest vertices that links lead to")),
}};

}  // namespace
}  // namespace geodesic::straight_graph
