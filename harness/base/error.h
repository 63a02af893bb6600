// What a user did wrong or must do, in one line; main prints it and exits with 1.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "meshes/messages.h"

namespace geodesic::harness {

class HarnessError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A result could not be written: the disk is full, or the folder is gone.
class CannotWrite : public HarnessError {
 public:
  using HarnessError::HarnessError;
  CannotWrite(const std::filesystem::path& file, const std::string& why)
      : HarnessError("cannot write '" + file.string() + "': " + why) {}
};

/// Distances that cannot be right; main exits with 2.
class WrongAnswer : public HarnessError {
 public:
  using HarnessError::HarnessError;
};

/// Does something; its errors get a place in front: "mesh horse: sha256: ...".
template <class Action>
void at_place(const std::string& place, const Action& action) {
  try {
    action();
  } catch (const HarnessError& error) {
    throw HarnessError(excerpt(place) + ": " + error.what());
  }
}

/// The item of a list that has a name.
/// @param kind what the name should have been: "solver"
/// @param name_of an item's name, as std::ranges::find takes it
/// @throws HarnessError listing the known names
template <class Items, class NameOf = std::identity>
auto& named(std::string_view kind, Items& items, std::string_view name, NameOf name_of = {}) {
  const auto at = std::ranges::find(items, name, name_of);
  if (at != std::ranges::end(items)) return *at;
  std::vector<std::string> known;
  known.reserve(std::ranges::size(items));
  for (const auto& item : items) known.emplace_back(std::invoke(name_of, item));
  throw HarnessError(unknown_name(kind, name, known));
}

}  // namespace geodesic::harness
