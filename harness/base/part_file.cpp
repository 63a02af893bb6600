#include "harness/base/part_file.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

#include "harness/base/interruption.h"

namespace geodesic::harness {

// A signal handler may read it: it has no memory of its own, and the owner is set last.
struct PartFile::Slot {
  static constexpr int kFree = 0, kClaimed = -1;
  std::atomic<int> owner = kFree;  // number of the process
  std::array<char, 4096> name = {};
};
static_assert(std::atomic<int>::is_always_lock_free);

PartFile::Slot PartFile::slots_[16];

// Calls only functions that a signal handler may call.
void PartFile::remove_and_end(int signal) {
  const int process = getpid();
  for (const Slot& slot : slots_) {
    if (slot.owner.load() == process) unlink(slot.name.data());
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // comes when this function returns
}

PartFile::PartFile(const std::filesystem::path& file) {
  for (const int signal : InterruptionGuard::kSignals) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler != SIG_DFL) continue;
    now = {};
    now.sa_handler = remove_and_end;
    sigaction(signal, &now, nullptr);
  }
  const std::string& name = file.native();
  for (Slot& slot : slots_) {
    int expected = Slot::kFree;
    if (name.size() >= slot.name.size()) return;
    if (!slot.owner.compare_exchange_strong(expected, Slot::kClaimed)) continue;
    std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
    slot.owner.store(getpid());
    slot_ = &slot;
    return;
  }
}

PartFile::~PartFile() {
  if (slot_ != nullptr) slot_->owner.store(Slot::kFree);
}

}  // namespace geodesic::harness
