#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace geodesic::harness {

/// Expects that the text contains all the words.
inline void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' is missing in: " << text;
  }
}

}  // namespace geodesic::harness
