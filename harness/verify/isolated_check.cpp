#include "harness/verify/isolated_check.h"

#include <algorithm>
#include <fstream>

#include "harness/base/available_memory.h"
#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/process.h"
#include "harness/corpus/solvers.h"
#include "harness/verify/explain.h"
#include "meshes/mesh_file.h"
#include "meshes/messages.h"

namespace geodesic::harness {

struct CheckTask {
  std::string solver, property, vectors;
  std::string mesh_file = {};       // empty: the property's own cases
  std::vector<Query> queries = {};  // on the mesh file
  double least_distance = 0;        // Tolerance::least on the mesh file
  bool explain = false;             // whether to explain a failure on the mesh file
  std::string result_file;
};
GEODESIC_JSON_MEMBERS(CheckTask, solver, property, vectors, mesh_file, queries, least_distance,
                      explain, result_file)

namespace {

// Checks the cases one by one. Before each step, it writes the result that is valid if the process
// ends during that step.
class CheckProcess {
 public:
  explicit CheckProcess(const CheckTask& task)
      : task_(task), solver_(solver_named(task.solver)), property_(property_named(task.property)) {}

  void run() const {
    const std::vector<Case> cases = all_cases();
    CheckResult result{
        .outcome = CheckOutcome::not_claimed,
        .what = "is limited to " + std::to_string(solver_.abilities.max_vertices) + " vertices"};
    // The worst result of all cases. One that holds outweighs those that do not concern the solver.
    for (std::size_t i = 0; i < cases.size() && !result.failed(); ++i) {
      if (too_large(cases[i], solver_)) continue;
      const CheckResult next = check(cases[i], i);
      if (next.outcome >= result.outcome) result = next;
    }
    write(result);
  }

 private:
  std::vector<Case> all_cases() const {
    if (task_.mesh_file.empty()) return property_.cases();
    Case given{.mesh = task_.mesh_file,
               .soup = read_mesh_file(task_.mesh_file).soup,
               .queries = task_.queries,
               .tolerance = {.least = task_.least_distance}};
    if ((property_.needs & kNonManifoldEdges) != 0) {
      given.non_manifold_edges = NonManifoldEdges::crossed;
    }
    return {given};
  }

  CheckResult check(const Case& given, std::size_t at_case) const {
    LocalReference::watch = [&](const std::string& reference) {
      CheckResult result{.at_case = at_case};  // crashed: in the solver
      if (!reference.empty()) {
        result.outcome = CheckOutcome::not_known;
        result.what = "the reference, " + reference + ',';
      }
      write(result);
    };
    LocalReference::watch("");
    try {
      const Finding finding = check_case(property_, solver_, given);
      LocalReference::watch = nullptr;
      return finding ? explained(given, *finding, at_case) : sound(given.build());
    } catch (const NothingCompared& error) {
      return {.outcome = CheckOutcome::not_claimed, .what = error.what(), .at_case = at_case};
    } catch (const NoReference& error) {
      return {.outcome = CheckOutcome::not_known, .what = error.what(), .at_case = at_case};
    }
  }

  // If the solver rightly refuses a user's mesh, the property was not checked.
  CheckResult sound(const Mesh& mesh) const {
    const std::string why = unsupported(solver_, mesh);
    if (task_.mesh_file.empty() || why.empty()) return {.outcome = CheckOutcome::holds};
    return {.outcome = CheckOutcome::not_claimed, .what = "refuses the mesh: " + why};
  }

  CheckResult explained(const Case& given, const Violation& violation, std::size_t at_case) const {
    CheckResult result{.outcome = CheckOutcome::wrong,
                       .what = violation.what,
                       .kind = violation.kind,
                       .at_case = at_case,
                       .query = violation.query};
    if (!task_.explain) return result;
    write(result);  // the solver runs again and may crash or never end
    result.explanation = explain_violation(solver_, given, violation);
    return result;
  }

  // Messages of solvers may not be UTF-8.
  void write(const CheckResult& result) const {
    write_bytes(task_.result_file,
                Json(result).dump(-1, ' ', false, Json::error_handler_t::replace));
  }

  const CheckTask& task_;
  const Description& solver_;
  const Property& property_;
};

CheckResult wait_for(const CheckTask& task, double seconds) {
  std::filesystem::remove(task.result_file);
  const Ended ended = run_geodesic_bench({"check-property", Json(task).dump()}, [] {},
                                         {.seconds = seconds, .memory_bytes = available_memory()});
  CheckResult result;
  if (std::filesystem::exists(task.result_file)) {
    result = Json::parse(std::ifstream(task.result_file)).get<CheckResult>();
  }
  if (result.outcome == CheckOutcome::wrong) return result;  // even if the explanation failed
  if (ended.succeeded() && result.outcome != CheckOutcome::crashed) return result;
  const CheckResult end = without_result(ended, ended.timed_out, seconds);
  if (result.outcome == CheckOutcome::not_known) {
    result.what += ' ' + end.what;
    return result;
  }
  result.outcome = end.outcome;
  result.what = end.what;
  result.kind = end.kind;
  return result;
}

}  // namespace

CheckResult without_result(const Ended& ended, bool timed_out, double seconds) {
  if (timed_out) {
    return {.outcome = CheckOutcome::timed_out,
            .what = "did not end within " + significant(seconds, 6) + " s"};
  }
  return {.outcome = CheckOutcome::crashed,
          .what = "ended the process: " + ended.describe(),
          .kind = (ended.crashed ? "signal " : "exit code ") + std::to_string(ended.code)};
}

void run_isolated_check(const std::string& task_json) {
  const auto task = Json::parse(task_json).get<CheckTask>();
  set_instruction_set(instruction_set_named(task.vectors));
  CheckProcess(task).run();
}

CheckResult IsolatedCheck::on_own_cases(const Property& property) const {
  const std::string missing = unclaimed(property, solver_);
  if (!missing.empty()) return {.outcome = CheckOutcome::not_claimed, .what = missing};
  return wait_for({.solver = solver_.name,
                   .property = property.name,
                   .vectors = vectors_,
                   .result_file = folder_ / "result.json"},
                  time_limit_);
}

CheckResult IsolatedCheck::on_case(const Property& property, const Case& given, double seconds,
                                   bool explain) const {
  const std::string missing = unclaimed(property, solver_);
  if (!missing.empty()) return {.outcome = CheckOutcome::not_claimed, .what = missing};
  const std::filesystem::path mesh_file = folder_ / "case.obj";
  write_bytes(mesh_file, mesh_bytes(given.soup, mesh_file));
  return wait_for({.solver = solver_.name,
                   .property = property.name,
                   .vectors = vectors_,
                   .mesh_file = mesh_file,
                   .queries = given.queries,
                   .least_distance = given.tolerance.least,
                   .explain = explain,
                   .result_file = folder_ / "result.json"},
                  std::min(seconds, time_limit_));
}

}  // namespace geodesic::harness
