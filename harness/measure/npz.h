// numpy's .npz: a ZIP archive of .npy files, not compressed (PKWARE, "APPNOTE.TXT", 6.3, with the
// fields for more than 4 GB).
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic::harness {

/// Writes an archive from its beginning to its end. Errors are those of the stream.
class NpzWriter {
 public:
  /// @param stream of a file, at its beginning; can be sought
  explicit NpzWriter(std::ostream& stream) : stream_(stream) {}

  /// A file of the archive: `begin`, any number of `append`, `end`.
  void begin(const std::string& name);
  void append(std::string_view bytes);
  void end();
  /// A whole one.
  void add(const std::string& name, std::string_view bytes);

  /// Writes the list of files, which ends the archive.
  void finish();

 private:
  struct Member {
    std::string name;
    std::uint64_t offset;
    std::uint64_t size = 0;
    std::uint32_t crc = 0;
  };
  std::string local_header(const Member& member) const;
  std::uint64_t position() const { return static_cast<std::uint64_t>(stream_.tellp()); }

  std::ostream& stream_;
  std::vector<Member> members_;
};

}  // namespace geodesic::harness
