// differential: the exact solvers against each other on random meshes.
#include <CLI/CLI.hpp>
#include <iostream>

#include "tests/differential/perturb.h"

int main(int argc, char** argv) {
  geodesic::differential::Request request;
  request.out = "differential-failures";
  CLI::App app(
      "compare the exact solvers on random meshes; exit code 0: they agree, 1: they do "
      "not, 2: a bad request");
  app.add_option("--meshes", request.meshes, "how many")->capture_default_str();
  app.add_option("--seed", request.seed, "of the meshes")->capture_default_str();
  app.add_option("--only", request.only, "this one of the seed's meshes alone");
  app.add_option("--jobs", request.jobs, "meshes at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--solvers", request.solvers,
                 "names; without, every one that promises something of its distances")
      ->delimiter(',');
  app.add_option("--out", request.out, "folder for failing meshes")->capture_default_str();
  app.add_option("--shrink", request.shrink, "seconds spent on making one smaller")
      ->capture_default_str();
  unsigned times = 0;
  app.add_option("--perturb", times,
                 "compare no solvers, but move coordinates so many times by their rounding and say "
                 "how far the right distances move")
      ->check(CLI::Range(1, 10000))
      ->excludes(app.get_option("--only"))
      ->excludes(app.get_option("--jobs"))
      ->excludes(app.get_option("--solvers"))
      ->excludes(app.get_option("--out"))
      ->excludes(app.get_option("--shrink"));
  constexpr int kDisagree = 1, kBadRequest = 2;
  try {
    app.parse(argc, argv);
    if (times > 0) {
      geodesic::differential::perturb(request, times, std::cout);
      return 0;
    }
    return geodesic::differential::run_differential(request, std::cout) ? 0 : kDisagree;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadRequest;
  } catch (const std::exception& error) {
    std::cerr << "differential: " << error.what() << '\n';
    return kBadRequest;
  }
}
