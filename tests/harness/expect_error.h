#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/base/error.h"

namespace geodesic::harness {

/// The call must throw a HarnessError whose message contains all the words.
template <class Call>
void expect_error(Call call, const std::vector<std::string>& words) {
  try {
    call();
    ADD_FAILURE() << "no error; its message should contain: " << join(words);
  } catch (const HarnessError& error) {
    for (const std::string& word : words) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << "'" << word << "' is missing in: " << error.what();
    }
  }
}

}  // namespace geodesic::harness
