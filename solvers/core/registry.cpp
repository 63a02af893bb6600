#include "solvers/core/registry.h"

#include <map>
#include <stdexcept>

#include "solvers/core/rescaled.h"
#include "solvers/core/unit.h"

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

constinit Registrations* collected = nullptr;  // by collect_registrations, while it runs

}  // namespace

void register_solver(Description description, SolverFactory factory) {
  std::string name = description.name;
  const auto [at, added] =
      entries().try_emplace(name, Entry{std::move(description), std::move(factory)});
  if (!added) {
    throw std::logic_error("two solvers are registered as '" + at->first +
                           "': give one of them another name");
  }
  if (collected != nullptr) collected->added.push_back(at->first);
}

Registrations collect_registrations(const std::function<void()>& load) {
  Registrations registrations;
  collected = &registrations;
  try {
    load();
  } catch (...) {
    collected = nullptr;
    throw;
  }
  collected = nullptr;
  return registrations;
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
  const auto& [description, factory] = at->second;
  const Unit unit = Unit::of(mesh.positions());
  if (!unit.is_one()) return make_rescaled(mesh, description, factory, unit);
  return factory(mesh, description);
}

}  // namespace geodesic

void geodesic_register_solver(const char* contract, void* description, void* factory) {
  using namespace geodesic;
  try {
    const std::string own = compiled_contract();
    if (contract != own) {
      throw std::logic_error("built against " + std::string(contract) +
                             ", while this program has " + own +
                             ": build it again against this program's package");
    }
    register_solver(std::move(*static_cast<Description*>(description)),
                    std::move(*static_cast<SolverFactory*>(factory)));
  } catch (const std::exception& error) {
    if (collected == nullptr) throw;
    collected->refused.emplace_back(error.what());
  }
}
