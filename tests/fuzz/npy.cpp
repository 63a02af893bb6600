// Arrays of elevations.
#include "meshes/formats/npy.h"

#include "harness/base/error.h"
#include "meshes/messages.h"
#include "tests/fuzz/input.h"

void geodesic::harness::fuzz::read_input(std::string_view bytes) {
  try {
    parse_npy(bytes, "heights.npy");
  } catch (const MeshError& error) {
    throw HarnessError(error.what());
  }
}
