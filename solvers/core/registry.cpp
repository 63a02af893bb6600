#include "solvers/core/registry.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

#include "solvers/core/messages.h"

namespace geodesic {
namespace {

struct Entry {
  Description description;
  SolverFactory factory;
};

// A map: descriptions keep their address, and solvers are listed by name whatever the link order.
// It changes only while solvers register, before any is looked up. It is never destroyed, because
// threads may solve until the process ends.
std::map<std::string, Entry, std::less<>>& entries() {
  static auto& map = *new std::map<std::string, Entry, std::less<>>;
  return map;
}

constinit Registrations* collected = nullptr;  // by collect_registrations, while it runs

// Descriptions of configured solvers, by canonical name. They are kept like registered ones,
// because solvers refer to them.
class Configured {
 public:
  const Description& keep(const Description& description) {
    const std::lock_guard lock(mutex_);
    return by_name_.try_emplace(description.name, description).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, Description> by_name_;
};

Configured& configured() {
  static auto& all = *new Configured;
  return all;
}

bool is_word(std::string_view text, std::string_view characters) {
  return !text.empty() && text.find_first_not_of(characters) == std::string_view::npos;
}

// Parameter names are part of solver names, and these are part of commands and file names.
void check_description(const Description& solver) {
  constexpr std::string_view kName = "abcdefghijklmnopqrstuvwxyz0123456789-";
  constexpr std::string_view kChoice = "abcdefghijklmnopqrstuvwxyz0123456789-_.";
  const auto check = [&](bool holds, const std::string& what) {
    if (!holds) throw std::logic_error(solver.name + ": " + what);
  };
  for (const ParameterDescription& parameter : solver.parameters) {
    check(is_word(parameter.name, kName),
          "parameter '" + parameter.name + "' is not a word of lower-case letters, digits and '-'");
    check(parameter.is_number() || parameter.kind == ParameterKind::choice,
          "parameter " + parameter.name + " is neither a number nor a choice");
    for (const std::string& choice : parameter.choices) {
      check(is_word(choice, kChoice), "parameter " + parameter.name + " has the choice '" + choice +
                                          "': use lower-case letters, digits, '-', '_' and '.'");
    }
  }
  try {
    const CheckedParameters defaults(solver.name, solver.parameters, {});
  } catch (const std::invalid_argument& error) {
    throw std::logic_error(error.what());
  }
  check(solver.exactness != Exactness::bounded || solver.error_bound != nullptr,
        "is bounded and declares no error_bound");
}

// The values in "avtp?lambda=32&threads=2", as written.
ParameterValues values_in(const Description& solver, std::string_view name) {
  ParameterValues values;
  std::string_view rest = name.substr(solver.name.size() + 1);
  for (bool last = false; !last;) {
    const std::size_t end = rest.find('&');
    const std::string_view word = rest.substr(0, end);
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos) {
      throw std::invalid_argument(solver.name + ": '" + excerpt(word) + "' in '" + excerpt(name) +
                                  "' is not a parameter with a value: write " + solver.name +
                                  "?PARAMETER=VALUE");
    }
    const std::string parameter(word.substr(0, equals));
    if (!values.emplace(parameter, std::string(word.substr(equals + 1))).second) {
      throw std::invalid_argument(solver.name + ": parameter " + excerpt(parameter) +
                                  " is given twice in '" + excerpt(name) + "'");
    }
    last = end == std::string_view::npos;
    rest.remove_prefix(last ? rest.size() : end + 1);
  }
  return values;
}

Description configure(const Description& solver, const ParameterValues& given) {
  const CheckedParameters values(solver.name, solver.parameters, given);
  const CheckedParameters defaults(solver.name, solver.parameters, {});
  Description described = solver;
  for (const ParameterDescription& parameter : solver.parameters) {
    const std::string& value = values.text(parameter.name);
    if (value == defaults.text(parameter.name)) continue;
    described.name += (described.values.empty() ? '?' : '&') + parameter.name + '=' + value;
    described.values.emplace(parameter.name, value);
  }
  return described;
}

}  // namespace

void register_solver(Description description, SolverFactory factory) {
  check_description(description);
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

std::string_view base_name(std::string_view name) { return name.substr(0, name.find('?')); }

const Description* find_solver(std::string_view name) {
  const auto at = entries().find(base_name(name));
  if (at == entries().end()) return nullptr;
  const Description& solver = at->second.description;
  if (name == solver.name) return &solver;
  const Description described = configure(solver, values_in(solver, name));
  return described.values.empty() ? &solver : &configured().keep(described);
}

const Description& solver_named(std::string_view name) {
  if (const Description* solver = find_solver(name)) return *solver;
  std::vector<std::string> known;
  for (const auto& [other, entry] : entries()) known.push_back(other);
  throw std::invalid_argument(unknown_name("solver", base_name(name), known));
}

std::unique_ptr<Solver> make_solver(std::string_view name, const Mesh& mesh,
                                    PreparedReader* saved) {
  const Description& description = solver_named(name);
  if (saved != nullptr && !description.abilities.saves) {
    throw std::invalid_argument(description.name + ": has no preparation that was saved");
  }
  return entries().find(base_name(name))->second.factory(mesh, description, saved);
}

std::unique_ptr<Solver> Solver::another() const { return make_solver(description_.name, mesh_); }

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
