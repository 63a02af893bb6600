// .npy files have exactly the bytes that NumPy writes.
#include "meshes/formats/npy.h"

#include <gtest/gtest.h>

namespace geodesic {
namespace {

using namespace std::string_literals;

std::string header(const std::string& dictionary, std::size_t padding, char length) {
  return "\x93NUMPY\x01\x00"s + length + '\0' + dictionary + std::string(padding, ' ') + '\n';
}

TEST(Npy, NumbersAreWrittenAsNumpyDoes) {
  const std::string bytes = npy_bytes(std::span<const float>(std::vector{1.0F, -2.0F}));
  EXPECT_EQ(bytes, header("{'descr': '<f4', 'fortran_order': False, 'shape': (2,), }", 60, 0x76) +
                       "\x00\x00\x80\x3f\x00\x00\x00\xc0"s);
}

TEST(Npy, RowsAreWrittenAsNumpyDoes) {
  const std::string bytes =
      npy_bytes(std::span<const std::uint32_t>(std::vector<std::uint32_t>{1, 2, 3}), 3);
  EXPECT_EQ(bytes, header("{'descr': '<u4', 'fortran_order': False, 'shape': (1, 3), }", 58, 0x76) +
                       "\x01\0\0\0\x02\0\0\0\x03\0\0\0"s);
}

struct Row {
  std::uint64_t windows;
  double least;
};

TEST(Npy, TablesAreWrittenAsNumpyDoes) {
  const std::string bytes = npy_table_bytes(std::vector<Row>{{258, 0.5}},
                                            npy_column<std::uint32_t>("windows", &Row::windows),
                                            npy_column<float>("least", &Row::least));
  EXPECT_EQ(bytes,
            header("{'descr': [('windows', '<u4'), ('least', '<f4')], 'fortran_order': False, "
                   "'shape': (1,), }",
                   27, 0x76) +
                "\x02\x01\0\0\x00\x00\x00\x3f"s);
}

TEST(Npy, TablesMayBeEmpty) {
  const std::string bytes =
      npy_table_bytes(std::vector<Row>{}, npy_column<std::uint64_t>("windows", &Row::windows));
  EXPECT_NE(bytes.find("'shape': (0,)"), std::string::npos);
  EXPECT_EQ(bytes.size() % 64, 0u);
}

}  // namespace
}  // namespace geodesic
