// Removes temporary files when Ctrl-C, SIGTERM or SIGHUP ends the program.
#pragma once

#include <filesystem>

namespace geodesic::harness {

/// While it exists, a signal of InterruptionGuard that ends this process removes the file. A signal
/// that is ignored or handled otherwise, by an InterruptionGuard too, stays so. Child processes
/// that are forked remove nothing.
class PartFile {
 public:
  /// At most 16 files of a process are removed at a time, with names of less than 4096 bytes;
  /// others stay.
  explicit PartFile(const std::filesystem::path& file);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

 private:
  struct Slot;
  static Slot slots_[];
  static void remove_and_end(int signal);

  Slot* slot_ = nullptr;
};

}  // namespace geodesic::harness
