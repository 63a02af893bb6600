// Fuzz target: files of sources, targets, sets and pairs, and of numbers of vertices and faces.
#include "harness/corpus/points.h"

#include "harness/base/error.h"
#include "tests/fuzz/input.h"

void geodesic::harness::fuzz::read_input(std::string_view bytes) {
  try {
    parse_points_file(bytes, "--sources-file 'points'");
  } catch (const HarnessError&) {  // may still be numbers or pairs
  }
  try {
    parse_numbers_file(bytes, "--avoid 'points'");
  } catch (const HarnessError&) {
  }
  try {
    parse_sets_file(bytes, "--sets 'points'");
  } catch (const HarnessError&) {
  }
  parse_pairs_file(bytes, "--pairs 'points'");
}
