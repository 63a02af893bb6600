// Fuzz target: files of sources and targets.
#include "harness/corpus/points.h"

#include "tests/fuzz/input.h"

void geodesic::harness::fuzz::read_input(std::string_view bytes) {
  parse_points_file(bytes, "--sources-file 'points'");
}
