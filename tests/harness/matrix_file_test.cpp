#include "harness/measure/matrix_file.h"

#include <vector>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "meshes/formats/npy.h"
#include "meshes/mesh_file.h"
#include "tests/harness/temporary_folder.h"

namespace geodesic::harness {
namespace {

class MatrixFileTest : public TemporaryFolder {
 protected:
  MatrixPlan plan(const std::string& name) const {
    return {.file = folder_ / name, .rows = 3, .columns = 4, .problem = std::string(64, 'p')};
  }
  // @param gap value of the third column
  static std::vector<double> row(std::size_t number, double gap = kInfinity) {
    const auto first = static_cast<double>(10 * number);
    return {first, first + 0.1, gap, first + 3};
  }
};

TEST_F(MatrixFileTest, keeps_the_rows_of_an_unfinished_matrix) {
  MatrixFile(plan("m.npy"), false).put(1, row(1));
  MatrixFile file(plan("m.npy"), true);
  EXPECT_FALSE(file.has(0));
  EXPECT_TRUE(file.has(1));
  file.put(2, row(2));
  file.put(0, row(0));
  file.finish();
  EXPECT_FALSE(std::filesystem::exists(unfinished(plan("m.npy").file)));

  MatrixFile whole(plan("whole.npy"), false);
  for (std::size_t i = 0; i < 3; ++i) whole.put(i, row(i));
  whole.finish();
  EXPECT_EQ(read_bytes(plan("m.npy").file), read_bytes(plan("whole.npy").file));
}

TEST_F(MatrixFileTest, holds_numbers_that_numpy_reads) {
  MatrixFile file(plan("m.npy"), false);
  for (std::size_t i = 0; i < 3; ++i) file.put(i, row(i, 5));
  file.finish();
  const Array array = parse_npy(read_bytes(plan("m.npy").file), "m.npy");
  EXPECT_EQ(array.rows, 3u);
  EXPECT_EQ(array.columns, 4u);
  EXPECT_EQ(array.at(2, 3), 23);
  EXPECT_EQ(array.at(1, 0), 10);
}

TEST_F(MatrixFileTest, leaves_nothing_behind_without_a_row) {
  { const MatrixFile file(plan("m.npy"), false); }
  EXPECT_FALSE(std::filesystem::exists(unfinished(plan("m.npy").file)));
}

TEST_F(MatrixFileTest, refuses_what_another_problem_or_process_writes) {
  const auto refusal = [](const MatrixPlan& plan, bool resume) {
    try {
      const MatrixFile file(plan, resume);
    } catch (const HarnessError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  {
    MatrixFile file(plan("m.npy"), false);
    file.put(0, row(0));
    EXPECT_NE(refusal(plan("m.npy"), true).find("another process is writing it"),
              std::string::npos);
  }
  EXPECT_NE(refusal(plan("m.npy"), false).find("continue it with --resume"), std::string::npos);
  MatrixPlan other = plan("m.npy");
  other.problem = std::string(64, 'q');
  EXPECT_NE(refusal(other, true).find("is of another problem"), std::string::npos);
  EXPECT_NE(refusal(plan("m.csv"), false).find("written as .npy"), std::string::npos);
}

}  // namespace
}  // namespace geodesic::harness
