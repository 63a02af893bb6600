// The JSON type of the whole harness: keys stay in the order in which they were written.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace geodesic::harness {

using Json = nlohmann::ordered_json;

/// Parses the content of a file, which may be hostile.
/// @param name what messages call the file
/// @throws HarnessError for what is not JSON (the message says where), is nested more than 50 deep,
///         or has an object of more than 1000 keys
Json parse_json(std::string_view text, const std::string& name);

/// The library's message without its number: "type must be string, but is array".
std::string reason_of(const Json::exception& error);

/// A value as in its file, for a message; of a list or an object, which may be of any size, its
/// type.
std::string shown(const Json& value);

/// Writes indented JSON, whole or not at all; bytes that are not UTF-8 become U+FFFD.
/// @throws CannotWrite
void write_json(const std::filesystem::path& path, const Json& json);

/// @param wanted what a user should name instead, for the message when there is no such file
/// @throws HarnessError when the file cannot be read, and as `parse_json`
Json read_json(const std::filesystem::path& path, const std::string& wanted = "");

}  // namespace geodesic::harness
