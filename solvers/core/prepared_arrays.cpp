#include "solvers/core/prepared_arrays.h"

#include <cstring>
#include <stdexcept>

namespace geodesic {

void ByteSum::add(std::span<const std::byte> bytes) {
  constexpr std::uint64_t kFactor = 0x9fb21c651e98df25;  // odd, with bits all over
  const auto mix = [this](std::uint64_t word) {
    sum_ = (sum_ ^ word) * kFactor;
    sum_ ^= sum_ >> 32;
  };
  while (bytes.size() >= sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), sizeof word);
    mix(word);
    bytes = bytes.subspan(sizeof word);
  }
  std::uint64_t rest = bytes.size() + 1;
  if (!bytes.empty()) std::memcpy(&rest, bytes.data(), bytes.size());
  mix(rest);
}

void PreparedWriter::write_bytes(std::span<const std::byte> bytes) {
  sum_.add(bytes);
  to_.write(reinterpret_cast<const char*>(bytes.data()),
            static_cast<std::streamsize>(bytes.size()));
}

void PreparedReader::read_bytes(std::span<std::byte> bytes) {
  const auto count = static_cast<std::streamsize>(bytes.size());
  if (!from_.read(reinterpret_cast<char*>(bytes.data()), count)) {
    throw std::invalid_argument("the preparation ends early: prepare again");
  }
}

void PreparedReader::check(bool holds) {
  if (!holds) throw std::invalid_argument("the preparation is damaged: prepare again");
}

}  // namespace geodesic
