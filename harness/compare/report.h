// A comparison as people and programs read it.
#pragma once

#include <string>

#include "harness/compare/compare.h"

namespace geodesic::harness {

enum class ReportFormat { text, markdown, json };

/// @throws HarnessError for an unknown name, listing the known ones
ReportFormat report_format_named(const std::string& name);

/// The verdict first, then overall means, then a row a cell. A difference in time that is not
/// resolved is "~".
/// @param failures what --fail-on found
std::string report(const Comparison& comparison, const std::vector<std::string>& failures,
                   ReportFormat format);

}  // namespace geodesic::harness
