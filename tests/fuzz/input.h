// A fuzz target reads the bytes of a file and processes them as the program does before it calls a
// solver. Each target is built into two programs: a fuzzer (fuzzer.cpp) and a program that replays
// files (replay.cpp).
#pragma once

#include <string_view>

namespace geodesic::harness::fuzz {

/// Defined by each target.
/// @throws HarnessError or MeshError for a file that is refused; any other exception is a finding
void read_input(std::string_view bytes);

/// Calls read_input and checks the promises of every reader: the message of a refusal is one line,
/// and the memory is in proportion to the file.
/// @throws std::logic_error for a broken promise; findings of read_input pass through
void check_input(std::string_view bytes);

}  // namespace geodesic::harness::fuzz
