#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/base/error.h"

namespace geodesic::harness {

/// The call must throw a HarnessError or a MeshError whose message contains all the words.
template <class Call>
void expect_error(Call call, const std::vector<std::string>& words) {
  const auto check = [&](const std::exception& error) {
    for (const std::string& word : words) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << "'" << word << "' is missing in: " << error.what();
    }
  };
  try {
    call();
    ADD_FAILURE() << "no error; its message should contain: " << join(words);
  } catch (const HarnessError& error) {
    check(error);
  } catch (const MeshError& error) {
    check(error);
  }
}

}  // namespace geodesic::harness
