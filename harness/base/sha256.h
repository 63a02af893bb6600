#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace geodesic::harness {

/// SHA-256 (FIPS 180-4), as 64 lower-case hexadecimal digits.
std::string sha256_of(std::string_view bytes);

/// The same of a file's bytes. @throws HarnessError when the file cannot be read
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace geodesic::harness
