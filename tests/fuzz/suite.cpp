// Fuzz target: suites.
#include "harness/corpus/suite.h"

#include "tests/fuzz/input.h"

void geodesic::harness::fuzz::read_input(std::string_view bytes) {
  parse_suite(parse_json(bytes, "suite.json"), "suite.json");
}
