// What a refused call says.
#pragma once

#include <string>

namespace geodesic {

/// The message of the Error that a call throws; "nothing was thrown" when it throws none.
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
