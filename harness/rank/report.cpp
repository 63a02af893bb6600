#include "harness/rank/report.h"

#include <algorithm>

#include "harness/base/error.h"
#include "harness/results/row.h"
#include "harness/results/text_table.h"

namespace geodesic::harness {
namespace {

constexpr const char* kNothing = "-";
constexpr const char* kUndecided = "~";

std::string show_ratio(double value) { return number(value, value < 10 ? "%.3f" : "%.1f"); }

std::string show(const TimeRatio& time) {
  return time.resolved() ? show_ratio(time.ratio.value) : kUndecided;
}

std::string range(double low, double high) { return show_ratio(low) + " to " + show_ratio(high); }

std::string with_interval(const TimeRatio& time) {
  return show(time) + " (" + range(time.ratio.low, time.ratio.high) + ")";
}

std::string show_error(const std::optional<double>& error) {
  return error ? number(*error, "%.1e") : kNothing;
}

std::string count(std::size_t n, const std::string& what, const std::string& plural) {
  return std::to_string(n) + ' ' + (n == 1 ? what : plural);
}

std::string meshes(std::size_t n) { return count(n, "mesh", "meshes"); }

// "takes 0.8 (0.7 to 0.9) of mmp's time over 10 meshes, ~ (0.9 to 1.1) of ich's over 9 meshes"
std::string times_in_words(const Ranking& ranking) {
  std::string text;
  std::size_t over = 0;
  for (const Standing& standing : ranking.standings) {
    if (!standing.time) continue;
    text += (text.empty() ? " takes " : ", ") + with_interval(*standing.time) + " of " +
            standing.solver + "'s" + (over == 0 ? " time" : "");
    if (standing.meshes.size() != over) text += " over " + meshes(standing.meshes.size());
    over = standing.meshes.size();
  }
  return text.empty() ? " could be timed against none of its rivals" : text;
}

// Solvers with a wrong answer somewhere, in the order of the ranking.
std::vector<std::string> wrong_solvers(const Ranking& ranking, const Measurements& measurements) {
  std::vector<std::string> names;
  for (const Standing& standing : ranking.standings) {
    if (std::any_of(measurements.meshes.begin(), measurements.meshes.end(), [&](const auto& mesh) {
          const Json* row = mesh.failure(standing.solver);
          return row != nullptr && row->at("outcome") == outcome::kWrongAnswer;
        })) {
      names.push_back(standing.solver);
    }
  }
  return names;
}

TextTable overall_table(const Ranking& ranking) {
  TextTable table{
      {"solver", "rank", "time", "95% interval", "windows", "memory", "largest error", "right on"}};
  std::size_t place = 0;
  for (const Standing& standing : ranking.standings) {
    const bool candidate = standing.solver == ranking.candidate && standing.right > 0;
    const std::string itself = candidate ? "1" : kNothing;
    const bool ranked = candidate || standing.time;
    table.push_back(
        {standing.solver, ranked ? std::to_string(++place) : kNothing,
         standing.time ? show(*standing.time) : itself,
         standing.time ? range(standing.time->ratio.low, standing.time->ratio.high) : kNothing,
         standing.windows ? show_ratio(*standing.windows) : itself,
         standing.memory ? show_ratio(*standing.memory) : itself,
         show_error(standing.max_relative_error),
         std::to_string(standing.right) + " of " + std::to_string(standing.all)});
  }
  return table;
}

const MeshRatios* ratios_on(const Standing& standing, const MeasuredMesh& mesh) {
  const auto at = std::find_if(standing.meshes.begin(), standing.meshes.end(),
                               [&](const MeshRatios& ratios) { return ratios.mesh == mesh.mesh; });
  return at == standing.meshes.end() ? nullptr : &*at;
}

// Of the solver's sources: a number's median, or "-".
std::string typical(const MeasuredMesh& mesh, const std::string& solver, const std::string& key,
                    double unit, const char* pattern) {
  const std::vector<double> values = mesh.numbers(solver, key);
  return values.empty() ? kNothing : number(median(values) / unit, pattern);
}

std::string milliseconds(const Standing& standing, const MeasuredMesh& mesh,
                         const std::string& candidate) {
  if (const MeshRatios* ratios = ratios_on(standing, mesh)) return number(ratios->rival_ms);
  std::vector<double> times;
  for (const MeasuredSource& source : mesh.sources) {
    for (const PairedTimes& pairs : source.pairs) {
      times.insert(times.end(), pairs.candidate_ms.begin(), pairs.candidate_ms.end());
    }
  }
  return standing.solver != candidate || times.empty() ? kNothing : number(median(times));
}

TextTable mesh_table(const MeasuredMesh& mesh, const Ranking& ranking) {
  TextTable table{
      {"solver", "ms", "time", "95% interval", "range", "windows", "peak MB", "largest error"}};
  for (const Standing& standing : ranking.standings) {
    if (const Json* failed = mesh.failure(standing.solver)) {
      table.push_back({standing.solver, failed->at("outcome"), kNothing, kNothing, kNothing,
                       kNothing, kNothing, kNothing});
      continue;
    }
    const MeshRatios* ratios = ratios_on(standing, mesh);
    const std::vector<double> errors = mesh.numbers(standing.solver, "max_relative_error");
    table.push_back(
        {standing.solver, milliseconds(standing, mesh, ranking.candidate),
         ratios ? show(ratios->time) : kNothing,
         ratios ? range(ratios->time.ratio.low, ratios->time.ratio.high) : kNothing,
         ratios ? range(ratios->least, ratios->most) : kNothing,
         typical(mesh, standing.solver, "window_propagations", 1, "%.0f"),
         typical(mesh, standing.solver, "solver_peak_bytes", 1e6, "%.2f"),
         errors.empty() ? kNothing : show_error(*std::max_element(errors.begin(), errors.end()))});
  }
  return table;
}

// A row a mesh, a column a rival.
TextTable ratio_table(const Ranking& ranking, const Measurements& measurements) {
  TextTable table{{"mesh", "vertices"}};
  std::vector<const Standing*> rivals;
  for (const Standing& standing : ranking.standings) {
    if (standing.solver == ranking.candidate) continue;
    rivals.push_back(&standing);
    table.front().push_back(standing.solver);
  }
  for (const MeasuredMesh& mesh : measurements.meshes) {
    std::vector<std::string> row{mesh.mesh, std::to_string(mesh.vertices)};
    for (const Standing* rival : rivals) {
      const MeshRatios* ratios = ratios_on(*rival, mesh);
      row.push_back(ratios ? with_interval(ratios->time) : kNothing);
    }
    table.push_back(row);
  }
  return table;
}

std::string what_ratios_are(const std::string& candidate) {
  return "Ratios are " + candidate + "'s numbers over the solver's: below 1 " + candidate +
         " takes less. Times are CPU time of a solve, taken by turns in pairs; ~ is a difference "
         "that they do not resolve.";
}

Json optional(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json to_json(const TimeRatio& time) {
  return {{"value", time.ratio.value},
          {"low", time.ratio.low},
          {"high", time.ratio.high},
          {"pairs", time.pairs},
          {"resolved", time.resolved()}};
}

Json to_json(const Standing& standing) {
  Json json{{"solver", standing.solver},
            {"time", standing.time ? to_json(*standing.time) : Json(nullptr)},
            {"windows", optional(standing.windows)},
            {"memory", optional(standing.memory)},
            {"max_relative_error", optional(standing.max_relative_error)},
            {"right", standing.right},
            {"all", standing.all},
            {"meshes", Json::array()}};
  for (const MeshRatios& mesh : standing.meshes) {
    json["meshes"].push_back({{"mesh", mesh.mesh},
                              {"time", to_json(mesh.time)},
                              {"least", mesh.least},
                              {"most", mesh.most},
                              {"windows", optional(mesh.windows)},
                              {"memory", optional(mesh.memory)}});
  }
  return json;
}

Json pairs_to_json(const Measurements& measurements) {
  Json json = Json::array();
  for (const MeasuredMesh& mesh : measurements.meshes) {
    for (const MeasuredSource& source : mesh.sources) {
      for (const PairedTimes& pairs : source.pairs) {
        json.push_back({{"mesh", mesh.mesh},
                        {"source", source.source},
                        {"rival", pairs.rival},
                        {"candidate_ms", pairs.candidate_ms},
                        {"rival_ms", pairs.rival_ms}});
      }
    }
  }
  return json;
}

std::string latex_table(const TextTable& table, const std::string& caption) {
  return "\\begin{table}\n\\centering\\small\n\\caption{" + escape_latex(caption) + "}\n" +
         as_latex(table) + "\\end{table}\n";
}

}  // namespace

std::string verdict(const Ranking& ranking, const Measurements& measurements) {
  const std::vector<std::string> wrong = wrong_solvers(ranking, measurements);
  const Standing& candidate = ranking.of_candidate();
  std::string text;
  if (!wrong.empty()) text += "WRONG ANSWERS of " + join(wrong) + ", see the remarks. ";
  text += ranking.candidate + times_in_words(ranking) + ". Its distances are right on " +
          std::to_string(candidate.right) + " of " + meshes(candidate.all);
  if (candidate.max_relative_error) {
    text += ", to " + show_error(candidate.max_relative_error) + " of their length";
  }
  return text + ".";
}

std::string as_markdown(const Ranking& ranking, const Measurements& measurements) {
  std::string text = "# " + ranking.candidate + " against " + join(measurements.rivals) + "\n\n" +
                     verdict(ranking, measurements) + "\n\n" + as_markdown(overall_table(ranking)) +
                     "\n" + what_ratios_are(ranking.candidate) + "\n";
  if (!ranking.remarks.empty()) text += '\n';
  for (const std::string& remark : ranking.remarks) text += "- " + remark + '\n';
  for (const MeasuredMesh& mesh : measurements.meshes) {
    text += "\n## " + mesh.mesh + ", " + std::to_string(mesh.vertices) + " vertices, " +
            count(mesh.sources.size(), "source", "sources") + "\n\n" +
            as_markdown(mesh_table(mesh, ranking));
  }
  return text;
}

std::string as_latex(const Ranking& ranking, const Measurements& measurements) {
  const std::string& candidate = ranking.candidate;
  return "% \\input this file; needs \\usepackage{booktabs,graphicx}\n" +
         latex_table(overall_table(ranking),
                     verdict(ranking, measurements) + " " + what_ratios_are(candidate)) +
         '\n' +
         latex_table(ratio_table(ranking, measurements),
                     "Time of " + candidate +
                         " over that of the solver in the column, on every mesh: median of "
                         "pairs, with its 95% interval.") +
         "\n\\IfFileExists{rank.pdf}{%\n\\begin{figure}\n\\centering\n\\includegraphics{rank.pdf}\n"
         "\\caption{" +
         escape_latex("Time of " + candidate +
                      " over each rival's: medians of pairs on every mesh with their 95% "
                      "intervals, thin lines from the least to the most of the pairs, and "
                      "geometric means over the meshes. Left of 1 " +
                      candidate + " is faster; hollow marks are not resolved.") +
         "}\n\\end{figure}}{}\n";
}

Json to_json(const Ranking& ranking, const Measurements& measurements) {
  Json json{{"candidate", ranking.candidate},
            {"verdict", verdict(ranking, measurements)},
            {"standings", Json::array()},
            {"pairs", pairs_to_json(measurements)},
            {"unfinished", measurements.unfinished},
            {"remarks", ranking.remarks}};
  for (const Standing& standing : ranking.standings) {
    json["standings"].push_back(to_json(standing));
  }
  return json;
}

}  // namespace geodesic::harness
