#include "harness/verify/reproduce.h"

#include <algorithm>
#include <functional>
#include <iostream>

#include "harness/base/files.h"
#include "harness/base/plugins.h"
#include "harness/corpus/solvers.h"
#include "harness/verify/saved_case.h"
#include "harness/verify/shrink.h"
#include "meshes/messages.h"

namespace geodesic::harness {
namespace {

// Seconds for a smaller case. kLoop is for cases that do not end: each attempt takes all of it.
constexpr double kAttempt = 10;
constexpr double kLoop = 2;

Case shrunk(const IsolatedCheck& check, const FailedProperty& failed, double seconds) {
  const bool timed_out = failed.result.outcome == CheckOutcome::timed_out;
  const double attempt = std::min(check.time_limit(), timed_out ? kLoop : kAttempt);
  const auto fails_within = [&](const Case& smaller, double limit) {
    return check.on_case(*failed.property, smaller, limit).fails_like(failed.result);
  };
  Case smallest = shrink(
      failed.given, failed.result.query,
      [&](const Case& smaller) { return fails_within(smaller, attempt); }, seconds);
  // A case that takes longer than an attempt may still end.
  const bool in_doubt = timed_out && attempt < check.time_limit();
  return in_doubt && !fails_within(smallest, kInfinity) ? failed.given : smallest;
}

void print_explanation(const CheckResult& result) {
  for (const std::string& line : result.explanation) std::cout << "  " << line << '\n';
  std::cout.flush();
}

}  // namespace

void FailureReport::show(const IsolatedCheck& check, const FailedProperty& failed) {
  std::cout << '\n' << failed.name << '\n';
  const Property& property = *failed.property;
  const bool has_faces = !failed.given.soup.triangles.empty();
  if (!(seconds_ > 0)) {
    if (failed.result.outcome != CheckOutcome::wrong || !has_faces) return;
    return print_explanation(check.on_case(property, failed.given, kInfinity, true));
  }
  CheckResult result = failed.result;
  std::vector<std::string> again = {"verify", "--solver", check.solver().name, "--property",
                                    property.name};
  if (check.vectors() != kAutoVectors) again.insert(again.end(), {"--vectors", check.vectors()});
  if (has_faces) {
    const bool on_any_mesh = property.on_any_mesh;
    const Case few = on_any_mesh ? shrunk(check, failed, seconds_) : failed.given;
    const std::filesystem::path file = unused_file(failed);
    make_folder(folder_, "; --out names another");
    if (on_any_mesh) {
      write_case({check.solver().name, property.name, check.vectors(), few}, file);
    } else {
      write_mesh(few, mesh_beside(file));
    }
    std::cout << "  smallest case  " << mesh_beside(file).string() << ": "
              << few.soup.positions.size() << " vertices and " << few.soup.triangles.size()
              << " faces of the " << failed.given.soup.positions.size() << " and "
              << failed.given.soup.triangles.size() << " of '" << failed.given.mesh << "'\n";
    // The case of a property's own may have distances in closed form, which no file has.
    const CheckResult saved = check.on_case(property, few, kInfinity, true);
    if (on_any_mesh && (saved.failed() || !failed.own)) {
      again = {"verify", "--file", file.string()};
      if (!saved.failed()) {
        std::cout << "                 (when tried, it did not fail again: the answer may change "
                     "from one solve to the next)\n";
      }
    }
    if (saved.failed()) result = saved;
  }
  if (result.outcome == CheckOutcome::timed_out) {
    again.insert(again.end(), {"--time-limit", significant(check.time_limit(), 6)});
  }
  std::cout << "  fails there    " << result.what << '\n'
            << "  reproduce it   " << as_command_line(again) << '\n';
  print_explanation(result);
}

// Meshes of different folders may have the same name. Files of earlier calls are overwritten.
std::filesystem::path FailureReport::unused_file(const FailedProperty& failed) {
  // "distances-equal-the-reference-on-hill"
  std::string stem = failed.property->name + "-on-" + failed.given.mesh;
  std::ranges::replace_if(stem, std::not_fn(is_plain), '-');
  std::filesystem::path file = folder_ / (stem + ".json");
  for (int i = 2; !written_.insert(file).second; ++i) {
    file = folder_ / (stem + '-' + std::to_string(i) + ".json");
  }
  return file;
}

}  // namespace geodesic::harness
