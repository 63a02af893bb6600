#include "harness/base/json.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "meshes/formats/parsing.h"

namespace geodesic::harness {
namespace {

constexpr std::size_t kDeepest = 50;
constexpr std::size_t kMostKeys = 1000;

// Values are copied and written recursively, and the keys of an object are searched linearly. Far
// above these bounds the stack overflows or the time is quadratic. The project's files stay below.
void check_bounds(std::string_view text) {
  std::vector<std::size_t> keys{0};  // key count of each open list and object; 0 for a list
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\') ++i;  // an escaped quote does not end the string
    if (c == '"') in_string = !in_string;
    if (in_string) continue;
    if (c == '{' || c == '[') keys.push_back(0);
    if ((c == '}' || c == ']') && keys.size() > 1) keys.pop_back();
    if (c == ':') ++keys.back();
    if (keys.size() > kDeepest + 1) {
      throw HarnessError("lists and objects are nested more than " + std::to_string(kDeepest) +
                         " deep");
    }
    if (keys.back() > kMostKeys) {
      throw HarnessError("an object has more than " + std::to_string(kMostKeys) + " keys");
    }
  }
}

// The library's message without its number: "type must be string, but is array".
std::string reason_of(const Json::exception& error) {
  const std::string_view text = error.what();
  return excerpt(text.substr(text.find("] ") + 2));
}

}  // namespace

Json parse_json(std::string_view text, const std::string& name) {
  try {
    text = text_of(text, name);
    check_bounds(text);
    return Json::parse(text);
  } catch (const MeshError& error) {
    throw HarnessError(error.what());
  } catch (const Json::exception& error) {
    throw HarnessError(name + ": not valid JSON: " + reason_of(error) +
                       "; correct it or get a whole copy");
  } catch (const HarnessError& error) {
    throw HarnessError(name + ": " + error.what());
  }
}

std::string shown(const Json& value) {
  if (value.is_structured()) return std::string("an ") + value.type_name();
  return excerpt(value.dump());
}

void write_json(const std::filesystem::path& path, const Json& json) {
  AtomicFile file(path);
  file.stream() << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  file.commit();
}

Json read_json(const std::filesystem::path& path, const std::string& wanted) {
  const auto unreadable = [&](const char* why) {
    return HarnessError("cannot read '" + path.string() + "': " + why +
                        (wanted.empty() ? "" : "; name " + wanted));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw unreadable("it is a folder");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file || text.bad()) throw unreadable(std::strerror(errno));
  return parse_json(text.view(), path.string());
}

}  // namespace geodesic::harness
