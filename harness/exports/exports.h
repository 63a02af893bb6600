// Result files as other people's tools read them.
#pragma once

#include <string>
#include <vector>

#include "harness/results/read.h"

namespace geodesic::harness {

/// Names of the formats that `export_as` knows.
const std::vector<std::string>& export_formats();

/// @throws HarnessError for an unknown format, listing the known ones
void check_export_format(const std::string& format);

/// One of:
/// - "github-action-benchmark": an array of {name, unit, value, range}, for that tool's
///   `customSmallerIsBetter`: time, counters and memory of each cell;
/// - "bencher": {"cell": {"latency": {"value", "lower_value", "upper_value"}, ...}}, latency in ns;
/// - "gbench-median": Google Benchmark's JSON with one row a cell, the repetition of median CPU
///   time: for tools that plot every row they find;
/// - "csv": one line a repetition, failed cells with their outcome.
/// Cells that failed have no numbers: the first two formats, which cannot say so, leave them out.
/// @throws HarnessError for an unknown format, listing the known ones
std::string export_as(const std::string& format, const ResultFile& result);

}  // namespace geodesic::harness
