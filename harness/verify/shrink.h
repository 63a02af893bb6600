// Makes a failing case smaller.
#pragma once

#include <functional>

#include "harness/verify/property.h"

namespace geodesic::harness {

/// Starts with a few faces around the sources, if the case fails on them. Removes queries, sources
/// and faces, in halves, quarters and so on down to single ones, as long as the case fails without
/// them (after Zeller, Hildebrandt 2002, "Simplifying and isolating failure-inducing input"). Faces
/// far from the sources are removed first. Faces keep their order. Vertices that neither a face nor
/// a source needs are removed as well.
/// @param given a case that fails
/// @param suspect the query with the wrong answer; without sources when no single query has one
/// @param still_fails whether a smaller case fails in the same way
/// @param seconds after which the smallest case so far is returned
Case shrink(const Case& given, const Query& suspect,
            const std::function<bool(const Case&)>& still_fails, double seconds);

}  // namespace geodesic::harness
