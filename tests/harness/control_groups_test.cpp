#include "harness/base/control_groups.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "temporary_folder.h"

namespace geodesic::harness {
namespace {

class ControlGroups : public TemporaryFolder {
 protected:
  void set(const std::string& group, const std::string& limit_file, const std::string& limit,
           const std::string& used_file, const std::string& used) {
    std::filesystem::create_directories(folder_ / group);
    std::ofstream(folder_ / group / limit_file) << limit << '\n';
    std::ofstream(folder_ / group / used_file) << used << '\n';
  }
  void set_second(const std::string& group, const std::string& limit, const std::string& used) {
    set(group, "memory.max", limit, "memory.current", used);
  }
  std::uint64_t left(const std::string& groups) const {
    std::istringstream text(groups);
    return left_in_control_groups(text, folder_);
  }

  std::optional<double> processors(const std::string& groups) const {
    std::istringstream text(groups);
    return processors_in_control_groups(text, folder_);
  }

  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
};

TEST_F(ControlGroups, TheLimitOfTheGroupItselfCounts) {
  set_second(".", "max", "900");
  set_second("system.slice", "max", "800");
  set_second("system.slice/job", "100", "30");
  EXPECT_EQ(left("0::/system.slice/job\n"), 70U);
}

TEST_F(ControlGroups, ALimitOfAGroupAboveCounts) {
  set_second("system.slice", "60", "50");
  set_second("system.slice/job", "100", "30");
  EXPECT_EQ(left("0::/system.slice/job\n"), 10U);
}

TEST_F(ControlGroups, InAContainerTheGroupIsTheRoot) {
  set_second(".", "50", "80");
  EXPECT_EQ(left("0::/\n"), 0U) << "more is used than allowed";
}

TEST_F(ControlGroups, OfTheFirstVersionMemoryHasAMountOfItsOwn) {
  set("memory/slurm/job", "memory.limit_in_bytes", "100", "memory.usage_in_bytes", "1");
  EXPECT_EQ(left("4:cpu,cpuacct:/other\n9:memory:/slurm/job\n0::/\n"), 99U);
}

TEST_F(ControlGroups, WithoutALimitNothingIsLimited) {
  set_second("job", "max", "5");
  EXPECT_EQ(left("0::/job\n0::/gone\nnonsense\n"), kUnlimited);
  EXPECT_EQ(left(""), kUnlimited);
}

TEST_F(ControlGroups, TheLeastShareOfProcessorsOfAGroupAndThoseAboveCounts) {
  set("job", "cpu.max", "200000 100000", "cpu.weight", "100");
  set("job/step", "cpu.max", "max 100000", "cpu.weight", "100");
  EXPECT_EQ(processors("0::/job/step\n"), 2.0);
  set("job/step", "cpu.max", "50000 100000", "cpu.weight", "100");
  EXPECT_EQ(processors("0::/job/step\n"), 0.5);
}

TEST_F(ControlGroups, OfTheFirstVersionTheShareOfProcessorsIsInTwoFiles) {
  set("cpu/job", "cpu.cfs_quota_us", "150000", "cpu.cfs_period_us", "100000");
  EXPECT_EQ(processors("4:cpu,cpuacct:/job\n"), 1.5);
  set("cpu/job", "cpu.cfs_quota_us", "-1", "cpu.cfs_period_us", "100000");
  EXPECT_EQ(processors("4:cpu,cpuacct:/job\n"), std::nullopt);
  EXPECT_EQ(processors(""), std::nullopt);
}

}  // namespace
}  // namespace geodesic::harness
