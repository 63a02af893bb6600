// Solvers with parameters in their names: canonical names, refused values, and threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "solvers/core/registry.h"
#include "tests/message_of.h"

namespace geodesic {
namespace {

// A solver whose distances are its parameters.
class Dial final : public Solver {
 public:
  Dial(const Mesh& mesh, const Description& description)
      : Solver(mesh, description),
        lambda_(description.real("lambda")),
        depth_(description.integer("depth")),
        fast_(description.text("order") == "fast") {}

 private:
  void run(const Start&, std::span<double> distances) override {
    std::ranges::fill(distances, lambda_ + depth_ + (fast_ ? 1000 : 0));
  }
  const double lambda_;
  const Index depth_;
  const bool fast_;
};

Description dial() {
  return {.name = "dial",
          .family = "test-only",
          .paper = "none",
          .exactness = Exactness::bounded,
          .error_bound = [](const Description& d) { return d.real("lambda") / 100; },
          .parameters = {real_parameter("lambda", 8, 0, 64, "how wide"),
                         integer_parameter("depth", 2, 1, 9, "how deep"),
                         choice_parameter("order", {"safe", "fast"}, "which first"),
                         integer_parameter("threads", 1, 1, 64, "threads of a solve")}};
}

const RegisterSolver<Dial> registered{dial()};

const Mesh& one_triangle() {
  static const Mesh mesh(TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  return mesh;
}

double answer_of(std::string_view name) {
  std::vector<double> distances(3);
  make_solver(name, one_triangle())->solve({.sources = {{0}}}, distances);
  return distances[0];
}

TEST(ConfiguredSolver, has_one_canonical_name_however_it_is_written) {
  const std::pair<const char*, const char*> names[] = {
      {"dial", "dial"},
      {"dial?lambda=8", "dial"},
      {"dial?lambda=8.0&depth=02", "dial"},
      {"dial?lambda=32.0", "dial?lambda=32"},
      {"dial?lambda=3.2e1", "dial?lambda=32"},
      {"dial?lambda=0.00001", "dial?lambda=1e-5"},
      {"dial?lambda=-0", "dial?lambda=0"},
      {"dial?order=fast&depth=3&lambda=0.5", "dial?lambda=0.5&depth=3&order=fast"},
  };
  for (const auto& [written, canonical] : names) {
    const Description& found = solver_named(written);
    EXPECT_EQ(found.name, canonical) << written;
    EXPECT_EQ(&found, find_solver(canonical)) << "two descriptions of " << canonical;
  }
  EXPECT_EQ(base_name("dial?lambda=32"), "dial");
  EXPECT_EQ(base_name("dial"), "dial");
}

TEST(ConfiguredSolver, solves_with_its_values_and_defaults) {
  EXPECT_EQ(answer_of("dial"), 10);
  EXPECT_EQ(answer_of("dial?lambda=0.25"), 2.25);
  EXPECT_EQ(answer_of("dial?order=fast&depth=9"), 1017);
}

TEST(ConfiguredSolver, describes_itself_by_its_values) {
  const Description& found = solver_named("dial?lambda=32&threads=4");
  EXPECT_EQ(found.error_bound(found), 0.32);
  EXPECT_EQ(found.thread_count(), 4);
  EXPECT_EQ(solver_named("dial").thread_count(), 1);
  EXPECT_THROW(found.real("no-such-parameter"), std::out_of_range);
}

TEST(ConfiguredSolver, is_not_listed_beside_the_registered_one) {
  solver_named("dial?lambda=7");
  const std::vector<const Description*> all = registered_solvers();
  EXPECT_EQ(
      std::ranges::count(all, "dial", [](const Description* d) { return base_name(d->name); }), 1);
}

TEST(ConfiguredSolver, refuses_what_it_does_not_understand_in_one_line_that_says_what_is_valid) {
  const std::pair<const char*, std::vector<const char*>> refused[] = {
      {"dail?lambda=3", {"no solver named 'dail'", "did you mean 'dial'?"}},
      {"dial?lamda=3", {"dial: no parameter named 'lamda'", "did you mean 'lambda'?", "depth"}},
      {"dial?lambda=65", {"dial: parameter lambda is '65'", "a number from 0 to 64"}},
      {"dial?lambda=nan", {"dial: parameter lambda is 'nan'", "a number from 0 to 64"}},
      {"dial?depth=2.5", {"dial: parameter depth is '2.5'", "an integer from 1 to 9"}},
      {"dial?order=slow", {"dial: parameter order is 'slow'", "one of safe, fast"}},
      {"dial?lambda", {"dial: 'lambda' in 'dial?lambda' is not a parameter with a value"}},
      {"dial?", {"dial: '' in 'dial?' is not a parameter with a value"}},
      {"dial?depth=2&", {"is not a parameter with a value"}},
      {"dial?depth=2&depth=3", {"dial: parameter depth is given twice"}},
  };
  for (const auto& [name, words] : refused) {
    const std::string message =
        message_of<std::invalid_argument>([&asked = name] { make_solver(asked, one_triangle()); });
    for (const char* word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

// Also a test for the thread sanitizer (preset thread).
TEST(ConfiguredSolver, threads_may_ask_for_any_values_at_the_same_time) {
  constexpr std::size_t kThreads = 8, kValues = 40;
  std::vector<std::set<const Description*>> found(kThreads);
  std::vector<int> wrong(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < kThreads; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = 0; i < kValues; ++i) {
          const std::size_t lambda = 20 + (i + 5 * t) % kValues;
          const std::string name = "dial?lambda=" + std::to_string(lambda);
          found[t].insert(find_solver(name));
          wrong[t] += answer_of(name) != static_cast<double>(lambda + 2) ? 1 : 0;
        }
      });
    }
  }
  for (std::size_t t = 0; t < kThreads; ++t) {
    EXPECT_EQ(wrong[t], 0);
    EXPECT_EQ(found[t], found[0]) << "threads have descriptions of their own";
    EXPECT_EQ(found[t].size(), kValues);
  }
}

TEST(Registration, refuses_a_description_that_cannot_be_used) {
  const auto refuse = [](const std::function<void(Description&)>& spoil, const std::string& words) {
    Description description = dial();
    description.name = "another-dial";
    spoil(description);
    const std::string message =
        message_of<std::logic_error>([&] { register_solver(description, nullptr); });
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_EQ(find_solver("another-dial"), nullptr);
  };
  refuse([](Description& d) { d.error_bound = nullptr; }, "declares no error_bound");
  refuse([](Description& d) { d.parameters[0].default_value = 99; }, "a number from 0 to 64");
  refuse([](Description& d) { d.parameters[0].name = "La mbda"; }, "is not a word");
  refuse([](Description& d) { d.parameters[2].choices[0] = "a&b"; }, "has the choice 'a&b'");
  refuse([](Description& d) { d.parameters[0].kind = ParameterKind::file; },
         "neither a number nor a choice");
}

// A solver that counts its renewals.
class Renewed final : public Solver {
 public:
  Renewed(const Mesh& mesh, const Description& description) : Solver(mesh, description) {}
  int renewals = 0;

 private:
  void run(const Start&, std::span<double>) override {}
  void renew_state() override { ++renewals; }
};

TEST(Renewal, comes_once_before_every_further_solve_of_a_solver_that_needs_it) {
  for (const bool needed : {true, false}) {
    Description description = dial();
    description.needs_renewal = needed;
    Renewed solver(one_triangle(), description);
    std::vector<double> distances(3);
    const auto solve = [&] { solver.solve({.sources = {{0}}}, distances); };
    solver.renew();
    solve();
    EXPECT_EQ(solver.renewals, 0) << "a new object was renewed";
    solve();
    EXPECT_EQ(solver.renewals, needed ? 1 : 0);
    solver.renew();
    solve();
    EXPECT_EQ(solver.renewals, needed ? 2 : 0) << "renewed again, or not, by solve";
  }
}

}  // namespace
}  // namespace geodesic
