// What a user did wrong or must do, in one line; main prints it and exits with 1.
#pragma once

#include <stdexcept>

#include "meshes/messages.h"

namespace geodesic::harness {

class HarnessError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A result could not be written: the disk is full, or the folder is gone.
class CannotWrite : public HarnessError {
 public:
  using HarnessError::HarnessError;
};

/// Distances that cannot be right; main exits with 2.
class WrongAnswer : public HarnessError {
 public:
  using HarnessError::HarnessError;
};

}  // namespace geodesic::harness
