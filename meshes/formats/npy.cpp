#include "meshes/formats/npy.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "meshes/messages.h"

namespace geodesic {
namespace {

constexpr std::string_view kNpyMagic = "\x93NUMPY";
constexpr std::size_t kNpyPreamble = 10;  // number of bytes: magic, version, length of the header

/// Reads one number of type T.
template <class T>
double load(const char* bytes) {
  return static_cast<double>(load_number<T>(bytes, std::endian::little));
}

struct NumberType {
  std::string_view word;
  std::size_t bytes;
  double (*load)(const char* bytes);
};
template <class T>
constexpr NumberType number_type() {
  return {npy_type<T>(), sizeof(T), load<T>};
}
constexpr NumberType kNumberTypes[] = {number_type<std::int16_t>(), number_type<std::int32_t>(),
                                       number_type<float>(), number_type<double>()};

class NpyParser {
 public:
  NpyParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  Array parse() {
    find_header();
    const NumberType& type = number_type_of_file();
    if (!value_of("fortran_order").starts_with("False")) {
      refuse("not in C order; convert it with numpy's ascontiguousarray");
    }
    Array array = shape();
    require_size(array, type.bytes);
    array.values = load_all(type);
    for (std::size_t i = 0; i < array.values.size(); ++i) {
      if (std::isfinite(array.values[i])) continue;
      refuse("the number in row " + std::to_string(i / array.columns) + ", column " +
             std::to_string(i % array.columns) +
             " (counted from 0) is not finite; fill the gaps first");
    }
    return array;
  }

  std::vector<double> numbers() {
    find_header();
    const NumberType& type = number_type_of_file();
    if (data_.size() % type.bytes != 0) refuse("truncated; get a whole copy");
    return load_all(type);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw MeshError(name_ + ": " + why); }

  /// A Python dictionary of one line: {'descr': '<i2', 'fortran_order': False, 'shape': (3, 4), }
  void find_header() {
    if (!is_npy(bytes_)) refuse("not a .npy file");
    if (bytes_.size() < kNpyPreamble) refuse("truncated; get a whole copy");
    if (bytes_[6] != 1 || bytes_[7] != 0) {
      refuse("a .npy file of a version other than 1.0; save it again with numpy");
    }
    const std::size_t length = load_number<std::uint16_t>(bytes_.data() + 8, std::endian::little);
    if (bytes_.size() - kNpyPreamble < length) {
      refuse("truncated within its header; get a whole copy");
    }
    header_ = bytes_.substr(kNpyPreamble, length);
    data_ = bytes_.substr(kNpyPreamble + length);
  }

  std::vector<double> load_all(const NumberType& type) const {
    std::vector<double> values;
    values.reserve(data_.size() / type.bytes);
    for (std::size_t i = 0; i < data_.size(); i += type.bytes) {
      values.push_back(type.load(data_.data() + i));
    }
    return values;
  }

  std::string_view value_of(std::string_view key) const {
    const std::string quoted = "'" + std::string(key) + "': ";
    const std::size_t found = header_.find(quoted);
    if (found == std::string_view::npos) {
      refuse("the header has no '" + std::string(key) + "'; get a whole copy of the file");
    }
    return header_.substr(found + quoted.size());
  }

  const NumberType& number_type_of_file() const {
    const std::string_view value = value_of("descr");
    const std::string_view word =
        value.starts_with('\'') ? value.substr(1, value.find('\'', 1) - 1) : value.substr(0, 20);
    const auto* const found = std::ranges::find(kNumberTypes, word, &NumberType::word);
    if (found == std::end(kNumberTypes)) {
      refuse("holds numbers of type '" + excerpt(word, 20) +
             "'; <i2, <i4, <f4 and <f8 can be read, so convert it with numpy's astype");
    }
    return *found;
  }

  Array shape() const {
    std::string_view rest = value_of("shape");
    const auto take = [&rest](std::string_view expected) {
      const bool found = rest.starts_with(expected);
      if (found) rest.remove_prefix(expected.size());
      return found;
    };
    const auto take_size = [&rest](std::size_t& size) {
      const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), size);
      rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
      return error == std::errc();
    };
    Array array;
    const bool matches = take("(") && take_size(array.rows) && take(", ") &&
                         take_size(array.columns) && (take(")") || take(",)"));
    if (!matches) refuse("not an array of two dimensions");
    if (array.rows < 2 || array.columns < 2) {
      refuse("an array of " + std::to_string(array.rows) + " x " + std::to_string(array.columns) +
             " numbers; it takes 2 x 2 to span a surface");
    }
    return array;
  }

  void require_size(const Array& array, std::size_t number_bytes) const {
    // Uses a division, since the product of a hostile shape would overflow.
    const std::size_t numbers = data_.size() / number_bytes;
    const bool fits = data_.size() % number_bytes == 0 && numbers % array.rows == 0 &&
                      numbers / array.rows == array.columns;
    if (!fits) {
      refuse("holds " + std::to_string(data_.size()) + " bytes of numbers, but " +
             std::to_string(array.rows) + " x " + std::to_string(array.columns) + " numbers of " +
             std::to_string(number_bytes) + " bytes are announced; get a whole copy");
    }
  }

  std::string_view bytes_;
  const std::string& name_;
  std::string_view header_;
  std::string_view data_;  // after the header
};

}  // namespace

std::string npy_header(std::string_view description, std::string_view shape) {
  std::string text = "{'descr': ";
  text.append(description).append(", 'fortran_order': False, 'shape': ").append(shape);
  text += ", }";
  // The numbers begin at a multiple of 64 bytes; a line end is the last byte of the header.
  constexpr std::size_t kAlignment = 64;
  while ((kNpyPreamble + text.size() + 1) % kAlignment != 0) text += ' ';
  text += '\n';

  std::string bytes(kNpyMagic);
  bytes += '\1';
  bytes += '\0';
  append_little_endian(bytes, static_cast<std::uint16_t>(text.size()));
  return bytes + text;
}

bool is_npy(std::string_view bytes) { return bytes.starts_with(kNpyMagic); }

std::vector<double> parse_npy_numbers(std::string_view bytes, const std::string& name) {
  return NpyParser(bytes, name).numbers();
}

Array parse_npy(std::string_view bytes, const std::string& name) {
  return NpyParser(bytes, name).parse();
}

}  // namespace geodesic
