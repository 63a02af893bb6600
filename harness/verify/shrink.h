// The smallest case that still fails.
#pragma once

#include <functional>

#include "harness/verify/property.h"

namespace geodesic::harness {

/// Starts with the fewest faces around the sources that fail, if less than all do. Takes away
/// queries, sources and faces, in halves, quarters and so on down to single ones, as long as the
/// case fails without them (after Zeller, Hildebrandt 2002, "Simplifying and isolating
/// failure-inducing input"). Faces far from the source go first; faces keep their order, and
/// vertices that neither a face nor a source needs go too.
/// @param given fails
/// @param suspect the query that was answered wrongly; without sources when no single one was
/// @param still_fails whether a smaller case fails in the same way
/// @param seconds after which the smallest case so far is returned
Case shrink(const Case& given, const Query& suspect,
            const std::function<bool(const Case&)>& still_fails, double seconds);

}  // namespace geodesic::harness
