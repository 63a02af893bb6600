// For which processors the loop is compiled: AVX2, and every other one (plain_lanes.h). To be
// included before <hwy/foreach_target.h>.
#pragma once

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_AVX3 | HWY_SSE4 | HWY_SSSE3)

#include <hwy/detect_targets.h>

/// Whether there is an AVX2 version beside the one for every processor of the build.
#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
#define GEODESIC_AVX2_BESIDE_STATIC 1
#else
#define GEODESIC_AVX2_BESIDE_STATIC 0
#endif
