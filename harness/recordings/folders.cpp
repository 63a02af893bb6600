#include "harness/recordings/folders.h"

#include <cctype>

namespace geodesic::harness {
namespace {

// A name as one step of a path: what may mean something to a file system or a shell becomes %XX,
// and so does a dot in front.
std::string as_folder(const std::string& name) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string folder;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = byte < 0x80 && (std::isalnum(byte) || c == '_' || c == '-' ||
                                       (c == '.' && !folder.empty()));
    if (plain) {
      folder += c;
    } else {
      folder += {'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
  }
  return folder;
}

}  // namespace

RecordingFolders recording_folders(const std::string& mesh, Index source,
                                   const std::string& solver) {
  const std::filesystem::path of_mesh = std::filesystem::path("recordings") / as_folder(mesh);
  const std::filesystem::path of_source = of_mesh / ("src" + std::to_string(source));
  return {.mesh = of_mesh, .source = of_source, .solver = of_source / as_folder(solver)};
}

}  // namespace geodesic::harness
