#include "meshes/formats/npy.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "meshes/messages.h"

namespace geodesic {
namespace {

constexpr std::string_view kNpyMagic = "\x93NUMPY";
constexpr std::size_t kNpyPreamble = 10;  // bytes: magic, version, length of the header

/// Reads one number of a type from its bytes.
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

/// The header: a Python dictionary of one line, like
/// {'descr': '<i2', 'fortran_order': False, 'shape': (344, 403), }
class NpyHeader {
 public:
  NpyHeader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  const NumberType& type() const {
    const std::string_view value = value_of("descr");
    const std::string_view word =
        value.starts_with('\'') ? value.substr(1, value.find('\'', 1) - 1) : value.substr(0, 20);
    for (const NumberType& type : kNumberTypes) {
      if (type.word == word) return type;
    }
    throw MeshError(name_ + ": holds numbers of type '" + std::string(word) +
                    "'; <i2, <i4, <f4 and <f8 can be read, so convert it with numpy's astype");
  }

  void require_c_order() const {
    if (value_of("fortran_order").starts_with("False")) return;
    throw MeshError(name_ + ": not in C order; convert it with numpy's ascontiguousarray");
  }

  Array shape() const {
    std::string_view rest = value_of("shape");
    const auto take = [&rest](std::string_view expected) {
      const bool found = rest.starts_with(expected);
      if (found) rest.remove_prefix(expected.size());
      return found;
    };
    const auto take_size = [&rest]() -> std::optional<std::size_t> {
      std::size_t size = 0;
      const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), size);
      rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
      return error == std::errc() ? std::optional(size) : std::nullopt;
    };
    const bool opens = take("(");
    const auto rows = take_size();
    const bool goes_on = take(", ");
    const auto columns = take_size();
    if (!opens || !rows || !goes_on || !columns || !(take(")") || take(",)"))) {
      throw MeshError(name_ + ": not an array of two dimensions");
    }
    if (*rows < 2 || *columns < 2) {
      throw MeshError(name_ + ": an array of " + std::to_string(*rows) + " x " +
                      std::to_string(*columns) + " numbers; it takes 2 x 2 to span a surface");
    }
    return {.rows = *rows, .columns = *columns, .values = {}};
  }

 private:
  std::string_view value_of(std::string_view key) const {
    const std::string quoted = "'" + std::string(key) + "': ";
    const std::size_t found = text_.find(quoted);
    if (found == std::string_view::npos) {
      throw MeshError(name_ + ": the header has no '" + std::string(key) +
                      "'; get a whole copy of the file");
    }
    return text_.substr(found + quoted.size());
  }

  std::string_view text_;
  const std::string& name_;
};

std::string_view header_of(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(kNpyMagic)) throw MeshError(name + ": not a .npy file");
  if (bytes.size() < kNpyPreamble) throw MeshError(name + ": truncated; get a whole copy");
  if (bytes[6] != 1 || bytes[7] != 0) {
    throw MeshError(name + ": a .npy file of a version other than 1.0; save it again with numpy");
  }
  const std::size_t length = load_number<std::uint16_t>(bytes.data() + 8, std::endian::little);
  if (bytes.size() - kNpyPreamble < length) {
    throw MeshError(name + ": truncated within its header; get a whole copy");
  }
  return bytes.substr(kNpyPreamble, length);
}

void require_size(const Array& array, std::size_t number_bytes, std::size_t data_bytes,
                  const std::string& name) {
  // Divided: the product of a hostile shape would overflow.
  const std::size_t numbers = data_bytes / number_bytes;
  const bool fits = data_bytes % number_bytes == 0 && numbers % array.rows == 0 &&
                    numbers / array.rows == array.columns;
  if (!fits) {
    throw MeshError(name + ": holds " + std::to_string(data_bytes) + " bytes of numbers, but " +
                    std::to_string(array.rows) + " x " + std::to_string(array.columns) +
                    " numbers of " + std::to_string(number_bytes) +
                    " bytes are announced; get a whole copy");
  }
}

}  // namespace

std::string npy_header(std::string_view description, std::string_view shape) {
  std::string text = "{'descr': ";
  text.append(description).append(", 'fortran_order': False, 'shape': ").append(shape);
  text += ", }";
  // Numbers begin at a multiple of 64 bytes; a line ends the header.
  constexpr std::size_t kAlignment = 64;
  while ((kNpyPreamble + text.size() + 1) % kAlignment != 0) text += ' ';
  text += '\n';

  std::string bytes(kNpyMagic);
  bytes += '\1';
  bytes += '\0';
  append_little_endian(bytes, static_cast<std::uint16_t>(text.size()));
  return bytes + text;
}

Array parse_npy(std::string_view bytes, const std::string& name) {
  const std::string_view text = header_of(bytes, name);
  const NpyHeader header(text, name);
  const NumberType& type = header.type();
  header.require_c_order();
  Array array = header.shape();
  const std::string_view data = bytes.substr(kNpyPreamble + text.size());
  require_size(array, type.bytes, data.size(), name);
  array.values.reserve(array.rows * array.columns);
  for (std::size_t i = 0; i < data.size(); i += type.bytes) {
    const double value = type.load(data.data() + i);
    if (!std::isfinite(value)) {
      throw MeshError(name + ": the number in row " +
                      std::to_string(array.values.size() / array.columns) + ", column " +
                      std::to_string(array.values.size() % array.columns) +
                      " (counted from 0) is not finite; fill the gaps first");
    }
    array.values.push_back(value);
  }
  return array;
}

}  // namespace geodesic
