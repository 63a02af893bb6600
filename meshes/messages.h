// The error of a mesh, and what messages are made of.
#pragma once

#include <stdexcept>

#include "solvers/core/messages.h"

namespace geodesic {

/// What is wrong with a mesh or its file, in one line: file, place, what, and what to do.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace geodesic
