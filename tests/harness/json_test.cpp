// JSON input that is refused, and the messages.
#include "harness/base/json.h"

#include "tests/harness/expect_error.h"

namespace geodesic::harness {
namespace {

std::string nested(std::size_t deep) { return std::string(deep, '[') + std::string(deep, ']'); }

std::string object_of(int keys) {
  std::string text = "{";
  for (int i = 0; i < keys; ++i) text += (i == 0 ? "\"" : ",\"") + std::to_string(i) + "\":\"}\"";
  return text + "}";
}

TEST(ParseJson, RefusesNestingThatWouldOverflowTheStack) {
  EXPECT_NO_THROW(parse_json(nested(50), "a.json"));
  expect_error([] { parse_json(nested(51), "a.json"); }, {"a.json: ", "more than 50 deep"});
  expect_error([] { parse_json(nested(1'000'000), "a.json"); }, {"more than 50 deep"});
}

TEST(ParseJson, RefusesObjectsWhoseKeysTakeTheirSquareInTime) {
  EXPECT_EQ(parse_json(object_of(1000), "a.json").size(), 1000u);
  expect_error([] { parse_json(object_of(1001), "a.json"); }, {"more than 1000 keys"});
  expect_error([] { parse_json("[" + object_of(1'000'000) + "]", "a.json"); },
               {"more than 1000 keys"});
}

TEST(ParseJson, BracketsAndColonsInStringsAreText) {
  const std::string text = nested(30) + ":\\\"";
  EXPECT_EQ(parse_json("[\"" + text + "\"]", "a.json").at(0), nested(30) + ":\"");
}

TEST(ParseJson, TakesUtf8WithAByteOrderMarkAndNoUtf16) {
  EXPECT_EQ(parse_json("\xef\xbb\xbf[1]", "a.json").at(0), 1);
  for (const char* mark : {"\xff\xfe", "\xfe\xff"}) {
    expect_error([&] { parse_json(mark + std::string("[1]"), "a.json"); },
                 {"a.json: the text is UTF-16; save it as UTF-8"});
  }
}

TEST(ParseJson, SaysInOneLineWhatIsNoJson) {
  expect_error([] { parse_json("[1e999]", "a.json"); }, {"a.json: not valid JSON", "1e999"});
  expect_error([] { parse_json("[", "a.json"); }, {"a.json: not valid JSON", "line 1, column 2"});
  try {
    parse_json("\x7f\n" + std::string(5000, 'x'), "a.json");
    ADD_FAILURE() << "no error";
  } catch (const HarnessError& error) {
    const std::string message = error.what();
    EXPECT_LT(message.size(), 300u);
    EXPECT_EQ(message.find_first_of("\x7f\n"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace geodesic::harness
