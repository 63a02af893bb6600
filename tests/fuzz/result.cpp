// Result files, and their exports.
#include "harness/exports/exports.h"
#include "tests/fuzz/input.h"

namespace geodesic::harness {

void fuzz::read_input(std::string_view bytes) {
  const ResultFile result = parse_result_file(parse_json(bytes, "run.json"), "run.json");
  for (const std::string& format : export_formats()) export_as(format, result);
}

}  // namespace geodesic::harness
