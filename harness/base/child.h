// A child process, from its start until nothing is left of it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace geodesic::harness {

/// False in builds with sanitizers, which reserve far more address space than any machine has
/// memory, answer some signals themselves, and take their time.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kLimitsMemory = false;
#elif defined(__has_feature)
inline constexpr bool kLimitsMemory =
    !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
inline constexpr bool kLimitsMemory = true;
#endif

class Child {
 public:
  /// @param memory_bytes of address space that it may have, if `kLimitsMemory`
  /// @throws HarnessError when the program cannot be started
  Child(const std::string& program, const std::vector<std::string>& arguments,
        std::uint64_t memory_bytes);
  /// Kills it, unless it was finished.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool has_ended() const;

  /// Takes in what it says on its standard error, for a twentieth of a second at most.
  void listen(double most_seconds);

  struct Exit {
    int status;  ///< as waitpid gives it
    std::int64_t peak_resident_bytes;
    double cpu_seconds;
    std::int64_t involuntary_switches;
    std::string last_words;  ///< the end of what it said
  };
  /// Kills its process group, itself included where it still runs. Once.
  Exit finish();

 private:
  void read_what_there_is();

  pid_t process_ = 0;
  int pipe_ = -1;  // its standard error; -1 when the other end is closed
  int nap_ms_ = 1;
  std::string tail_;
};

}  // namespace geodesic::harness
