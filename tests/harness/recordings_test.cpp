// Which cells write recordings, and into which folders.
#include "harness/run/plan.h"

#include <algorithm>
#include <set>

#include "harness/recordings/files.h"
#include "tests/harness/expect_error.h"

namespace geodesic::harness {
namespace {

class RecordedCells : public ::testing::Test {
 protected:
  Cell cell(Index vertices, Index source, const Description& solver) {
    mesh_.vertices = vertices;
    mesh_.sources = mesh_.run_sources = {single_source(7), single_source(9)};
    return {&mesh_, &mesh_.sources[source == 7 ? 0 : 1], &solver};
  }
  PlannedMesh mesh_;
  static Description solver(Exactness exactness) {
    Description description;
    description.exactness = exactness;
    return description;
  }
  const Description exact_ = solver(Exactness::exact);
  const Description bound_ = solver(Exactness::upper_bound);
};

TEST_F(RecordedCells, AreByDefaultTheFirstSourceOfMeshesOfReasonableSize) {
  EXPECT_TRUE(leaves_recordings(cell(1000, 7, exact_), Recordings::automatic));
  EXPECT_TRUE(leaves_recordings(cell(250'000, 7, exact_), Recordings::automatic));
  EXPECT_FALSE(leaves_recordings(cell(999, 7, exact_), Recordings::automatic));
  EXPECT_FALSE(leaves_recordings(cell(250'001, 7, exact_), Recordings::automatic));
  EXPECT_FALSE(leaves_recordings(cell(1000, 9, exact_), Recordings::automatic));
  EXPECT_TRUE(leaves_recordings(cell(1000, 7, bound_), Recordings::automatic));
}

TEST_F(RecordedCells, AreWrittenForAllCellsOrForNone) {
  EXPECT_TRUE(leaves_recordings(cell(3, 9, bound_), recordings_named("all")));
  EXPECT_FALSE(leaves_recordings(cell(1000, 7, exact_), recordings_named("none")));
  expect_error([] { recordings_named("non"); },
               {"'non'", "did you mean 'none'", "none, auto, all"});
}

TEST(RecordingFolders, AreNamedByMeshSourceAndSolver) {
  const RecordingFolders folders = recording_folders("stanford-bunny_2.0", "12", "fwp-mmp");
  EXPECT_EQ(folders.mesh, "recordings/stanford-bunny_2.0");
  EXPECT_EQ(folders.source, "recordings/stanford-bunny_2.0/src12");
  EXPECT_EQ(folders.solver, "recordings/stanford-bunny_2.0/src12/fwp-mmp");
}

TEST(RecordingFolders, StayApartAndInsideTheRunWhateverTheMeshIsCalled) {
  std::set<std::string> folders;
  const std::vector<std::string> names{"a b", "a_b",  "a%20b",    "..",   ".", "../x",
                                       "a/b", "a\nb", "\xc3\xa9", "$(x)", "-"};
  for (const std::string& name : names) {
    const std::string folder = recording_folders(name, "0", "mmp").mesh.string();
    EXPECT_EQ(folder.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEF0123456789._-%/"),
              std::string::npos)
        << folder;
    EXPECT_EQ(std::filesystem::path(folder).lexically_normal(), folder);
    EXPECT_EQ(std::ranges::count(folder, '/'), 1) << folder;
    folders.insert(folder);
  }
  EXPECT_EQ(folders.size(), names.size());
}

}  // namespace
}  // namespace geodesic::harness
