#include "harness/base/npy.h"

namespace geodesic::harness {

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

}  // namespace geodesic::harness
