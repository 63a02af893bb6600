// PLY files.
#include "tests/fuzz/input.h"
#include "tests/fuzz/mesh_file.h"

void geodesic::harness::fuzz::read_input(std::string_view bytes) {
  read_mesh_file(bytes, "input.ply");
}
