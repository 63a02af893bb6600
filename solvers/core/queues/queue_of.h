// The queue that a policy makes, with or without parameters of its solver.
#pragma once

#include "solvers/core/mesh.h"

namespace geodesic {

struct Description;  // solvers/core/solver.h

/// The empty queue of a policy: make_queue(mesh, description) of a policy whose queue depends on
/// parameters (`description.real("width")`), otherwise make_queue(mesh).
template <class Policy>
typename Policy::Queue queue_of(const Mesh& mesh, const Description& description) {
  if constexpr (requires { Policy::make_queue(mesh, description); }) {
    return Policy::make_queue(mesh, description);
  } else {
    return Policy::make_queue(mesh);
  }
}

}  // namespace geodesic
