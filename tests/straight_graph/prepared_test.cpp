// What preparation gives beside distances: it is shared, saved and checked.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "meshes/generators/generators.h"
#include "solvers/core/prepared_file.h"
#include "tests/message_of.h"
#include "tests/solved.h"

namespace geodesic {
namespace {

constexpr const char* kChecked = "straight-graph?alpha=0.3&check=2";
constexpr const char* kDiscs = "saddle-vertex-graph?disc=20&check=2";

Mesh terrain(double columns = 30) {
  return Mesh(generate("terrain", {{"columns", columns}, {"rows", 20}}), Numbering::along_surface);
}

std::vector<double> distances_of(Solver& solver) {
  std::vector<double> distances(solver.mesh().vertex_count());
  solver.solve({.sources = {{Index{7}}}}, distances);
  return distances;
}

std::string saved(const Solver& solver) {
  std::ostringstream file;
  save_prepared(solver, file);
  return file.str();
}

std::string refusal(const std::string& file, const Mesh& mesh) {
  std::istringstream stream(file);
  return message_of<std::invalid_argument>([&] { read_prepared(mesh, stream); });
}

TEST(Preparation, is_shared_by_another_object_with_the_same_distances) {
  const Mesh mesh = terrain();
  for (const char* name : {kChecked, kDiscs}) {
    const auto first = make_solver(name, mesh);
    const auto other = first->another();
    EXPECT_EQ(distances_of(*first), distances_of(*other));
    EXPECT_EQ(other->certificate()->largest_error, first->certificate()->largest_error);
  }
}

TEST(Preparation, that_was_saved_gives_the_same_distances_and_certificate) {
  const Mesh mesh = terrain();
  for (const char* name : {kChecked, kDiscs}) {
    const auto solver = make_solver(name, mesh);
    std::istringstream file(saved(*solver));
    const auto read = read_prepared(mesh, file);
    EXPECT_EQ(read->description().name, solver->description().name);
    EXPECT_EQ(distances_of(*read), distances_of(*solver));
    EXPECT_EQ(read->certificate()->mean_error, solver->certificate()->mean_error);
    EXPECT_EQ(saved(*read), saved(*solver));
  }
}

TEST(Preparation, of_large_arrays_has_the_sum_with_which_it_was_written) {
  std::ostringstream to;
  PreparedWriter writer(to);
  writer.write(std::span<const Index>(std::vector<Index>(3'000'001, 7)));  // is read in pieces
  writer.write_one(1.5);
  std::istringstream from(to.str());
  PreparedReader reader(from);
  EXPECT_EQ(reader.read<Index>().size(), 3'000'001u);
  EXPECT_EQ(reader.read_one<double>(), 1.5);
  EXPECT_EQ(reader.sum(), writer.sum());
}

TEST(Preparation, is_certified_by_as_many_sources_as_requested) {
  const Mesh mesh = terrain();
  EXPECT_FALSE(make_solver("straight-graph", mesh)->certificate());
  const auto found = make_solver(kChecked, mesh)->certificate();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->sources, 2);
  EXPECT_GT(found->mean_error, 0);
  EXPECT_GT(found->largest_error, found->mean_error);
  EXPECT_LT(found->largest_error, 0.1);
}

TEST(Preparation, of_another_mesh_is_refused) {
  const Mesh mesh = terrain(), other = terrain(31);
  EXPECT_EQ(refusal(saved(*make_solver(kChecked, mesh)), other),
            "the preparation is of another mesh");
}

TEST(Preparation, that_is_none_or_of_another_format_is_refused) {
  const Mesh mesh = terrain();
  std::string file = saved(*make_solver("straight-graph", mesh));
  EXPECT_EQ(refusal("solid cube\n", mesh), "this is not the preparation of a solver");
  EXPECT_EQ(refusal("", mesh), "this is not the preparation of a solver");
  file.replace(file.find('\n') - 1, 1, "0");
  EXPECT_EQ(refusal(file, mesh),
            "the preparation has format 0, and this program reads 1: prepare again");
}

TEST(Preparation, of_a_solver_that_prepares_nothing_is_refused) {
  const Mesh mesh = terrain();
  EXPECT_EQ(message_of<std::invalid_argument>([&] { saved(*make_solver("mmp", mesh)); }),
            "mmp: has no preparation that could be saved");
}

TEST(Preparation, that_ends_anywhere_is_refused) {
  const Mesh mesh = terrain();
  const std::string file = saved(*make_solver("straight-graph", mesh));
  for (std::size_t end = file.find('\n') + 1; end < file.size(); end += 1 + file.size() / 97) {
    EXPECT_NE(refusal(file.substr(0, end), mesh), "nothing was thrown") << end;
  }
}

// A file is read without trust: a wrong byte may lead nowhere out of memory.
TEST(Preparation, with_a_changed_byte_is_refused) {
  const Mesh mesh = terrain();
  const std::string file = saved(*make_solver("straight-graph", mesh));
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < 400; ++i) {
    std::string changed = file;
    char& c = changed[i < 100 ? i : random() % file.size()];
    c = static_cast<char>(c ^ (1 << random() % 8));
    EXPECT_NE(refusal(changed, mesh), "nothing was thrown");
  }
}

}  // namespace
}  // namespace geodesic
