#include "harness/verify/finding.h"

#include <algorithm>
#include <cctype>

namespace geodesic::conformance {

std::string without_numbers(const std::string& text) {
  std::string kept;
  bool in_number = false;
  for (const char c : text) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (digit && !in_number) kept += '#';
    in_number = digit || (in_number && std::string_view(".e+-").find(c) != std::string::npos);
    if (!in_number) kept += c;
  }
  return kept;
}

Finding in(const std::string& circumstances, Finding finding) {
  if (!finding) return finding;
  finding->what = circumstances + ": " + finding->what;
  if (!finding->kind.empty()) finding->kind = circumstances + ", " + finding->kind;
  return finding;
}

Finding require(bool holds, const std::string& otherwise) {
  if (holds) return {};
  return Failure{.what = otherwise};
}

std::string kind_of(const Failure& failure, const Mesh& mesh) {
  if (failure.kind.empty()) return without_numbers(failure.what);
  const std::string kind = without_numbers(failure.kind);
  if (failure.vertex >= mesh.vertex_count()) return kind;
  return kind + ", at: " + role_of(failure.vertex, mesh, failure.query);
}

std::string role_of(Index v, const Mesh& mesh, const Query& query) {
  const auto is_v = [v](const Source& source) { return source.vertex == v; };
  if (std::ranges::any_of(query.sources, is_v)) return "source";
  if (mesh.outgoing(v).empty()) return "isolated vertex";
  if (mesh.is_boundary(v)) return "boundary vertex";
  return mesh.is_pseudo_source(v) ? "saddle vertex" : "ordinary vertex";
}

}  // namespace geodesic::conformance
