// How a cell can end: `outcome` of a row (results/README.md).
#pragma once

#include <array>

namespace geodesic::harness::outcome {

inline constexpr const char* kOk = "ok";
inline constexpr const char* kWrongAnswer = "wrong answer";
inline constexpr const char* kUnsupported = "unsupported";
inline constexpr const char* kOutOfMemory = "out of memory";
inline constexpr const char* kTimeOut = "time-out";
inline constexpr const char* kCrashed = "crashed";
inline constexpr const char* kError = "error";
inline constexpr const char* kSkipped = "skipped";  ///< after another source of solver and mesh

/// What a suite may expect of a cell.
inline constexpr std::array kExpectable{kUnsupported, kOutOfMemory, kTimeOut, kCrashed, kError};

}  // namespace geodesic::harness::outcome
