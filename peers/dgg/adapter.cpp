// The authors' discrete geodesic graph (FastDGG) and saddle vertex graph, with their search.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "peer.h"

// The authors' code expects these without a namespace.
using std::cerr;
using std::max;

#include <ICH/RichModel.h>
#include <dgg_dijkstra.h>

// Of dgg_precompute.cpp, which has no header with it: finds the links of one vertex.
// @param method 0: discrete geodesic graph, 1: saddle vertex graph
void getDisAndAngles(const CRichModel& model, int source, double eps_vg, std::vector<int>& dests,
                     std::vector<double>& angles, std::vector<double>& dis, int method,
                     int fixed_K);

namespace geodesic {
namespace {

class AuthorsModel final : public CRichModel {
 public:
  explicit AuthorsModel(const Mesh& mesh) : CBaseModel(""), CRichModel("") {
    for (const Vec3& p : mesh.positions()) m_Verts.emplace_back(p[0], p[1], p[2]);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto [a, b, c] = mesh.triangle(f);
      m_Faces.emplace_back(a, b, c);
    }
    AdjustScaleAndComputeNormalsToVerts();
    m_fBeLoaded = true;
    Preprocess();
  }
};

// The authors' programs write the graph to a file and read it. This keeps it in memory.
class AuthorsGraph : public Solver {
 public:
  AuthorsGraph(const Mesh& mesh, const Description& description, int method, double eps, int k)
      : Solver(mesh, description) {
    const AuthorsModel model(mesh);
    graph_.initialize(model.GetNumOfVerts());
    for (int source = 0; source < model.GetNumOfVerts(); ++source) {
      std::vector<int> ends;
      std::vector<double> angles, lengths;
      getDisAndAngles(model, source, eps, ends, angles, lengths, method, k);
      graph_.allocate_for_neighbor_small(source, static_cast<int>(ends.size()));
      for (std::size_t i = 0; i < ends.size(); ++i)
        graph_.addedge(source, ends[i], static_cast<float>(lengths[i]));
    }
  }

 private:
  void run(const Start& start, std::span<double> distances) override {
    std::vector<int> sources;
    for (const StartVertex& each : start.vertices) sources.push_back(static_cast<int>(each.vertex));
    graph_.findShortestDistance(sources);
    const std::vector<float>& found = *graph_.distanceField();
    peer::answer(distances, std::numeric_limits<float>::max(), [&](Index v) { return found[v]; });
  }

  ::Dijkstra<float> graph_;  // in single precision, as in their program
};

class Dgg final : public AuthorsGraph {
 public:
  Dgg(const Mesh& mesh, const Description& description)
      : AuthorsGraph(mesh, description, 0, description.real("eps"), 0) {}
};

class Svg final : public AuthorsGraph {
 public:
  Svg(const Mesh& mesh, const Description& description)
      : AuthorsGraph(mesh, description, 1, 0, static_cast<int>(description.integer("k"))) {}
};

Description described(const std::string& name, const std::string& paper, const std::string& aim,
                      ParameterDescription parameter) {
  return {.name = name,
          .family = "Dijkstra",
          .paper = paper,
          .exactness = Exactness::unbounded,
          .abilities = {.initial_distances = false},
          .remarks = peer::remarks("the authors' code, " + aim +
                                   "; it searches in single "
                                   "precision, and its preparation is on one thread"),
          .parameters = {std::move(parameter)}};
}

const RegisterSolver<Dgg> registered_dgg{
    described("dgg", "Adikusuma, Fang, He 2020, Fast construction of discrete geodesic graphs",
              "which aims at a relative error of eps and states no bound",
              real_parameter("eps", 0.01, 1e-9, 1, "the relative error to aim at"))};

const RegisterSolver<Svg> registered_svg{
    described("svg",
              "Ying, Wang, He 2013, Saddle Vertex Graph (SVG): A Novel Solution to the Discrete "
              "Geodesic Problem",
              "which states no bound",
              integer_parameter("k", 50, 1, 1000000,
                                "vertices nearest to each that are searched for links"))};

}  // namespace
}  // namespace geodesic
