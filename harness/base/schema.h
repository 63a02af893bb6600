// JSON Schema, draft 2020-12, as far as datasets/manifest.schema.json, harness/suite.schema.json
// and descriptions of external solvers use it.
#pragma once

#include "harness/base/json.h"

namespace geodesic::harness {

/// Checks a value that may be hostile. Besides what the schema says, no text has a control
/// character. Messages quote the keyword "must_be" of a schema, which is ours, where it has one:
/// "64 hexadecimal digits". Patterns are POSIX extended expressions.
/// @throws HarnessError for the first thing that is wrong, with its place in front: the keys that
///         lead there, and an item of a list by its "name" if it has one
void check_schema(const Json& value, const Json& schema);

}  // namespace geodesic::harness
