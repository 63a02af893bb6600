#include "solvers/registry.h"

#include <map>
#include <stdexcept>

namespace geodesic {
namespace {

struct Entry {
  Description description;
  SolverFactory factory;
};

// A map: descriptions keep their address, and solvers are listed by name whatever the link order.
std::map<std::string, Entry, std::less<>>& entries() {
  static std::map<std::string, Entry, std::less<>> map;
  return map;
}

}  // namespace

void register_solver(Description description, SolverFactory factory) {
  std::string name = description.name;
  const auto [at, added] =
      entries().try_emplace(name, Entry{std::move(description), std::move(factory)});
  if (!added) throw std::logic_error("two solvers are registered as '" + at->first + "'");
}

std::vector<const Description*> registered_solvers() {
  std::vector<const Description*> all;
  for (const auto& [name, entry] : entries()) all.push_back(&entry.description);
  return all;
}

const Description* find_solver(std::string_view name) {
  const auto at = entries().find(name);
  return at == entries().end() ? nullptr : &at->second.description;
}

std::unique_ptr<Solver> make_solver(std::string_view name, const Mesh& mesh) {
  const auto at = entries().find(name);
  if (at == entries().end()) {
    std::string known;
    for (const auto& [other, entry] : entries()) known += (known.empty() ? "" : ", ") + other;
    throw std::invalid_argument("no solver named '" + std::string(name) + "'; there are: " + known);
  }
  return at->second.factory(mesh, at->second.description);
}

}  // namespace geodesic
