// Arrays in the files of preparations (prepared_file.h), written as they lie in memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <ostream>
#include <span>
#include <type_traits>
#include <vector>

namespace geodesic {

/// A sum of bytes that changes if any of them does, except by a chance of 2^-64. It is none against
/// forgery: readers check what they need in order to be safe.
class ByteSum {
 public:
  void add(std::span<const std::byte> bytes);
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0x9e3779b97f4a7c15;
};

/// Writes arrays, and sums them.
class PreparedWriter {
 public:
  explicit PreparedWriter(std::ostream& to) : to_(to) {}

  template <class T>
  void write(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::uint64_t count = values.size();
    write_bytes(std::as_bytes(std::span(&count, 1)));
    write_bytes(std::as_bytes(values));
  }
  template <class T>
  void write_one(const T& value) {
    write(std::span(&value, 1));
  }
  std::uint64_t sum() const { return sum_.value(); }

 private:
  void write_bytes(std::span<const std::byte> bytes);

  std::ostream& to_;
  ByteSum sum_;
};

/// Reads what a PreparedWriter wrote. All functions throw std::invalid_argument where the file ends
/// early or has another array than the one that is asked for.
class PreparedReader {
 public:
  explicit PreparedReader(std::istream& from) : from_(from) {}

  template <class T>
  std::vector<T> read() {
    static_assert(std::is_trivially_copyable_v<T>);
    std::uint64_t count = 0;
    read_bytes(std::as_writable_bytes(std::span(&count, 1)));
    sum_.add(std::as_bytes(std::span(&count, 1)));
    // Piece by piece: a wrong count meets the end of the file before it takes memory.
    constexpr std::size_t kAtOnce = (std::size_t{1} << 22) / sizeof(T) + 1;
    std::vector<T> values;
    while (values.size() < count) {
      const std::size_t begin = values.size();
      values.resize(begin +
                    static_cast<std::size_t>(std::min<std::uint64_t>(kAtOnce, count - begin)));
      read_bytes(std::as_writable_bytes(std::span(values).subspan(begin)));
    }
    sum_.add(std::as_bytes(std::span(values)));  // whole, as it was written
    return values;
  }
  template <class T>
  T read_one() {
    const std::vector<T> values = read<T>();
    check(values.size() == 1);
    return values.front();
  }
  std::uint64_t sum() const { return sum_.value(); }

  /// Refuses the file unless something holds that holds in every file of a PreparedWriter.
  static void check(bool holds);

 private:
  void read_bytes(std::span<std::byte> bytes);

  std::istream& from_;
  ByteSum sum_;
};

}  // namespace geodesic
