#include "harness/rank/figure.h"

#include "harness/base/error.h"
#include "harness/base/folders.h"
#include "harness/base/process.h"

namespace geodesic::harness {
namespace {

// Debian's own, which its matplotlib belongs to; the first on the PATH may be another.
constexpr const char* kPython = "/usr/bin/python3";

// Empty when it was drawn, otherwise why not.
std::string draw(const std::filesystem::path& script, const std::filesystem::path& folder) {
  if (!std::filesystem::exists(script)) return "there is no " + script.string();
  try {
    const Ended ended = run_program(kPython, {script.string(), "--rank", folder.string()}, [] {});
    return ended.succeeded() ? "" : ended.describe();
  } catch (const HarnessError& error) {
    return std::string(kPython) + ": " + error.what();
  }
}

}  // namespace

std::string draw_rank_figure(const std::filesystem::path& folder) {
  const std::filesystem::path script = data_folder() / "plots" / "rank.py";
  const std::string why = draw(script, folder);
  if (why.empty()) return (folder / "rank.pdf").string() + " (also .png)";
  return "no figure (" + why + "); to draw it later: " + kPython + ' ' + script.string() +
         " --rank '" + folder.string() + "'";
}

}  // namespace geodesic::harness
