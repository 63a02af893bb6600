#include "harness/base/plugins.h"

#include <cxxabi.h>
#include <dlfcn.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <memory>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "solvers/core/registry.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

std::vector<Plugin>& plugins() {
  static std::vector<Plugin> all;
  return all;
}

std::string demangled(const std::string& symbol) {
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, nullptr), std::free);
  return name ? name.get() : symbol;
}

// Explains a dynamic linker message: "FILE: undefined symbol: _Z...", "FILE: invalid ELF header"
std::string load_failure(const std::string& complaint, const fs::path& file) {
  constexpr std::string_view kUndefined = "undefined symbol: ";
  if (const std::size_t at = complaint.find(kUndefined); at != std::string::npos) {
    return "it needs '" + demangled(complaint.substr(at + kUndefined.size())) +
           "', which neither it nor this program has: link what defines that, or build it again "
           "against this program's package";
  }
  const std::string prefix = file.string() + ": ";
  return "it is not a shared library that can be loaded: " +
         (complaint.starts_with(prefix) ? complaint.substr(prefix.size()) : complaint);
}

std::vector<std::string> load_solvers(const fs::path& file) {
  std::string complaint;
  // RTLD_NOW finds a missing symbol here and not during a solve. RTLD_LOCAL separates the symbols
  // that two plug-ins both define.
  const Registrations registrations = collect_registrations([&] {
    if (dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL) == nullptr) complaint = dlerror();
  });
  if (!complaint.empty()) throw HarnessError(load_failure(complaint, file));
  if (!registrations.refused.empty()) throw HarnessError(registrations.refused.front());
  if (registrations.added.empty()) {
    throw HarnessError("it registers no solver: that takes a RegisterSolver at namespace scope");
  }
  return registrations.added;
}

bool plain_word(const std::string& word) {
  const std::string plain = "-_./:,=+@%";
  return !word.empty() && std::ranges::all_of(word, [&](unsigned char c) {
    return std::isalnum(c) != 0 || plain.find(static_cast<char>(c)) != std::string::npos;
  });
}

}  // namespace

void load_plugin(const fs::path& file) {
  try {
    if (!fs::exists(file)) throw HarnessError("there is no such file");
    if (!fs::is_regular_file(file)) throw HarnessError("it is not a regular file");
    const fs::path whole = fs::canonical(file);
    if (std::ranges::find(plugins(), whole.string(), &Plugin::value) != plugins().end()) {
      throw HarnessError("it is loaded already: name it once");
    }
    note_plugin({.option = kPluginOption,
                 .value = whole,
                 .sha256 = sha256_of_file(whole),
                 .solvers = load_solvers(whole)});
  } catch (const std::exception& error) {
    throw HarnessError("plug-in '" + file.string() + "': " + error.what());
  }
}

void note_plugin(Plugin plugin) { plugins().push_back(std::move(plugin)); }

std::vector<std::string> plugin_arguments() {
  std::vector<std::string> words;
  for (const Plugin& plugin : plugins()) {
    words.insert(words.end(), {plugin.option, plugin.value});
  }
  return words;
}

const std::vector<Plugin>& loaded_plugins() { return plugins(); }

std::string quoted(const std::string& word) {
  if (plain_word(word)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string as_shell_line(const std::vector<std::string>& words) {
  std::vector<std::string> quoted_words(words.size());
  std::ranges::transform(words, quoted_words.begin(), quoted);
  return join(quoted_words, " ");
}

std::string as_command_line(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program_invocation_name};
  for (const auto& more : {plugin_arguments(), arguments}) {
    words.insert(words.end(), more.begin(), more.end());
  }
  return as_shell_line(words);
}

}  // namespace geodesic::harness
