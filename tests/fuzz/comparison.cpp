// Two result files that are compared: a NUL, which no JSON holds, parts them. One alone is compared
// with itself.
#include "harness/compare/limits.h"
#include "harness/compare/report.h"
#include "tests/fuzz/input.h"

namespace geodesic::harness {

void fuzz::read_input(std::string_view bytes) {
  const std::size_t part = bytes.find('\0');
  const std::string_view second = part == bytes.npos ? bytes : bytes.substr(part + 1);
  const Comparison comparison =
      compare(parse_result_file(parse_json(bytes.substr(0, part), "old.json"), "old.json"),
              parse_result_file(parse_json(second, "new.json"), "new.json"));
  const Limits limits = parse_limits({"time=10%", "counters=1%", "memory=2%"});
  for (const ReportFormat format : {ReportFormat::text, ReportFormat::markdown, ReportFormat::json})
    report(comparison, exceeded(comparison, limits), format);
}

}  // namespace geodesic::harness
