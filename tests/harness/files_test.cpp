#include <csignal>
#include <filesystem>

#include "harness/base/files.h"
#include "harness/base/interruption.h"
#include "harness/corpus/manifest.h"
#include "harness/verify/references.h"
#include "solvers/core/geometry.h"
#include "tests/harness/expect_error.h"
#include "tests/harness/temporary_folder.h"
#include "tests/harness/whole_manifest.h"

namespace geodesic::harness {
namespace fs = std::filesystem;
namespace {

using Files = TemporaryFolder;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST_F(Files, AtomicFileAppearsOnlyWhenCommitted) {
  {
    AtomicFile file(folder_ / "a");
    file.stream() << "half";
    EXPECT_FALSE(fs::exists(folder_ / "a"));
  }
  EXPECT_EQ(files_in(folder_), 0u) << "an uncommitted file leaves nothing behind";
  AtomicFile file(folder_ / "a");
  file.stream() << "whole";
  file.commit();
  EXPECT_EQ(read(folder_ / "a"), "whole");
  EXPECT_EQ(files_in(folder_), 1u);
}

TEST_F(Files, AtomicFileKeepsTheOldOneUntilCommitted) {
  write("a", "old");
  AtomicFile file(folder_ / "a");
  file.stream() << "new";
  EXPECT_EQ(read(folder_ / "a"), "old");
  file.commit();
  EXPECT_EQ(read(folder_ / "a"), "new");
}

TEST_F(Files, AtomicFileLeavesNothingBehindWhenASignalEndsTheProgram) {
  for (const int signal : InterruptionGuard::kSignals) {
    const auto end_in_the_middle = [&] {
      AtomicFile first(folder_ / "a"), second(folder_ / "b");
      first.stream() << "half";
      raise(signal);
    };
    EXPECT_EXIT(end_in_the_middle(), testing::KilledBySignal(signal), "");
    EXPECT_EQ(files_in(folder_), 0u);
  }
}

TEST_F(Files, AtomicFileIsKeptWhenASignalEndsAnotherProcess) {
  AtomicFile file(folder_ / "a");
  EXPECT_EXIT(raise(SIGTERM), testing::KilledBySignal(SIGTERM), "") << "a child";
  EXPECT_EQ(files_in(folder_), 1u);
  file.commit();
  EXPECT_TRUE(fs::exists(folder_ / "a"));
}

TEST_F(Files, AtomicFileWritesStraightToWhatIsNoRegularFile) {
  AtomicFile file("/dev/null");
  file.stream() << "gone";
  file.commit();
  EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST_F(Files, AtomicFileRefusesBeforeAnythingIsWritten) {
  expect_error([&] { AtomicFile file(folder_ / "none" / "a"); }, {"none/a", "No such file"});
  expect_error([&] { AtomicFile file{folder_}; }, {"is a folder"});
}

TEST_F(Files, DistancesComeBackBitForBit) {
  const std::vector<double> distances{0, 1.0 / 3, kInfinity, 5e-324};
  write_distances(folder_ / "d", distances);
  EXPECT_EQ(read_distances(folder_ / "d", 4), distances);
}

TEST_F(Files, DistancesOfAnotherMeshAreRefused) {
  write_distances(folder_ / "d", std::vector{1.0, 2.0});
  expect_error([&] { read_distances(folder_ / "d", 3); }, {"does not hold 3 distances"});
  expect_error([&] { read_distances(folder_ / "d", 1); }, {"does not hold 1 distances"});
}

TEST_F(Files, DistancesFromSeveralSourcesComeBackOneSourceAfterTheOther) {
  write_distances(folder_ / "d", std::vector{0.0, 1.0, 2.0, 0.0});
  DistanceRows rows(folder_ / "d", 2, 2);
  for (const std::vector<double>& row : {std::vector{0.0, 1.0}, {2.0, 0.0}}) {
    const auto read = rows.next();
    EXPECT_EQ(std::vector(read.begin(), read.end()), row);
  }
  expect_error([&] { rows.next(); }, {"cannot be read to its end"});
  expect_error([&] { DistanceRows(folder_ / "d", 3, 2); }, {"does not hold 6 distances"});
}

TEST_F(Files, Sha256IsTheStandardOne) {
  EXPECT_EQ(sha256_of_file(write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_file(write("empty", "")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  expect_error([&] { sha256_of_file(folder_ / "none"); }, {"none"});
}

constexpr const char* kManifest = R"({
  "corpora": {"quick": ["cube"], "all": ["cube", "horse"]},
  "meshes": [{"name": "cube", "kind": "generated", "file": "cube.obj"},
             {"name": "horse", "kind": "downloaded", "file": "horse.ply",
              "thesis_model": "horse", "stand_in": true}]})";

TEST_F(Files, ManifestFindsMeshesInTheCache) {
  const Manifest manifest(write("m.json", whole_manifest(kManifest)), folder_ / "cache");
  EXPECT_EQ(manifest.mesh("horse").file, folder_ / "cache" / "horse.ply");
  EXPECT_EQ(manifest.mesh("horse").thesis_model, "horse");
  EXPECT_TRUE(manifest.mesh("horse").stand_in);
  EXPECT_FALSE(manifest.mesh("cube").thesis_model);
  EXPECT_FALSE(manifest.mesh("cube").available());
  EXPECT_EQ(manifest.corpus("all").size(), 2u);
}

}  // namespace
}  // namespace geodesic::harness
