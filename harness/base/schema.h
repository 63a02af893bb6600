// The part of JSON Schema, draft 2020-12, that datasets/manifest.schema.json,
// harness/suite.schema.json and descriptions of external solvers use.
#pragma once

#include "harness/base/json.h"

namespace geodesic::harness {

/// Checks a value that may be hostile. Besides the rules of the schema, no text may have a control
/// character. The keyword "must_be" is an extension; messages quote it: "64 hexadecimal digits".
/// Patterns are POSIX extended expressions.
/// @throws HarnessError for the first error. Its place is in front: the keys that lead there. An
///         item of a list is named by its "name" if it has one
void check_schema(const Json& value, const Json& schema);

}  // namespace geodesic::harness
