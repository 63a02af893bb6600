// What a user did wrong or must do, in one line; main prints it and exits with 1.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic::harness {

class HarnessError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What was asked for could not be written: the disk is full, or the folder is gone.
class CannotWrite : public HarnessError {
 public:
  using HarnessError::HarnessError;
};

/// Distances that cannot be right; main exits with 2.
class WrongAnswer : public HarnessError {
 public:
  using HarnessError::HarnessError;
};

/// "no solver named 'mpm' (did you mean 'mmp'?); there are: ch, ich, mmp"
/// @param kind what the name should have been: "solver", "mesh", "key of a suite"
std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known);

/// A message, or a name in it, as it may be shown on any terminal and stored in any result file:
/// control characters (ESC, a line end, ...) and bytes that are no UTF-8 are spelt out in
/// hexadecimal digits. What a file says can then neither move the cursor nor pass for a line of the
/// program.
std::string harmless(std::string_view text);

/// The same of text of any length: cut off after 200 bytes.
std::string excerpt(std::string_view text);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

}  // namespace geodesic::harness
