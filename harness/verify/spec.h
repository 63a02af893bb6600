// What the process that examines a solver is told, and what it leaves, as JSON.
#pragma once

#include <string>
#include <vector>

#include "harness/base/json.h"
#include "solvers/core/solver.h"

namespace geodesic::conformance {

struct ExaminationSpec {
  std::string solver, property;
  std::string mesh_file;       ///< empty: the property's own cases
  std::vector<Query> queries;  ///< to ask on the mesh file
  std::string vectors;         ///< corpus/vectors.h
  bool explain = false;        ///< a failure on the mesh file (explain.h)
  std::string report;          ///< file to write
};
void to_json(harness::Json& json, const ExaminationSpec& spec);
void from_json(const harness::Json& json, ExaminationSpec& spec);

enum class Outcome : std::uint8_t {
  holds,
  unclaimed,  ///< does not concern the solver
  unjudged,   ///< the right distances could not be had
  wrong,
  crashed,
  timed_out
};

struct Report {
  Outcome outcome = Outcome::crashed;  ///< what it is until something else is known
  std::string what = {};               ///< one line; empty when it holds
  std::string kind = {};               ///< of a failure, as Failure::kind
  std::size_t at_case = 0;  ///< of the property's own cases: the one that was examined last
  Query query = {};         ///< answered wrongly; without sources when no single one was
  std::vector<std::string> explanation = {};  ///< lines

  bool failed() const { return outcome >= Outcome::wrong; }
  bool fails_like(const Report& other) const {
    return failed() && outcome == other.outcome && kind == other.kind;
  }
};
void to_json(harness::Json& json, const Report& report);
void from_json(const harness::Json& json, Report& report);

}  // namespace geodesic::conformance
