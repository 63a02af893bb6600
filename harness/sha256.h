#pragma once

#include <filesystem>
#include <string>

namespace geodesic::harness {

/// SHA-256 (FIPS 180-4) of a file's bytes, as 64 lower-case hexadecimal digits.
/// @throws HarnessError when the file cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace geodesic::harness
