#include "harness/cells/pictured.h"

#include <algorithm>
#include <array>
#include <utility>

#include "harness/base/error.h"

namespace geodesic::harness {
namespace {

constexpr std::array<std::pair<const char*, Pictured>, 3> kWords{
    {{"none", Pictured::none}, {"auto", Pictured::automatic}, {"all", Pictured::all}}};

}  // namespace

Pictured pictured_named(const std::string& word) {
  std::vector<std::string> known;
  for (const auto& [name, pictured] : kWords) {
    if (word == name) return pictured;
    known.emplace_back(name);
  }
  throw HarnessError(unknown_name("choice of recordings", word, known));
}

std::string name_of(Pictured wish) {
  return std::ranges::find(kWords, wish, &std::pair<const char*, Pictured>::second)->first;
}

bool is_pictured(const Cell& cell, Pictured wish) {
  if (!cell.is_first()) return false;
  if (wish != Pictured::automatic) return wish == Pictured::all;
  const PlannedMesh& mesh = *cell.mesh;
  return cell.solver->exactness == Exactness::exact && cell.source == mesh.sources.front() &&
         mesh.vertices >= kLeastPictured && mesh.vertices <= kMostPictured;
}

}  // namespace geodesic::harness
