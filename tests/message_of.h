// Error messages of calls that are refused.
#pragma once

#include <string>

namespace geodesic {

/// The message of the Error that a call throws, or "nothing was thrown".
template <class Error, class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace geodesic
