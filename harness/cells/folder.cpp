#include "harness/cells/folder.h"

#include "harness/error.h"
#include "harness/folders.h"
#include "harness/results/context.h"

namespace geodesic::harness {
namespace fs = std::filesystem;

fs::path make_result_folder(const std::optional<fs::path>& out, const std::string& kind,
                            const std::string& name) {
  std::string time = utc_now();
  std::erase_if(time, [](char c) { return c == '-' || c == ':'; });
  fs::path folder = out.value_or(results_folder() / kind / (time + "-" + name));
  if (fs::exists(folder / "run.json") || fs::exists(folder / "cells")) {
    throw HarnessError("'" + folder.string() +
                       "' holds a run already: remove it, or give another folder with --out");
  }
  std::error_code error;
  fs::create_directories(folder / "cells", error);
  if (!error) fs::create_directories(folder / "references", error);
  if (error) {
    throw HarnessError("cannot make the folder '" + folder.string() + "': " + error.message());
  }
  return folder;
}

}  // namespace geodesic::harness
