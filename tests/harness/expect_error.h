#pragma once

#include "harness/base/error.h"
#include "tests/harness/expect_words.h"

namespace geodesic::harness {

/// Expects that the call throws a HarnessError or a MeshError whose message contains all the words.
template <class Call>
void expect_error(Call call, const std::vector<std::string>& words) {
  try {
    call();
    ADD_FAILURE() << "no error; its message should contain: " << join(words);
  } catch (const HarnessError& error) {
    expect_words(error.what(), words);
  } catch (const MeshError& error) {
    expect_words(error.what(), words);
  }
}

}  // namespace geodesic::harness
