#include "harness/base/command_line.h"

#include <algorithm>
#include <cctype>
#include <cerrno>

#include "harness/base/plugins.h"

namespace geodesic::harness {
namespace {

bool plain_word(const std::string& word) {
  const std::string plain = "-_./:,=+@%";
  return !word.empty() && std::ranges::all_of(word, [&](unsigned char c) {
    return std::isalnum(c) != 0 || plain.find(static_cast<char>(c)) != std::string::npos;
  });
}

std::string quoted(const std::string& word) {
  if (plain_word(word)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string as_command_line(const std::vector<std::string>& arguments) {
  std::string line = quoted(program_invocation_name);
  for (const auto& words : {plugin_arguments(), arguments}) {
    for (const std::string& word : words) line += ' ' + quoted(word);
  }
  return line;
}

}  // namespace geodesic::harness
