#include "harness/rank/measurements.h"

#include <algorithm>

#include "harness/results/row.h"

namespace geodesic::harness {
namespace {

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::vector<double> PairedTimes::ratios() const {
  std::vector<double> ratios(candidate_ms.size());
  std::transform(candidate_ms.begin(), candidate_ms.end(), rival_ms.begin(), ratios.begin(),
                 [](double above, double below) { return above / below; });
  return ratios;
}

const Json* MeasuredMesh::failure(const std::string& solver) const {
  for (const MeasuredSource& source : sources) {
    for (const Json& row : source.rows) {
      if (row.at("solver") == solver && row.at("outcome") != outcome::kOk) return &row;
    }
  }
  return nullptr;
}

std::vector<double> MeasuredMesh::numbers(const std::string& solver, const std::string& key) const {
  std::vector<double> values;
  for (const MeasuredSource& source : sources) {
    for (const Json& row : source.rows) {
      if (row.at("solver") == solver && row.contains(key)) values.push_back(row.at(key));
    }
  }
  if (values.size() < sources.size()) values.clear();
  return values;
}

std::optional<PairedTimes> MeasuredMesh::times(const std::string& rival) const {
  PairedTimes all{.rival = rival};
  for (const MeasuredSource& source : sources) {
    const auto here = std::find_if(source.pairs.begin(), source.pairs.end(),
                                   [&](const PairedTimes& pairs) { return pairs.rival == rival; });
    if (here == source.pairs.end()) return std::nullopt;
    append(all.candidate_ms, here->candidate_ms);
    append(all.rival_ms, here->rival_ms);
  }
  return all;
}

}  // namespace geodesic::harness
