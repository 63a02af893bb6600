// The exception for errors of meshes, and functions for messages.
#pragma once

#include <stdexcept>

#include "solvers/core/messages.h"

namespace geodesic {

/// An error of a mesh or its file, in one line: the file, the position, the error and its remedy.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace geodesic
