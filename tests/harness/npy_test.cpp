// .npy files, down to the byte, as numpy writes them.
#include "harness/base/npy.h"

#include "tests/harness/expect_error.h"
#include "tests/harness/temporary_folder.h"

namespace geodesic::harness {
namespace {

using namespace std::string_literals;
using Npy = TemporaryFolder;

std::string header(const std::string& dictionary, std::size_t padding, char length) {
  return "\x93NUMPY\x01\x00"s + length + '\0' + dictionary + std::string(padding, ' ') + '\n';
}

TEST_F(Npy, NumbersAreWrittenAsNumpyDoes) {
  write_npy(folder_ / "a", std::span<const float>(std::vector{1.0F, -2.0F}));
  EXPECT_EQ(read(folder_ / "a"),
            header("{'descr': '<f4', 'fortran_order': False, 'shape': (2,), }", 60, 0x76) +
                "\x00\x00\x80\x3f\x00\x00\x00\xc0"s);
}

TEST_F(Npy, RowsAreWrittenAsNumpyDoes) {
  write_npy(folder_ / "a", std::span<const std::uint32_t>(std::vector<std::uint32_t>{1, 2, 3}), 3);
  EXPECT_EQ(read(folder_ / "a"),
            header("{'descr': '<u4', 'fortran_order': False, 'shape': (1, 3), }", 58, 0x76) +
                "\x01\0\0\0\x02\0\0\0\x03\0\0\0"s);
}

struct Row {
  std::uint64_t windows;
  double least;
};

TEST_F(Npy, TablesAreWrittenAsNumpyDoes) {
  write_npy_table(folder_ / "a", std::vector<Row>{{258, 0.5}},
                  npy_column<std::uint32_t>("windows", &Row::windows),
                  npy_column<float>("least", &Row::least));
  EXPECT_EQ(read(folder_ / "a"),
            header("{'descr': [('windows', '<u4'), ('least', '<f4')], 'fortran_order': False, "
                   "'shape': (1,), }",
                   27, 0x76) +
                "\x02\x01\0\0\x00\x00\x00\x3f"s);
}

TEST_F(Npy, TablesMayBeEmpty) {
  write_npy_table(folder_ / "a", std::vector<Row>{},
                  npy_column<std::uint64_t>("windows", &Row::windows));
  EXPECT_NE(read(folder_ / "a").find("'shape': (0,)"), std::string::npos);
  EXPECT_EQ(read(folder_ / "a").size() % 64, 0u);
}

TEST_F(Npy, FilesThatCannotBeWrittenAreNamed) {
  expect_error([&] { write_npy(folder_ / "none" / "a", std::span<const double>()); },
               {"none/a", "No such file"});
}

}  // namespace
}  // namespace geodesic::harness
