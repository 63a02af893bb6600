// The registry: the linker drops no solver, and no solver hides another.
#include "solvers/core/registry.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/verify/solver_test.h"

namespace geodesic::harness {
namespace {

// The folders of solvers/ that are built. CMake gives a list separated by bars.
std::vector<std::filesystem::path> solver_folders() {
  std::istringstream list(GEODESIC_SOLVER_FOLDERS);
  std::vector<std::filesystem::path> folders;
  for (std::string folder; std::getline(list, folder, '|');) folders.emplace_back(folder);
  return folders;
}

std::string sources_of(const std::filesystem::path& folder) {
  std::ostringstream text;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".cpp" || extension == ".h") text << std::ifstream(entry.path()).rdbuf();
  }
  return text.str();
}

std::set<std::string> registered_in(const std::filesystem::path& folder) {
  const std::string text = sources_of(folder);
  std::set<std::string> names;
  for (const std::string& name : solver_names()) {
    if (text.find('"' + name + '"') != std::string::npos) names.insert(name);
  }
  return names;
}

TEST(Registry, has_a_solver_from_every_folder) {
  ASSERT_FALSE(solver_folders().empty());
  for (const auto& folder : solver_folders()) {
    EXPECT_FALSE(registered_in(folder).empty()) << "no solver is registered by " << folder;
  }
}

TEST(Registry, has_no_solver_from_elsewhere) {
  std::set<std::string> found;
  for (const auto& folder : solver_folders()) found.merge(registered_in(folder));
  for (const std::string& name : solver_names()) {
    EXPECT_TRUE(found.contains(name)) << "no folder of solvers/ names " << name;
  }
}

TEST(Registry, lists_solvers_by_name_and_finds_each) {
  const std::vector<std::string> names = solver_names();
  EXPECT_TRUE(std::ranges::is_sorted(names));
  for (const Description* description : registered_solvers()) {
    EXPECT_EQ(find_solver(description->name), description);
  }
}

TEST(Registry, refuses_a_name_that_is_taken) {
  const Description* taken = registered_solvers().at(0);
  EXPECT_THROW(register_solver(*taken, nullptr), std::logic_error);
  EXPECT_EQ(find_solver(taken->name), taken);
}

TEST(Registry, refuses_another_contract_and_reads_nothing_else) {
  try {
    geodesic_register_solver("contract 0 (old)", nullptr, nullptr);
    FAIL() << "a solver of another contract was registered";
  } catch (const std::logic_error& error) {
    const std::string why = error.what();
    EXPECT_NE(why.find("contract 0 (old)"), std::string::npos) << why;
    EXPECT_NE(why.find(compiled_contract()), std::string::npos) << why;
  }
}

TEST(Registry, throws_nothing_while_registrations_are_collected) {
  const Registrations registrations =
      collect_registrations([] { geodesic_register_solver("contract 0", nullptr, nullptr); });
  EXPECT_TRUE(registrations.added.empty());
  EXPECT_EQ(registrations.refused.size(), 1U);
  EXPECT_THROW(geodesic_register_solver("contract 0", nullptr, nullptr), std::logic_error);
}

TEST(Registry, names_the_known_solvers_when_asked_for_an_unknown_one) {
  const Mesh mesh(TriangleSoup{});
  EXPECT_EQ(find_solver("no-such-solver"), nullptr);
  try {
    make_solver("no-such-solver", mesh);
    FAIL() << "an unknown solver was made";
  } catch (const std::invalid_argument& error) {
    for (const std::string& name : solver_names()) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

class Descriptions : public SolverTest {};

TEST_P(Descriptions, are_complete) {
  const Description& d = description();
  EXPECT_EQ(d.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos);
  EXPECT_FALSE(d.family.empty());
  EXPECT_FALSE(d.paper.empty());
}

FOR_EVERY_SOLVER(Descriptions);

}  // namespace
}  // namespace geodesic::harness
