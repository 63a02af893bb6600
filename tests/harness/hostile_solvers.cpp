// Solvers that a process cannot survive, or that will not let it end.
#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <list>
#include <vector>

#include "solvers/core/registry.h"

namespace geodesic {
namespace {

class Hostile : public Solver {
 public:
  Hostile(const Mesh& mesh, const Description& description) : Solver(mesh, description) {}
};

// A page and more in every call, used afterwards, so that no compiler makes a loop of it.
int deeper(int depth, const volatile bool& on) {
  volatile char page[5000];
  page[depth % 5000] = 1;
  return on ? deeper(depth + 1, on) + page[depth % 5000] : 0;
}

class StackOverflow final : public Hostile {
  using Hostile::Hostile;
  void run(const Query&, std::span<double> distances, Recording*) override {
    const volatile bool for_ever = true;
    distances[0] = deeper(0, for_ever);
  }
};

constexpr std::size_t kBlock = std::size_t{16} << 20;

class Hungry final : public Hostile {
  using Hostile::Hostile;
  void run(const Query&, std::span<double>, Recording*) override {
    for (std::list<std::vector<char>> blocks;;) blocks.emplace_back(kBlock, 'x');
  }
};

// Does not look whether it got what it asked for.
class HungryAndBlind final : public Hostile {
  using Hostile::Hostile;
  void run(const Query&, std::span<double>, Recording*) override {
    for (;;) {
      void* volatile block = std::malloc(kBlock);  // volatile: or nobody would miss it
      std::memset(block, 'x', kBlock);
    }
  }
};

// More than any pipe holds, on both outputs.
class Talkative final : public Hostile {
  using Hostile::Hostile;
  void run(const Query&, std::span<double>, Recording*) override {
    const std::string line(1000, 'x');
    for (int i = 0; i < 10'000; ++i) {
      std::cout << line << '\n';
      std::cerr << line << '\n';
    }
    std::cerr << "the \033[31mlast\377 words" << std::endl;
    std::abort();
  }
};

class Chatterbox final : public Hostile {
  using Hostile::Hostile;
  void run(const Query&, std::span<double>, Recording*) override {
    for (;;) std::cerr << "and another thing" << std::endl;
  }
};

// Ends, and leaves a process that holds its standard error and would live on.
class Parent final : public Hostile {
  using Hostile::Hostile;
  void run(const Query&, std::span<double>, Recording*) override {
    if (fork() == 0) {
      for (;;) pause();
    }
    throw 7;
  }
};

class Deaf final : public Hostile {
  using Hostile::Hostile;
  void run(const Query&, std::span<double>, Recording*) override {
    for (const int each : {SIGINT, SIGTERM, SIGHUP}) signal(each, SIG_IGN);
    for (;;) pause();
  }
};

Description hostile(const char* name) {
  return {.name = name, .family = "test-only", .paper = "none", .by_name_only = true};
}

const RegisterSolver<StackOverflow> stack_overflow{hostile("stack-overflow")};
const RegisterSolver<Hungry> hungry{hostile("hungry")};
const RegisterSolver<HungryAndBlind> hungry_and_blind{hostile("hungry-and-blind")};
const RegisterSolver<Talkative> talkative{hostile("talkative")};
const RegisterSolver<Chatterbox> chatterbox{hostile("chatterbox")};
const RegisterSolver<Parent> parent{hostile("parent")};
const RegisterSolver<Deaf> deaf{hostile("deaf")};

}  // namespace
}  // namespace geodesic
