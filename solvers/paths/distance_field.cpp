#include "solvers/paths/distance_field.h"

#include <utility>

namespace geodesic {

DistanceField::DistanceField(const Mesh& mesh, const Query& query, std::vector<double> distances,
                             bool are_shortest, double farthest)
    : mesh_(mesh),
      query_(in_internal_numbers(mesh, query)),
      distances_(std::move(distances)),
      are_shortest_(are_shortest),
      farthest_(farthest),
      source_images_(query_.sources.size()) {
  for (Index i = 0; i < query_.sources.size(); ++i) {
    const InternalSource& source = query_.sources[i];
    if (!source.at.is_vertex()) {
      source_images_[i] = in_every_face(mesh, source.at);
      continue;
    }
    const auto [at, first] = source_at_.try_emplace(source.at.vertex, i);
    if (!first && source.distance < query_.sources[at->second].distance) at->second = i;
  }
}

}  // namespace geodesic
