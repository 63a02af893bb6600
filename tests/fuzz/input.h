// A fuzz target reads a file from its bytes and does with it what the program does before a solver
// sees anything. Two programs are made of each: a fuzzer (fuzzer.cpp) and one that replays files
// (replay.cpp).
#pragma once

#include <string_view>

namespace geodesic::harness::fuzz {

/// What a target defines.
/// @throws HarnessError or MeshError for a file that is refused; whatever else leaves it is a
/// finding
void read_input(std::string_view bytes);

/// Calls read_input and holds it to what every reader promises: a file that is refused is refused
/// with one line, and memory is in proportion to the file.
/// @throws std::logic_error for a broken promise, and findings of read_input
void check_input(std::string_view bytes);

}  // namespace geodesic::harness::fuzz
