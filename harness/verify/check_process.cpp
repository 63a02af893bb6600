#include "harness/verify/check_process.h"

#include <sys/time.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "harness/corpus/solvers.h"
#include "harness/verify/explain.h"
#include "harness/verify/saved_case.h"
#include "meshes/oracles/random_case.h"

namespace geodesic::harness {
namespace {

// Ends the process by SIGALRM. @param seconds 0: not any more
void end_after(double seconds) {
  const double whole = std::floor(std::min(seconds, 1e9));
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>((std::min(seconds, 1e9) - whole) * 1e6);
  setitimer(ITIMER_REAL, &timer, nullptr);
}

class CheckProcess {
 public:
  explicit CheckProcess(const CheckTask& task) : task_(task), log_(task.log) {
    LocalReference::watch = [this](const std::string& name) { write({{"reference", name}}); };
  }
  ~CheckProcess() { LocalReference::watch = nullptr; }
  CheckProcess(const CheckProcess&) = delete;
  CheckProcess& operator=(const CheckProcess&) = delete;

  void run() {
    for (std::size_t i = 0; i < task_.asks.size(); ++i) {
      const Ask& ask = task_.asks[i];
      if (ask.random) make(*ask.random);
      write({{"ask", i}, {"kind", kind_}});
      end_after(ask.seconds);
      check(ask);
      end_after(0);
    }
  }

 private:
  void check(const Ask& ask) {
    const Property& property = property_named(ask.property);
    const Description& solver = solver_named(ask.solver);
    if (const std::string missing = unclaimed(property, solver); !missing.empty()) {
      return end({.what = missing});
    }
    if (ask.random) return end(check_on(property, solver, *random_case_));
    if (ask.file.empty()) return end(worst_of(property, solver));
    const Case given = read_case(ask.file).given;
    Finding finding;
    CheckResult result = check_on(property, solver, given, &finding);
    if (result.outcome == CheckOutcome::holds) {
      const std::string refuses = unsupported(solver, given.build());
      // Rightly: the property was not checked.
      if (!refuses.empty()) result = {.what = "refuses the mesh: " + refuses};
    }
    end(result);
    if (!finding || !ask.explain) return;
    // The solver runs again and may crash or never end.
    write({{"explanation", explain_violation(solver, given, *finding)}});
  }

  // The worst result of the property's own cases. One that holds outweighs those that do not
  // concern the solver.
  CheckResult worst_of(const Property& property, const Description& solver) {
    const std::vector<Case> cases = property.cases();
    CheckResult worst = too_many_vertices(solver);
    for (std::size_t i = 0; i < cases.size() && !worst.failed(); ++i) {
      if (too_large(cases[i], solver)) continue;
      write({{"case", i}});
      CheckResult next = check_on(property, solver, cases[i]);
      next.at_case = i;
      if (next.outcome >= worst.outcome) worst = next;
    }
    return worst;
  }

  static CheckResult too_many_vertices(const Description& solver) {
    return {.what = "is limited to " + std::to_string(solver.abilities.max_vertices) + " vertices"};
  }

  static CheckResult check_on(const Property& property, const Description& solver,
                              const Case& given, Finding* finding = nullptr) {
    if (too_large(given, solver)) return too_many_vertices(solver);
    CheckResult result{.outcome = CheckOutcome::holds};
    try {
      const Finding found = check_case(property, solver, given, &result.largest_error);
      if (finding != nullptr) *finding = found;
      if (!found) return result;
      result.outcome = CheckOutcome::wrong;
      result.what = found->what;
      result.kind = found->kind;
      result.query = found->query;
    } catch (const NothingCompared& error) {
      result = {.what = error.what()};
    } catch (const NoReference& error) {
      result = {.outcome = CheckOutcome::not_known, .what = error.what()};
    }
    return result;
  }

  void make(const RandomNumber& random) {
    if (random_ == random) return;
    random_case_ = random_mesh_case(random, task_.scratch);
    kind_ = static_cast<std::size_t>(kind_of(random_case_->build()));
    random_ = random;
  }

  void end(const CheckResult& result) { write({{"result", result}}); }

  // Messages of solvers may not be UTF-8.
  void write(const Json& line) {
    log_ << line.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
  }

  const CheckTask& task_;
  std::ofstream log_;
  std::optional<RandomNumber> random_;  // of random_case_
  std::optional<Case> random_case_;
  std::size_t kind_ = 0;  // of it
};

}  // namespace

void run_checks(const std::filesystem::path& file) {
  const auto task = read_json(file).get<CheckTask>();
  set_instruction_set(instruction_set_named(task.vectors));
  CheckProcess(task).run();
}

}  // namespace geodesic::harness
