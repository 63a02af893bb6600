// A ranking as people, papers and programs read it.
#pragma once

#include <string>

#include "harness/rank/ranking.h"

namespace geodesic::harness {

/// One or two sentences: the candidate's times against each rival, and whose distances are wrong.
std::string verdict(const Ranking& ranking, const Measurements& measurements);

/// rank.md: the verdict, the ranking, remarks, and a table a mesh. A difference in time that is not
/// resolved is "~".
std::string as_markdown(const Ranking& ranking, const Measurements& measurements);

/// rank.tex: the ranking and the ratios on every mesh as tables, and rank.pdf as a figure, to be
/// included in a paper that uses the packages booktabs and graphicx.
std::string as_latex(const Ranking& ranking, const Measurements& measurements);

/// `ranking` of rank.json (results/README.md).
Json to_json(const Ranking& ranking, const Measurements& measurements);

}  // namespace geodesic::harness
