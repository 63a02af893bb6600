// Messages: names, lists and numbers as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geodesic {

/// "no solver named 'mpm' (did you mean 'mmp'?); there are: ch, ich, mmp", or "the nearest of 80:"
/// and the eight nearest, where a list of all would be too long to read.
/// @param kind what the name should have been: "solver", "mesh", "key"
std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known);

/// A message, or a name in it, as it may be shown on any terminal and stored in any result file:
/// control characters (ESC, a line end, ...) and bytes that are not UTF-8 become
/// hexadecimal digits, so that the content of a file can neither move the cursor nor imitate a line
/// of the program.
std::string harmless(std::string_view text);

/// The same of text of any length: cut off after `longest` bytes.
std::string excerpt(std::string_view text, std::size_t longest = 200);

/// A number to so many significant digits; 17 bring the same double back.
std::string significant(double x, int digits = 17);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

}  // namespace geodesic
