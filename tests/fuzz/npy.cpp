// Fuzz target: .npy arrays of elevations.
#include "meshes/formats/npy.h"

#include "tests/fuzz/input.h"

void geodesic::harness::fuzz::read_input(std::string_view bytes) {
  parse_npy(bytes, "heights.npy");
}
