// Messages: names, lists and numbers as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geodesic {

/// "no solver named 'mpm' (did you mean 'mmp'?); there are: ch, ich, mmp". A long list is replaced
/// by "the nearest of 80:" and the eight nearest names.
/// @param kind kind of name: "solver", "mesh", "key"
std::string unknown_name(std::string_view kind, std::string_view name,
                         const std::vector<std::string>& known);

/// Escapes a message or name, so that any terminal can show it and any result file can store it:
/// control characters (ESC, a line end, ...) and bytes that are not UTF-8 become hexadecimal
/// digits. The content of a file can then neither move the cursor nor imitate a line of the
/// program.
std::string harmless(std::string_view text);

/// As `harmless`, for text of any length: cut off after `longest` bytes.
std::string excerpt(std::string_view text, std::size_t longest = 200);

/// A number with `digits` significant digits; 17 digits reproduce the same double.
std::string significant(double x, int digits = 17);

/// "a, b, c"
std::string join(const std::vector<std::string>& words, std::string_view separator = ", ");

}  // namespace geodesic
