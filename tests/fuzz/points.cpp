// Fuzz target: files of sources, targets and pairs.
#include "harness/corpus/points.h"

#include "harness/base/error.h"
#include "tests/fuzz/input.h"

void geodesic::harness::fuzz::read_input(std::string_view bytes) {
  try {
    parse_points_file(bytes, "--sources-file 'points'");
  } catch (const HarnessError&) {  // may still be pairs
  }
  parse_pairs_file(bytes, "--pairs 'points'");
}
