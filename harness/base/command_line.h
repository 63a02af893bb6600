// Commands that a message tells the user to run.
#pragma once

#include <string>
#include <vector>

namespace geodesic::harness {

/// As one line for a shell, with this program as it was called and its plug-ins in front.
std::string as_command_line(const std::vector<std::string>& arguments);

}  // namespace geodesic::harness
