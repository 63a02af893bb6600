#include "harness/measure/npz.h"

#include <zlib.h>

#include "meshes/formats/bytes.h"

namespace geodesic::harness {
namespace {

constexpr std::uint16_t kVersion = 45;  // that reads archives above 4 GB
constexpr std::uint32_t kElsewhere32 = 0xffffffff;
constexpr std::uint16_t kElsewhere16 = 0xffff;
constexpr std::uint16_t kEarliestDate =
    0x21;  // 1 January 1980: the same bytes whenever it is written

template <class... Numbers>
void append_all(std::string& bytes, Numbers... numbers) {
  (append_little_endian(bytes, numbers), ...);
}

// From the version to the sizes: the same in both headers of a file.
void append_common(std::string& bytes, std::uint32_t crc, std::size_t name) {
  const std::uint16_t flags = 0, stored = 0, time = 0;
  append_all(bytes, kVersion, flags, stored, time, kEarliestDate, crc, kElsewhere32, kElsewhere32,
             static_cast<std::uint16_t>(name));
}

constexpr std::uint16_t kLongSizes = 1;  // the extra field with numbers of 64 bits

}  // namespace

std::string NpzWriter::local_header(const Member& member) const {
  std::string bytes = "PK\3\4";
  append_common(bytes, member.crc, member.name.size());
  append_all(bytes, std::uint16_t{20});
  bytes += member.name;
  append_all(bytes, kLongSizes, std::uint16_t{16}, member.size, member.size);
  return bytes;
}

void NpzWriter::begin(const std::string& name) {
  members_.push_back({.name = name, .offset = position()});
  stream_ << local_header(members_.back());
}

void NpzWriter::append(std::string_view bytes) {
  Member& member = members_.back();
  member.size += bytes.size();
  member.crc = static_cast<std::uint32_t>(
      crc32_z(member.crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void NpzWriter::end() {
  const auto after = stream_.tellp();
  stream_.seekp(static_cast<std::streamoff>(members_.back().offset));
  stream_ << local_header(members_.back());
  stream_.seekp(after);
}

void NpzWriter::add(const std::string& name, std::string_view bytes) {
  begin(name);
  append(bytes);
  end();
}

void NpzWriter::finish() {
  const std::uint64_t list_at = position();
  for (const Member& member : members_) {
    std::string bytes = "PK\1\2";
    append_all(bytes, kVersion);
    append_common(bytes, member.crc, member.name.size());
    const std::uint16_t comment = 0, disk = 0, attributes = 0;
    append_all(bytes, std::uint16_t{28}, comment, disk, attributes, std::uint32_t{0}, kElsewhere32);
    bytes += member.name;
    append_all(bytes, kLongSizes, std::uint16_t{24}, member.size, member.size, member.offset);
    stream_ << bytes;
  }
  const std::uint64_t end_at = position(), count = members_.size();
  std::string bytes = "PK\6\6";
  append_all(bytes, std::uint64_t{44}, kVersion, kVersion, std::uint32_t{0}, std::uint32_t{0},
             count, count, end_at - list_at, list_at);
  bytes += "PK\6\7";
  append_all(bytes, std::uint32_t{0}, end_at, std::uint32_t{1});
  bytes += "PK\5\6";
  append_all(bytes, std::uint16_t{0}, std::uint16_t{0}, kElsewhere16, kElsewhere16, kElsewhere32,
             kElsewhere32, std::uint16_t{0});
  stream_ << bytes;
}

}  // namespace geodesic::harness
