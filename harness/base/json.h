// The JSON type of the whole harness: keys stay in the order in which they were written.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace geodesic::harness {
[[noreturn]] inline void misused_json(const char* condition) {
  throw std::logic_error(std::string("a fault of this program, please report it: JSON: ") +
                         condition);
}
}  // namespace geodesic::harness

// In every build: without it, reading a missing key of a constant object reads foreign memory.
#define JSON_ASSERT(condition) ((condition) ? void() : geodesic::harness::misused_json(#condition))
#include <nlohmann/json.hpp>

/// @cond  Doxygen does not find the class that is specialised.
/// An empty optional is null.
template <class Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
  static void to_json(auto& json, const std::optional<Value>& value) {
    json = nullptr;
    if (value) json = *value;
  }
  static void from_json(const auto& json, std::optional<Value>& value) {
    value.reset();
    if (!json.is_null()) value = json.template get<Value>();
  }
};
/// @endcond

namespace geodesic::harness {

using Json = nlohmann::ordered_json;

/// Converts a struct to JSON and back, each member under its own name. A member keeps its value if
/// the JSON lacks it or has null, which stands for a number that is not finite. (The library's
/// macros of this kind are for unordered objects.)
#define GEODESIC_JSON_MEMBERS(Type, ...)                                               \
  inline void to_json(harness::Json& nlohmann_json_j, const Type& nlohmann_json_t) {   \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__))           \
  }                                                                                    \
  inline void from_json(const harness::Json& nlohmann_json_j, Type& nlohmann_json_t) { \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(GEODESIC_JSON_READ, __VA_ARGS__))         \
  }
#define GEODESIC_JSON_READ(member)                                  \
  if (!nlohmann_json_j.value(#member, harness::Json()).is_null()) { \
    nlohmann_json_j.at(#member).get_to(nlohmann_json_t.member);     \
  }

/// Parses the content of a file, which may be hostile.
/// @param name the file in messages
/// @throws HarnessError when the text is not JSON (the message says where), is nested more than 50
///         deep, or has an object of more than 1000 keys
Json parse_json(std::string_view text, const std::string& name);

/// A value as in its file, for a message. For a list or an object, which may be large, its type.
std::string shown(const Json& value);

/// Writes indented JSON completely or not at all; bytes that are not UTF-8 become U+FFFD.
/// @throws CannotWrite
void write_json(const std::filesystem::path& path, const Json& json);

/// @param wanted what a user should name instead, for the message when the file cannot be read
/// @throws HarnessError when the file cannot be read, and for the reasons of `parse_json`
Json read_json(const std::filesystem::path& path, const std::string& wanted = "");

}  // namespace geodesic::harness
