// Common code of the adapters of heat methods.
#pragma once

#include <utility>

#include "peer.h"

namespace geodesic::peer {

/// @param known facts about the peer, for the remarks
/// @param parameters all parameters, including `laplacian`
inline Description heat_method(const std::string& name, const std::string& known,
                               std::vector<ParameterDescription> parameters) {
  return {.name = name,
          .family = "heat",
          .paper = "Crane, Weischedel, Wardetzky 2013, Geodesics in heat",
          .exactness = Exactness::unbounded,
          .abilities = {.initial_distances = false},
          .remarks = remarks(known),
          .parameters = std::move(parameters)};
}

inline const char* const kCotangent = "cotangent";
inline const char* const kIntrinsicDelaunay = "intrinsic-delaunay";

/// The parameter that chooses the Laplacian matrix.
/// @param first the peer's own default
inline ParameterDescription laplacian(const std::string& first) {
  const std::string second = first == kCotangent ? kIntrinsicDelaunay : kCotangent;
  return choice_parameter("laplacian", {first, second},
                          "of the triangles, or of their intrinsic Delaunay edges");
}

inline bool is_intrinsic_delaunay(const Description& description) {
  return description.text("laplacian") == kIntrinsicDelaunay;
}

/// The parameter for the time of the heat flow.
inline ParameterDescription heat_time() {
  return real_parameter("time", 1, 1e-6, 1e6,
                        "of the heat flow, by the square of the mean edge length");
}

}  // namespace geodesic::peer
