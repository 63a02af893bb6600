#include "harness/verify/examine.h"

#include <algorithm>
#include <cstdlib>

#include "harness/base/error.h"
#include "harness/base/files.h"
#include "harness/base/json.h"
#include "harness/base/process.h"
#include "harness/corpus/solvers.h"
#include "harness/corpus/vectors.h"
#include "harness/verify/explain.h"
#include "meshes/mesh_file.h"
#include "meshes/messages.h"

namespace geodesic::conformance {
namespace {

using harness::Json;

// The process's side: checks case by case, and writes down before each step what it is to be called
// when it does not come back from it.
class Examination {
 public:
  explicit Examination(const ExaminationSpec& spec)
      : spec_(spec),
        solver_(harness::solver_named(spec.solver)),
        property_(*find_property(spec.property)) {}

  void run() const {
    const std::vector<Case> cases = all_cases();
    Report report{.outcome = Outcome::unclaimed,
                  .what = "is meant for at most " + std::to_string(solver_.abilities.max_vertices) +
                          " vertices"};
    for (std::size_t i = 0; i < cases.size() && !report.failed(); ++i) {
      if (!too_large(cases[i], solver_)) report = examine(cases[i], i);
    }
    write(report);
  }

 private:
  std::vector<Case> all_cases() const {
    if (spec_.mesh_file.empty()) return property_.cases();
    return {{.mesh = spec_.mesh_file,
             .soup = read_mesh(spec_.mesh_file).soup,
             .queries = spec_.queries}};
  }

  Report examine(Case given, std::size_t at_case) const {
    const Report in_solver{.outcome = Outcome::crashed, .at_case = at_case};
    const Mesh mesh(given.soup);
    Reference reference(solver_, mesh);
    if (!given.known) {
      given.known = [&](const Query& query) {
        write({.outcome = Outcome::unjudged,
               .what = "the reference, " + reference.name() + ',',
               .at_case = at_case});
        const auto distances = reference.distances(query);
        write(in_solver);
        return distances;
      };
    }
    write(in_solver);
    try {
      const Finding finding = check_case(property_, solver_, given);
      return finding ? explained(given, *finding, at_case) : sound(mesh);
    } catch (const NoReference& error) {
      return {.outcome = Outcome::unjudged, .what = error.what(), .at_case = at_case};
    }
  }

  // A mesh of the user that was rightly refused says nothing about the property.
  Report sound(const Mesh& mesh) const {
    const std::string unsupported = harness::unsupported(solver_, mesh);
    if (spec_.mesh_file.empty() || unsupported.empty()) return {.outcome = Outcome::holds};
    return {.outcome = Outcome::unclaimed, .what = "refuses the mesh: " + unsupported};
  }

  Report explained(const Case& given, const Failure& failure, std::size_t at_case) const {
    Report report{.outcome = Outcome::wrong,
                  .what = failure.what,
                  .kind = failure.kind,
                  .at_case = at_case,
                  .query = failure.query};
    if (!spec_.explain) return report;
    write(report);  // the solver runs again, and may not come back
    report.explanation = explain_failure(solver_, given, failure);
    return report;
  }

  // What solvers throw may be no UTF-8.
  void write(const Report& report) const {
    harness::write_bytes(spec_.report,
                         Json(report).dump(-1, ' ', false, Json::error_handler_t::replace));
  }

  const ExaminationSpec& spec_;
  const Description& solver_;
  const Property& property_;
};

}  // namespace

void run_examination(const ExaminationSpec& spec) {
  set_instruction_set(harness::instruction_set_named(spec.vectors));
  Examination(spec).run();
}

Examiner::Examiner(const Description& solver, std::string vectors, double time_limit)
    : solver_(solver), vectors_(std::move(vectors)), time_limit_(time_limit) {
  std::error_code error;
  const std::filesystem::path temporary = std::filesystem::temp_directory_path(error);
  std::string name = (temporary / "geodesic-verify-XXXXXX").string();
  if (error || mkdtemp(name.data()) == nullptr) {
    throw harness::HarnessError("cannot make a folder like '" + name +
                                "' for temporary files; set TMPDIR to one that can be written to");
  }
  folder_ = name;
}

Examiner::~Examiner() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

Report Examiner::run(ExaminationSpec spec, double seconds) const {
  const std::filesystem::path file = folder_ / "report.json";
  std::filesystem::remove(file);
  spec.report = file.string();
  seconds = std::min(seconds, time_limit_);
  const harness::Ended ended =
      harness::run_this_program({"examine", Json(spec).dump()}, [] {},
                                {.seconds = seconds, .memory_bytes = harness::available_memory()});
  Report report;
  if (std::filesystem::exists(file)) report = harness::read_json(file).get<Report>();
  if (report.outcome == Outcome::wrong) return report;  // whatever became of the explanation
  if (ended.succeeded() && report.outcome != Outcome::crashed) return report;
  const std::string end = ended.timed_out ? "did not end within " + significant(seconds, 6) + " s"
                                          : "ended the process: " + ended.describe();
  if (report.outcome == Outcome::unjudged) {
    report.what += ' ' + end;
    return report;
  }
  report.outcome = ended.timed_out ? Outcome::timed_out : Outcome::crashed;
  report.what = end;
  report.kind = (ended.crashed ? "signal " : "exit code ") + std::to_string(ended.code);
  return report;
}

Report Examiner::examine(const Property& property) const {
  const std::string missing = unclaimed(property, solver_);
  if (!missing.empty()) return {.outcome = Outcome::unclaimed, .what = missing};
  return run({.solver = solver_.name,
              .property = property.name,
              .mesh_file = {},
              .queries = {},
              .vectors = vectors_,
              .report = {}},
             kInfinity);
}

ExaminationSpec Examiner::on_file(const Property& property, const std::filesystem::path& mesh,
                                  const std::vector<Query>& queries) const {
  return {.solver = solver_.name,
          .property = property.name,
          .mesh_file = mesh.string(),
          .queries = queries,
          .vectors = vectors_,
          .report = {}};
}

ExaminationSpec Examiner::on_case(const Property& property, const Case& given) const {
  const std::filesystem::path mesh = folder_ / "case.obj";
  harness::write_bytes(mesh, mesh_bytes(given.soup, mesh));
  return on_file(property, mesh, given.queries);
}

Report Examiner::examine(const Property& property, const Case& given, double seconds) const {
  return run(on_case(property, given), seconds);
}

Report Examiner::explain(const Property& property, const Case& given) const {
  ExaminationSpec spec = on_case(property, given);
  spec.explain = true;
  return run(spec, kInfinity);
}

Report Examiner::examine_file(const Property& property, const std::filesystem::path& mesh,
                              const std::vector<Query>& queries) const {
  const std::string missing = unclaimed(property, solver_);
  if (!missing.empty()) return {.outcome = Outcome::unclaimed, .what = missing};
  return run(on_file(property, mesh, queries), kInfinity);
}

}  // namespace geodesic::conformance
