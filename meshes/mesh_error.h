// What is wrong with a mesh file, in one line: file, place, what, and what to do.
#pragma once

#include "harness/base/error.h"

namespace geodesic::harness {

class MeshError : public HarnessError {
 public:
  using HarnessError::HarnessError;
};

}  // namespace geodesic::harness
