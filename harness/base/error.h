// Errors that a user can correct, as one line of text. main prints it and exits with 1.
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

/// Runs an action and puts a place in front of its error messages: "mesh horse: sha256: ...".
template <class Action>
void at_place(const std::string& place, const Action& action) {
  try {
    action();
  } catch (const HarnessError& error) {
    throw HarnessError(excerpt(place) + ": " + error.what());
  }
}

/// Finds the item of a list by its name.
/// @param kind noun for the name in the message: "solver"
/// @param name_of projection from an item to its name, as for std::ranges::find
/// @throws HarnessError that lists the known names
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
